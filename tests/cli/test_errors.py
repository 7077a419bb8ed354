# SPDX-License-Identifier: Apache-2.0
"""Bad input: exit code 2, one line that says what is accepted, nothing half-written."""

import os
import unittest

from support import CliTest

SAMPLE = ("sample", "--count", "4")

# Arguments, and what the message must mention.
BAD_INPUT = (
    ((), "sample, verify, tables, "),
    (("nonsense",), "'nonsense'"),
    (("--nonsense",), "--nonsense"),
    (("info", "extra"), "'extra' is an argument too many"),
    (("sample", "--nonsense=3"), "sample has no option '--nonsense'; sample --help lists them"),
    (("analyze", "--nonsense", "4"), "analyze has no option '--nonsense'"),
    (("sample",), "--count"),
    (("sample", "--count"), "--count needs a value"),
    (("sample", "--count", "0"), "from 1"),
    (("sample", "--count", "-1"), "from 1"),
    (("sample", "--count=-1"), "from 1"),
    (("sample", "--count", "1e99"), "4294967296"),
    (("sample", "--count", "1.5"), "whole number"),
    (("sample", "--count", "4x"), "whole number"),
    (("sample", "--count", " 4"), "whole number"),
    (("sample", "--count", ""), "whole number"),
    (("sample", "--count", "0x"), "whole number"),
    (("sample", "--count", "4294967297"), "4294967296"),
    (("sample", "--count", "99999999999999999999"), "4294967296"),
    ((*SAMPLE, "--count", "5"), "--count may be given once, not 2 times"),
    ((*SAMPLE, "-o", "a.csv", "-o", "b.csv"), "--output may be given once, not 2 times"),
    ((*SAMPLE, "-o", "a.foo"), ".csv, .txt, .npy, .json"),
    ((*SAMPLE, "--dims", "0"), "from 1 to 3"),
    ((*SAMPLE, "--dims", "4"), "from 1 to 3"),
    ((*SAMPLE, "--first", "4294967293"), "2^32"),
    ((*SAMPLE, "--first", "-1"), "--first"),
    ((*SAMPLE, "--pattern", "0x100000000"), "4294967295"),
    ((*SAMPLE, "--pattern", "-1"), "4294967295"),
    ((*SAMPLE, "--pattern", "zebra"), "'zebra'"),
    ((*SAMPLE, "--generator", "sobol"), "pmj, random, long, blue, joint"),
    ((*SAMPLE, "--generator", "long:3+7"), "are for study, analyze and report; here it is 'long'"),
    ((*SAMPLE, "--generator", "a\nb\x1b[31m"), r"'a\nb\x1b[31m'"),
    ((*SAMPLE, "--format", "xml"), "csv"),
    ((*SAMPLE, "--nonsense"), "--nonsense"),
    ((*SAMPLE, "extra"), "extra"),
    ((*SAMPLE, "-o", ""), "''"),
    ((*SAMPLE, "-o", "."), "directory"),
    ((*SAMPLE, "-o", "missing/points.csv"), "missing/points.csv"),
    ((*SAMPLE, "-o", "file/points.csv"), "file/points.csv"),
    ((*SAMPLE, "-o", "x" * 300), "too long"),
    ((*SAMPLE, "--plot", "plot.gif"), ".png, .svg, .pdf"),
    ((*SAMPLE, "--plot", "png"), ".png, .svg, .pdf"),
    ((*SAMPLE, "--plot", ".png"), ".png, .svg, .pdf"),
    ((*SAMPLE, "--plot", "a\nb"), r"'a\nb'"),
    ((*SAMPLE, "--plot", "missing/plot.png"), "missing/plot.png"),
    ((*SAMPLE, "--plot", "directory.png"), "directory"),
    ((*SAMPLE, "-o", "new.csv", "--plot", "missing/plot.png"), "missing/plot.png"),
    ((*SAMPLE, "-o", "same.png", "--format", "csv", "--plot", "same.png"), "two outputs"),
    ((*SAMPLE, "-o", "a.dat", "--format", "csv", "--plot", "a.png", "--keep-plot-files"), "two outputs"),
    (("sample", "--count", "65537", "--plot", "plot.png"), "65536"),
    ((*SAMPLE, "--keep-plot-files"), "--plot"),
    ((*SAMPLE, "--compare", "random,pmj"), "--plot"),
    ((*SAMPLE, "--compare", "random,sobol", "--plot", "plot.png"), "pmj, random"),
    ((*SAMPLE, "--compare", "pmj,pmj,pmj,pmj,pmj", "--plot", "plot.png"), "at most 4"),
    ((*SAMPLE, "--compare", "pmj", "--plot", "plot.png", "-o", "new.csv"), "--output"),
    ((*SAMPLE, "--compare", "pmj", "--plot", "plot.png", "--generator", "pmj"), "--generator"),
    (("tables",), "--export"),
    (("tables", "--export", "tables.txt"), ".npy, .h, .bin"),
    (("tables", "--export", "missing/tables.npy"), "missing/tables.npy"),
    (("tables", "--export", "tables.npy", "--type", "double"), "float32"),
    (("tables", "--export", "tables.bin", "--layout", "y"), "words, xy"),
    (("tables", "--export", "tables.bin", "--layout", ""), "words, xy"),
    (("tables", "--export", "tables.h", "--layout", "xy"), ".npy, .bin"),
    (("tables", "--export", "a.bin", "--layout", "xy", "--type", "uint32"), "--type"),
    (("verify", "--tables", "5..2"), "383"),
    (("verify", "--tables", "400"), "383"),
    (("verify", "--tables", "0..384"), "383"),
    (("verify", "--tables", "0..-1"), "383"),
    (("verify", "--tables", ".."), "A..B"),
    (("verify", "--tables", "1..2..3"), "A..B"),
    (("verify", "--tables", ""), "all"),
    (("verify", "--patterns", "-1"), "--patterns"),
    (("verify", "--patterns", "1e99"), "--patterns"),
)


