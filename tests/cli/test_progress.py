# SPDX-License-Identifier: Apache-2.0
"""Progress of everything that may take more than two seconds."""

import os
import subprocess
import threading
import unittest

from support import CliTest, PROGRAM


class ProgressTest(CliTest):
    def on_terminal(self, *arguments, stdout=subprocess.PIPE):
        """(What a terminal shows of the standard error, the standard output.)"""
        controller, terminal = self.open_terminal()
        shown = []

        def read():
            try:
                while data := os.read(controller, 4096):
                    shown.append(data)
            except OSError:
                pass  # as Linux says that the other end is closed

        reader = threading.Thread(target=read)
        reader.start()
        process = subprocess.run([PROGRAM, *arguments], cwd=self.directory, stderr=terminal,
                                 stdout=terminal if stdout is None else stdout, check=True,
                                 timeout=100)
        os.close(terminal)
        reader.join()
        os.close(controller)
        return b"".join(shown).decode(), process.stdout

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
