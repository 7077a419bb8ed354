# SPDX-License-Identifier: Apache-2.0
"""`wellstrat bank`."""

import os
import pathlib
import re
import unittest

from support import CliTest

HEADER = pathlib.Path(__file__).parents[2] / "include" / "wellstrat" / "joint_bank.h"
ROW = re.compile(r"(?m)^ +\{(0x[^}]*)\},$")


def without_rows(header):
    """The header but for its columns and the number of slots."""
    return re.sub(r"kJointBank\[\d+\]", "kJointBank[]", re.sub(ROW.pattern + r"\n", "", header))


class BankTest(CliTest):
    def test_format_of_the_header(self):
        printed = self.output_of("bank", "--slots", "2", "--width", "1").decode()
        header = HEADER.read_text()
        self.assertEqual(len(ROW.findall(header)), 16)
        self.assertEqual(without_rows(printed), without_rows(header))
        self.assertEqual(ROW.findall(printed)[0], ROW.findall(header)[0]) # line breaks, and slot 0

    @unittest.skipUnless(os.environ.get("WELLSTRAT_NIGHTLY") == "1", "takes minutes")
    def test_header_is_what_the_search_prints(self):
        self.assertEqual(self.output_of("bank", timeout=1800).decode(), HEADER.read_text())

    def test_options_of_the_search(self):
        few = ("bank", "--slots", "3", "--width", "1")
        first = self.output_of(*few)
        self.assertIn(b"kJointBank[3][kJointBankDigits]", first)
        self.assertEqual(first, self.output_of(*few, "-o", "bank.h") or self.read("bank.h"))

    def test_judge(self):
        lines = self.output_of("bank", "--judge", "--slots", "4", "--integrands",
                               "disk,linear*gaussian").decode()
        names = [line[:24].strip() for line in lines.splitlines() if line[:24].strip()]
        self.assertEqual(names, ["product", "disk^2", "linear*gaussian", "all"])
        worst = [float(x) for x in re.search(r"all.*\n +worst +(.*)", lines).group(1).split()]
        mean = [float(x) for x in re.search(r"all +mean +(.*)", lines).group(1).split()]
        pairs = re.search(r"all.*\n.*\n +pair +(.*)", lines).group(1).split()
        self.assertEqual(len(mean), 15)
        self.assertTrue(all(m <= w for m, w in zip(mean, worst)))
        self.assertTrue(all(re.fullmatch("[0-3]-[0-3]", pair) for pair in pairs))
        self.assertLess(mean[-1], 0.5)

    def test_errors(self):
        self.assert_fails("bank", "--slots", "1", mentions="2")
        self.assert_fails("bank", "--judge", "--integrands", "nonsense", mentions="nonsense")
        self.assert_fails("bank", "--judge", "--integrands", "disk^2", mentions="one domain")
        self.assert_fails("bank", "--integrands", "disk", mentions="--judge")
        self.assert_fails("bank", "--judge", "--seed", "3", mentions="--seed")
        self.assert_fails("bank", "-o", "no/such/folder", mentions="folder")


if __name__ == "__main__":
    unittest.main()
