# SPDX-License-Identifier: Apache-2.0
"""`wellstrat ranks`."""

import os
import pathlib
import re
import unittest

from support import CliTest

HEADER = pathlib.Path(__file__).parents[2] / "include" / "wellstrat" / "blue_tables.h"
RANK = HEADER.with_name("rank.h")
SLOT = re.compile(r"(?m)^ +\{0x[^}]*\},\n")
SHORT = ("ranks", "--sweeps", "1", "--rounds", "0", "--slots", "2")


def form_of(text):
    """The text with all ranks alike and without the rows of slots."""
    text = SLOT.sub("", text).replace("kRankBank[16]", "kRankBank[2]")
    return re.sub(r"(?m)^    \d.*,$", lambda row: re.sub(r"\d+, *", "rank, ", row.group()), text)


def numbers(text, name):
    return [int(x) for x in re.search(rf"{name}\[4096\] = \{{([^}}]*)\}}", text).group(1)
            .replace("\n", "").split(",") if x.strip()]


class RanksTest(CliTest):
    def test_short_search_has_the_form_of_the_header(self):
        text = self.output_of(*SHORT).decode()
        self.assertEqual(form_of(text), form_of(HEADER.read_text()))
        self.assertEqual(len(SLOT.findall(text)), 2)
        for name in ("kRankTilePadded", "kRankTileSlots"):
            self.assertEqual(sorted(numbers(text, name)), list(range(4096)))
        self.assertEqual(text, self.output_of(*SHORT, "-o", "blue.h").decode() or
                         self.read("blue.h").decode())
        self.assertNotEqual(text, self.output_of(*SHORT, "--seed", "3").decode())

    @unittest.skipUnless(os.environ.get("WELLSTRAT_NIGHTLY") == "1", "takes minutes")
    def test_whole_header(self):
        self.assertEqual(self.output_of("ranks", timeout=1800).decode(), HEADER.read_text())

    def test_z_is_that_of_the_library(self):
        columns = re.findall(r"0x[0-9a-f]{8}", self.output_of("ranks", "--z").decode())
        self.assertEqual(len(columns), 12)
        matrix = re.search(r"kRankZ = \{\{([^}]*)\}\}", RANK.read_text()).group(1)
        self.assertEqual(re.findall(r"0x[0-9a-f]+", matrix), columns)

    def test_judge(self):
        lines = self.output_of("ranks", "--judge", "--slots", "2").decode().splitlines()
        self.assertEqual(lines[0].split(), ["1", "2", "4", "8", "16", "32", "64"])
        ratios = {(line[:7].strip(), line[8:23].strip(), line[24:29].strip()):
                  [float(x) for x in line[29:].split()] for line in lines[1:]}
        self.assertTrue(all(len(row) == 7 for row in ratios.values()))
        for what, model in (("padded", "smooth"), ("slot", "smooth"), ("padded", "step of x")):
            self.assertLess(max(ratios[what, model, "mean"]), 0.5, (what, model))
        self.assertLess(max(ratios["pair", "smooth x smooth", "mean"]), 0.6)

    def test_errors(self):
        self.assert_fails("ranks", "--slots", "1", mentions="2")
        self.assert_fails("ranks", "--slots", "17", mentions="16")
        self.assert_fails("ranks", "--judge", "--sweeps", "3", mentions="--sweeps")
        self.assert_fails("ranks", "--z", "--rounds", "1", mentions="--rounds")
        self.assert_fails("ranks", "--sweeps", "many", mentions="many")
        self.assert_fails("ranks", "-o", "no/such/folder", mentions="folder")


if __name__ == "__main__":
    unittest.main()
