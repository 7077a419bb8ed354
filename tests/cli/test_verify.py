# SPDX-License-Identifier: Apache-2.0
"""`wellstrat verify`. That it finds violations is shown by tests/mutants."""

import json
import os
import unittest

from support import CliTest

SHORT = ("verify", "--tables", "0..3", "--patterns", "5")


class VerifyTest(CliTest):
    def test_certificate(self):
        text = self.output_of(*SHORT).decode()
        subjects = dict(part.split(":\n", 1) for part in text.split("\n\n")[1:-1])
        for subject in ("4 tables, m = 0..12, every aligned block",
                        "13 patterns, 3 of 48 blocks, m = 0..12, every aligned block",
                        "22 patterns of long, 2 blocks of 4096, m = 0..12, every aligned block",
                        "4096 samples of a pixel of 22 tiles of blue, m = 0..12, every aligned block"):
            self.assertRegex(subjects[subject], r"(?m)^  \(x, y\): \(0,m,2\)-net in .* \d+  ok$")
        self.assertRegex(text, r"(?m)^  \(x, y\) of 2\^k samples of 2\^a x 2\^a pixels: .* \d+  ok$")
        self.assertLessEqual(max(map(len, text.splitlines())), 100)
        self.assertRegex(text, r"\n\d+ intervals checked, all promises hold\n\Z")
        self.assertNotIn("VIOLATED", text)

    def test_json(self):
        certificate = json.loads(self.output_of(*SHORT, "--json"))
        self.assertTrue(certificate["passed"])
        self.assertEqual(certificate["version"], os.environ["WELLSTRAT_VERSION"])
        self.assertEqual(certificate["tables"], [0, 3])
        self.assertEqual(certificate["patterns"], 5)
        self.assertGreaterEqual(certificate["stream_version"], 1)
        self.assertGreater(len(certificate["lines"]), 8)
        for line in certificate["lines"]:
            self.assertTrue(line["promise"] and line["subject"])
            self.assertGreater(line["intervals"], 0)
            self.assertEqual((line["violations"], line["first_violation"]), (0, ""))

    def test_more_tables_are_more_intervals(self):
        def intervals(tables):
            run = self.output_of("verify", "--tables", tables, "--patterns", "0", "--json")
            return sum(line["intervals"] for line in json.loads(run)["lines"])
        self.assertGreater(intervals("0..3"), intervals("383..383"))

    def test_progress_is_for_terminals(self):
        shown, output = self.on_terminal(*SHORT)
        for part in ("tables", "patterns", "long", "blue"):
            self.assertIn(f"checking {part}:", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"))
        self.assertEqual(output, self.output_of(*SHORT))


if __name__ == "__main__":
    unittest.main()