class ErrorTest(CliTest):
    def setUp(self):
        super().setUp()
        with open(self.path("file"), "wb") as file:
            file.write(b"content")

    def files(self):
        return sorted(set(os.listdir(self.directory)) - {"directory.png"})

    def test_bad_input(self):
        os.mkdir(self.path("directory.png"))
        for arguments, mention in BAD_INPUT:
            with self.subTest(arguments=arguments):
                self.assert_fails(*arguments, mentions=mention)

    def test_missing_gnuplot(self):
        for path in ("", self.directory):
            self.assert_fails(*SAMPLE, "-o", "new.csv", "--plot", "plot.png", "--keep-plot-files",
                              env={**os.environ, "PATH": path}, mentions="gnuplot")

    def test_failing_gnuplot(self):
        """Guards against taking a picture from a gnuplot that stopped or wrote none."""
        for script, mention in (("echo 'no terminal'; exit 3", "no terminal"), ("exit 0", "no")):
            os.makedirs(self.path("directory.png"), exist_ok=True)
            fake = self.path("directory.png/gnuplot")
            with open(fake, "w", encoding="ascii") as file:
                file.write("#!/bin/sh\n" + script + "\n")
            os.chmod(fake, 0o755)
            self.assert_fails(*SAMPLE, "--plot", "plot.png", mentions=mention,
                              env={**os.environ, "PATH": os.path.dirname(fake)})

    @unittest.skipIf(os.geteuid() == 0, "root may write anywhere")
    def test_unwritable_directory(self):
        os.mkdir(self.path("directory.png"), 0o555)
        self.assert_fails(*SAMPLE, "-o", "directory.png/points.csv", mentions="directory.png")


if __name__ == "__main__":
    unittest.main()
