# SPDX-License-Identifier: Apache-2.0
"""scripts/abi sees that the layout of a class changes, and asks for a record of a new version."""

import platform
import shutil
import unittest

from support import TreeTest


@unittest.skipUnless(shutil.which("abidiff"), "needs abigail-tools")
class Abi(TreeTest):
    COPIED = ("CMakeLists.txt", "LICENSE", "cmake", "include", "packaging", "src", "scripts",
              "abi")

    def test_changes_are_seen(self):
        shutil.rmtree(self.tree / "abi" / platform.machine(), ignore_errors=True)
        self.replace("scripts/abi", "-DWELLSTRAT_BUILD_ANALYSIS=ON ", "") # two libraries are enough
        code, output = self.run_script("abi")
        self.assertEqual((code, output.splitlines()[-1].split(":")[-1].strip()),
                         (2, "scripts/abi --record"))
        code, output = self.run_script("abi", "--record")
        self.assertEqual(code, 0, output)
        self.assertIn("/libwellstrat.so.", output)
        if platform.machine() == "x86_64":
            self.assertEqual(self.run_script("debian-symbols"), (0, ""))
        self.assertEqual(self.run_script("abi"), (0, ""))

        self.replace("include/wellstrat/domain_finding.h", "    SampleCtx path;",
                     "    SampleCtx path;\n    std::string more;")
        code, output = self.run_script("abi")
        self.assertEqual(code, 1, output)
        self.assertIn("DomainFinding", output)
        self.assertRegex(output, r"libwellstrat-debug\.so\S* differs from its record")

        self.replace("CMakeLists.txt", "VERSION 0.", "VERSION 7.")
        code, output = self.run_script("abi")
        self.assertEqual(code, 2, output)
        self.assertRegex(output, r"there is no abi/\S+/libwellstrat-debug\.so\.7\.xml")
