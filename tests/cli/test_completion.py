# SPDX-License-Identifier: Apache-2.0
"""What bash completes after `wellstrat`."""

import pathlib
import shutil
import subprocess
import unittest

from support import PROGRAM, CliTest
from test_help import OPTIONS, SUBCOMMANDS

SCRIPT = pathlib.Path(__file__).parents[2] / "tools" / "completion" / "wellstrat.bash"

# Calls the function that bash would call for these words, the last of which is to be completed.
COMPLETE = """
source "$1"
shift
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_wellstrat
printf '%s\\n' "${COMPREPLY[@]}"
"""


@unittest.skipUnless(shutil.which("bash"), "needs bash")
class CompletionTest(CliTest):
    def completed(self, *words):
        """What bash offers, in the order of --help."""
        done = subprocess.run(
            ["bash", "-euc", COMPLETE, "bash", SCRIPT, PROGRAM, *words], cwd=self.directory,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            timeout=60, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""), words)
        return done.stdout.split()

    def test_subcommands(self):
        offered = self.completed("")
        for name in SUBCOMMANDS:
            self.assertIn(name, offered)
        self.assertEqual(self.completed("ver"), ["verify"])
        self.assertEqual(self.completed("--"), ["--version", "--help"])

    def test_options_of_each_subcommand(self):
        for name in SUBCOMMANDS:
            offered = self.completed(name, "-")
            for option in OPTIONS[name]:
                if option.startswith("-"):
                    self.assertIn(option, offered, name)
        self.assertEqual(self.completed("sample", "--co"), ["--count", "--compare"])
        self.assertEqual(self.completed("sample", "--count", "4", "--di"), ["--dims"])

    def test_files_are_left_to_bash(self):
        self.assertEqual(self.completed("analyze", "poi"), [])
        self.assertEqual(self.completed("sample", "-o", ""), [])


if __name__ == "__main__":
    unittest.main()
