# SPDX-License-Identifier: Apache-2.0
"""`wellstrat bank`."""

import os
import pathlib
import re
import unittest

from support import CliTest

HEADER = pathlib.Path(__file__).parents[2] / "include" / "wellstrat" / "joint_bank.h"
ROW = re.compile(r"(?m)^ +\{(0x[^}]*)\},$")


def columns_of(header):
    """The columns of each slot."""
    return [[int(column, 16) for column in row.split(",")] for row in ROW.findall(header)]


class BankTest(CliTest):
    def test_header_is_what_the_search_prints(self):
        rows = columns_of(HEADER.read_text())
        self.assertEqual(len(rows), 16)
        found = columns_of(self.output_of("bank", "--slots", "4").decode())
        self.assertEqual(found, [row[:12] for row in rows[:4]])

    @unittest.skipUnless(os.environ.get("WELLSTRAT_NIGHTLY") == "1", "takes minutes")
    def test_whole_header(self):
        found = columns_of(self.output_of("bank").decode())
        self.assertEqual(found, [row[:12] for row in columns_of(HEADER.read_text())])

    def test_options_of_the_search(self):
        few = ("bank", "--slots", "3", "--rounds", "1")
        first = self.output_of(*few)
        self.assertIn(b"kJointBank[3][12]", first)
        self.assertEqual(first, self.output_of(*few, "-o", "bank.h") or self.read("bank.h"))

    def test_judge(self):
        lines = self.output_of("bank", "--judge", "--integrands", "disk,gaussian").decode()
        rows = dict.fromkeys(line.split()[0] for line in lines.splitlines())
        self.assertEqual(list(rows), ["integrand^2", "disk", "worst", "bound", "gaussian", "all"])
        worst = [float(x) for x in re.search(r"all.*\n +worst +(.*)", lines).group(1).split()]
        mean = [float(x) for x in re.search(r"all +mean +(.*)", lines).group(1).split()]
        self.assertEqual(len(mean), 11)
        self.assertTrue(all(m <= w for m, w in zip(mean, worst)))
        self.assertLess(mean[-1], 0.5)

    def test_errors(self):
        self.assert_fails("bank", "--slots", "1", mentions="2")
        self.assert_fails("bank", "--judge", "--integrands", "nonsense", mentions="nonsense")
        self.assert_fails("bank", "--judge", "--integrands", "disk^2", mentions="2D")
        self.assert_fails("bank", "--integrands", "disk", mentions="--judge")
        self.assert_fails("bank", "--judge", "--seed", "3", mentions="--seed")
        self.assert_fails("bank", "-o", "no/such/folder", mentions="folder")


if __name__ == "__main__":
    unittest.main()
