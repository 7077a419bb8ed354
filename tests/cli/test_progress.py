# SPDX-License-Identifier: Apache-2.0
"""Progress of everything that may take more than two seconds."""

import unittest

from support import CliTest


class ProgressTest(CliTest):
    def test_bars_on_terminals(self):
        for label, *arguments in (
                ("samples", "sample", "--count", "100000", "-o", "a.csv"),
                ("samples", "sample", "--count", "100000", "-o", "a.npy"),
                ("tables", "tables", "--export", "a.bin"),
                ("measures", "analyze", "--generator", "pmj", "--count", "4096")):
            shown, _ = self.on_terminal(*arguments)
            self.assertRegex(shown, rf"^\r{label} \[#*\.*\] +\d+ %", arguments)
            self.assertTrue(shown.endswith("\r\x1b[K"), arguments)

    def test_results_are_free_of_them(self):
        arguments = ("sample", "--count", "20000")
        shown, output = self.on_terminal(*arguments)
        self.assertIn("samples [", shown)
        self.assertEqual(output, self.output_of(*arguments))
        self.assertNotIn("samples [", self.on_terminal(*arguments, stdout=None)[0])


if __name__ == "__main__":
    unittest.main()
