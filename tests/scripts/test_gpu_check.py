# SPDX-License-Identifier: Apache-2.0
"""scripts/gpu-check reports what its programs find, with programs that stand for CUDA's and a GPU."""

import os
import unittest

from support import TreeTest

PROGRAM = "#!/bin/sh\n"


class GpuCheck(TreeTest):
    COPIED = ("scripts",)

    def setUp(self):
        super().setUp()
        self.programs = self.tree / "programs"
        (self.tree / "build/gpu").mkdir(parents=True)
        self.program("programs/nvcc", "echo nvcc 1.0")
        self.program("programs/cmake", 'echo "cmake $*"')
        self.program("scripts/bench", "echo counted")
        self.program("build/gpu/found", "")
        self.program("build/gpu/gpu_check", 'echo "asked for $2"')
        self.program("build/gpu/area_light", 'echo P6 > "$1"')
        path = os.environ["PATH"]
        self.addCleanup(os.environ.__setitem__, "PATH", path)
        os.environ["PATH"] = f"{self.programs}:/usr/bin:/bin"

    def program(self, name, text):
        path = self.tree / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(PROGRAM + text + "\n")
        path.chmod(0o755)

    def test_all_agree(self):
        report = self.tree / "a folder/report"
        code, output = self.run_script("gpu-check", "--contexts", "18", "--report", report)
        self.assertEqual(code, 0, output)
        self.assertRegex(output, r"(?s)^nvcc 1.0\n.*built in .*\nasked for 18\ncounted\n")
        self.assertEqual((report / "gpu-check.txt").read_text(), output)
        self.assertTrue((report / "area_light.ppm").exists())

    def assert_difference_is_told(self, name):
        self.program(f"build/gpu/{name}", "echo DIFFERS; exit 1")
        code, output = self.run_script("gpu-check")
        self.assertEqual(code, 1)
        self.assertIn("DIFFERS", output)

    def test_samples_that_differ(self):
        self.assert_difference_is_told("gpu_check")

    def test_a_picture_that_differs(self):
        self.assert_difference_is_told("area_light")

    def test_a_difference_counts_more_than_what_cannot_be_tried(self):
        self.program("build/gpu/area_light", "echo no memory; exit 2")
        self.assertEqual(self.run_script("gpu-check")[0], 2)
        self.assert_difference_is_told("gpu_check")

    def test_no_gpu(self):
        self.program("build/gpu/found", "exit 1")
        self.program("programs/cmake", "touch built")
        self.assertEqual(self.run_script("gpu-check"), (
            2, "gpu-check: there is no GPU that CUDA can use, so nothing is checked\n"))
        self.assertFalse((self.tree / "built").exists())

    def test_a_compiler_that_does_not_compile(self):
        self.program("programs/nvcc", "echo unsupported compiler; exit 1")
        self.assertEqual(self.run_script("gpu-check"), (
            2, "unsupported compiler\ngpu-check: nvcc does not compile\n"))

    def test_the_sanitizer_is_heard(self):
        for said, expected in (("ERROR SUMMARY: 0 errors", 0), ("ERROR SUMMARY: 2 errors", 1),
                               ("Device not supported", 0)):
            with self.subTest(said):
                self.program("programs/compute-sanitizer", f"echo '========= {said}'")
                self.assertEqual(self.run_script("gpu-check")[0], expected)

    def test_a_build_that_fails(self):
        self.program("programs/cmake", "echo no such target; exit 1")
        code, output = self.run_script("gpu-check")
        self.assertEqual(code, 2)
        self.assertIn("no such target", output)

    def test_bad_input(self):
        for arguments, message in (
                (("--contexts", "1e9"), "gpu-check: --contexts takes a number from 1, not '1e9'\n"),
                (("--contexts",), "gpu-check: --contexts needs a value\n"),
                (("--gpu", "1"), "gpu-check: knows only --contexts N and --report FOLDER, not "
                                 "'--gpu'\n")):
            self.assertEqual(self.run_script("gpu-check", *arguments), (2, message))


if __name__ == "__main__":
    unittest.main()
