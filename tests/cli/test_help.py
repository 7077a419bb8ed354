# SPDX-License-Identifier: Apache-2.0
"""Help, versions and `wellstrat info`."""

import json
import os
import pathlib
import re
import shlex
import unittest

from support import RENDER_PROGRAM, CliTest

DEBIAN = pathlib.Path(__file__).parents[2] / "packaging" / "debian"
RENDERING = ("render", "merge", "compare", "domains")
SUBCOMMANDS = ("sample", "verify", "tables", "analyze", "info", "study", "report", "bank", "ranks",
               *(RENDERING if RENDER_PROGRAM else ()))
OPTIONS = {
    "sample": ("--dims", "--count", "--first", "--pattern", "--generator", "--format", "-o",
               "--plot", "--compare", "--keep-plot-files"),
    "verify": ("--tables", "--patterns", "--json"),
    "tables": ("--export", "--type"),
    "analyze": ("FILE", "--generator", "--count", "--dims", "--pattern", "--realizations",
                "--format", "--type", "--scale", "--domains", "--no-nets", "--no-star", "--no-l2",
                "--no-distances", "--no-pairs", "--no-spectra", "--no-independence", "--json",
                "--plot", "--keep-plot-files"),
    "info": ("--json",),
    "study": ("--list", "--generators", "--integrands", "--counts", "--patterns", "--filter",
              "--window", "--table", "--fit-from", "-o", "--plot", "--keep-plot-files", "--resume",
              "--save-every"),
    "report": ("-o", "--generators", "--integrands", "--patterns", "--count", "--quick",
               "--thorough", "--bench", "--keep-plot-files"),
    "bank": ("--seed", "--width", "--slots", "--judge", "--integrands", "-o"),
    "ranks": ("--seed", "--sweeps", "--rounds", "--slots", "--z", "--judge", "-o"),
    "render": ("-o", "--spp", "--generator", "--size", "--depth", "--split", "--distrib",
               "--time-limit", "--threads", "--seed", "--samples", "--checkpoint", "--save-every",
               "--resume", "--noise", "--environment",
               "--environment-rotation", "--environment-strength", "--studio", "--exposure",
               "--tonemap", "--transparent", "--camera", "--look-at", "--up", "--fov",
               "--lens-radius", "--focus", "--frame", "--frames", "--orbit", "--list"),
    "merge": ("-o", "--exposure", "--tonemap"),
    "compare": ("-o", "--generators", "--spp", "--filter", "--mask", "--reference", "--reference-spp", "--seeds", "--size",
                "--keep-plot-files"),
    "domains": ("-o", "--generators", "--spp", "--seeds", "--size", "--depth"),
}


class HelpTest(CliTest):
    def help_of(self, *arguments):
        return self.output_of(*arguments, "--help").decode()

    def examples_in(self, text):
        lines = text.partition("Examples:\n")[2].partition("\n\n")[0].splitlines()
        return [shlex.split(line.partition(">")[0])[1:] for line in lines]

    def test_top_names_every_subcommand(self):
        text = self.help_of()
        for name in SUBCOMMANDS:
            self.assertRegex(text, rf"(?m)^  {name} +\S")

    def test_every_subcommand_has_a_manual_page_in_the_packages(self):
        listed = self.help_of().partition("Subcommands:\n")[2].partition("\n\n")[0]
        pages = "".join(path.read_text() for path in DEBIAN.glob("*.manpages"))
        self.assertEqual(sorted(re.findall(r"wellstrat-(\w+)\.1", pages)),
                         sorted(re.findall(r"(?m)^  (\w+)", listed)))

    def test_every_option_is_listed(self):
        for name in SUBCOMMANDS:
            text = self.help_of(name)
            for option in OPTIONS[name]:
                self.assertRegex(text, rf"(?m)^  {option}\b.*\S")

    def test_lines_fit(self):
        for arguments in ((), *((name,) for name in SUBCOMMANDS)):
            for line in self.help_of(*arguments).splitlines():
                self.assertLessEqual(len(line), 100)

    def test_examples_run(self):
        """Guards against examples that the options have left behind."""
        for name, dims in (("pixel-0", 2), ("pixel-1", 2), ("paths", 5)):
            with open(self.path(name + ".csv"), "w", encoding="ascii") as file:
                file.write("".join(",".join(["0.25"] * dims) + "\n" for _ in range(8)))
        for name in SUBCOMMANDS:
            examples = self.examples_in(self.help_of(name))
            self.assertTrue(examples, name)
            if name in RENDERING:
                continue  # takes long
            for example in examples:
                self.assertEqual(example[0], name)
                if "--plot" in example or name == "report" or (
                        name == "verify" and "--tables" not in example) or (
                            name in ("bank", "ranks") and ("-o" in example or
                                                           example[-1] == "--judge")):
                    continue  # needs gnuplot, which other tests do; or takes long
                self.output_of(*example)

    def test_version(self):
        version = os.environ["WELLSTRAT_VERSION"]
        line = self.output_of("--version").decode()
        self.assertRegex(line, rf"\Awellstrat {version}, stream version \d+\n\Z")


class InfoTest(CliTest):
    def test_json(self):
        info = json.loads(self.output_of("info", "--json"))
        self.assertEqual(info["version"], os.environ["WELLSTRAT_VERSION"])
        self.assertGreaterEqual(info["stream_version"], 1)
        tables = info["tables"]
        self.assertEqual((tables["count"], tables["points_per_table"]), (384, 4096))
        self.assertEqual(info["stratified_samples_per_pattern"], 48 * 4096)
        self.assertLessEqual(tables["bytes"], 19 << 20)
        self.assertGreater(tables["build_ms"], 0)
        self.assertTrue(info["compiler"])

    def test_text(self):
        text = self.output_of("info").decode()
        for part in ("stream version", "compiler", "384", "4096", "MiB", "ms", "196608"):
            self.assertIn(part, text)


if __name__ == "__main__":
    unittest.main()
