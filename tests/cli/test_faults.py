# SPDX-License-Identifier: Apache-2.0
"""Each write, open, rename and allocation of short runs fails once: exit code 2 and one line, or a
finished result; never a half file, a hang or a crash.

$WELLSTRAT_FAULT_LIBRARY lets calls fail. Of each kind some $WELLSTRAT_FAULTS are tried, spread over
all that a run makes, and all of them if that is 0. scripts/test --nightly tries many."""

import os
import shutil
import subprocess
import unittest

from support import PROGRAM, RENDER_PROGRAM, CliTest
from test_plot import png_size

LIBRARY = os.environ.get("WELLSTRAT_FAULT_LIBRARY")
MOST = int(os.environ.get("WELLSTRAT_FAULTS", "24"))
KINDS = ("write", "open", "rename", "memory")


def chosen(count):
    """Numbers from 1 to `count`: the first ones, then ever fewer, and the last one."""
    if MOST == 0 or count <= MOST:
        return list(range(1, count + 1))
    ratio = count ** (1 / (MOST - 1))
    return sorted({round(ratio ** i) for i in range(MOST)} | {count})


@unittest.skipUnless(LIBRARY, "built without the library of faults")
class FaultTest(CliTest):
    def run_with_fault(self, command, kind, number):
        environment = {**os.environ, "LD_PRELOAD": LIBRARY, "WELLSTRAT_FAULT": f"{kind}:{number}",
                       "WELLSTRAT_FAULT_COUNT": self.path("count")}
        # One thread, as far as that goes, so that calls have the same numbers in each run.
        cpus = {min(os.sched_getaffinity(0))}
        return subprocess.run(command, cwd=self.directory, stdin=subprocess.DEVNULL,
                              capture_output=True, timeout=100, check=False, env=environment,
                              preexec_fn=lambda: os.sched_setaffinity(0, cpus))

    def calls(self, command, kind):
        """How many calls of a kind a run without faults makes."""
        process = self.run_with_fault(command, kind, 0)
        self.assertEqual((process.returncode, process.stderr), (0, b""), command)
        count = int(self.read("count"))
        os.remove(self.path("count"))
        return count

    def remove_all(self, keep):
        for name in self.files():
            if name not in keep:
                os.remove(self.path(name))

    def check(self, *command, isWhole=lambda name, data: False):
        """`command` writes files; isWhole(name, data) says of one that is not the same as without
        faults whether it is a result nevertheless."""
        keep = self.files()
        for kind in KINDS:
            count = self.calls(command, kind)
            whole = {name: self.read(name) for name in self.files() if name not in keep}
            self.remove_all(keep)
            for number in chosen(count):
                with self.subTest(command=command, kind=kind, number=number, of=count):
                    process = self.run_with_fault(command, kind, number)
                    text = process.stderr.decode()
                    files = {name: self.read(name) for name in self.files() if name not in keep}
                    self.remove_all(keep)
                    self.assertIn(process.returncode, (0, 2), text)
                    self.assertRegex(text, r"\A(wellstrat: [^\n]+\n)?\Z")
                    if process.returncode == 2:
                        self.assertTrue(text or kind == "write")
                    else:
                        self.assertEqual(set(files), set(whole) if not text else set(files))
                    for name, data in files.items():
                        self.assertIn(name, whole)
                        self.assertTrue(data == whole[name] or isWhole(name, data), name)

    def test_study(self):
        self.check(PROGRAM, "study", "--generators", "pmj", "--integrands", "disk", "--counts",
                   "4,16", "--patterns", "4", "-o", "r.csv")

    def test_analyze(self):
        self.output_of("sample", "--count", "16", "-o", "points.csv")
        self.check(PROGRAM, "analyze", "points.csv", "--json")

    @unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
    def test_plot(self):
        self.check(PROGRAM, "sample", "--count", "4", "--plot", "a.svg", "--keep-plot-files")

    @unittest.skipUnless(RENDER_PROGRAM, "built without the renderer")
    def test_render(self):
        def isPicture(name, data):
            return name == "a.png" and png_size(data) == (8, 8)
        self.check(RENDER_PROGRAM, "render", "cornell", "--size", "8x8", "--spp", "2",
                   "--checkpoint", "part.exr", "--save-every", "0", "-o", "a.png",
                   isWhole=lambda name, data: name == "part.exr" or isPicture(name, data))


if __name__ == "__main__":
    unittest.main()
