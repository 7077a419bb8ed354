# SPDX-License-Identifier: Apache-2.0
"""The points that `wellstrat study` takes from files and from other libraries."""

import csv
import io
import math
import random
import struct
import unittest

from support import CliTest
from test_analyze import npy, pack

PATTERNS, POINTS, DIMS = 5, 8, 3


def study_rows(data):
    return {(row["generator"], row["integrand"], int(row["points"])): row
            for row in csv.DictReader(io.StringIO(data.decode()))}


class FileTest(CliTest):
    def setUp(self):
        super().setUp()
        engine = random.Random(1)
        # Multiples of 2^-20, which both types hold.
        self.points = [[[engine.randrange(1 << 20) / (1 << 20) for _ in range(DIMS)]
                        for _ in range(POINTS)] for _ in range(PATTERNS)]

    def values(self):
        return [value for pattern in self.points for point in pattern for value in point]

    def fortran_values(self):
        return [self.points[p][i][d]
                for d in range(DIMS) for i in range(POINTS) for p in range(PATTERNS)]

    def write(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data)

    def study(self, name, patterns=PATTERNS, integrands="linear,bilinear,trilinear", counts="4,8"):
        return ("study", "--generators", f"file:{name}", "--integrands", integrands, "--counts",
                counts, "--patterns", str(patterns), "-o", "-")

    def assert_right(self, name):
        """Guards against patterns, points or coordinates taken from the wrong place."""
        found = study_rows(self.output_of(*self.study(name)))
        for dims, integrand in enumerate(("linear", "bilinear", "trilinear"), 1):
            for count in (4, 8):
                errors = [sum(math.prod(point[:dims]) for point in pattern[:count]) / count
                          - 0.5**dims for pattern in self.points]
                row = found[f"file:{name}", integrand, count]
                rmse = math.sqrt(sum(error**2 for error in errors) / PATTERNS)
                self.assertAlmostEqual(float(row["rmse"]), rmse, delta=1e-12)
                self.assertAlmostEqual(float(row["bias"]), sum(errors) / PATTERNS, delta=1e-12)

    def test_three_axes_are_patterns(self):
        shape = f"({PATTERNS}, {POINTS}, {DIMS})"
        for name, data in (
                ("a.npy", npy("<f8", shape, pack("<d", self.values()))),
                ("big.npy", npy(">f8", shape, pack(">d", self.values()))),
                ("single.npy", npy("<f4", shape, pack("<f", self.values()))),
                ("fortran.npy", npy("<f8", shape, pack("<d", self.fortran_values()), "True"))):
            self.write(name, data)
            self.assert_right(name)

    def test_refusals(self):
        data = pack("<d", self.values())
        self.write("a.npy", npy("<f8", f"({PATTERNS}, {POINTS}, {DIMS})", data))
        kept = self.study("a.npy")
        for arguments in (self.study("a.npy", patterns=PATTERNS + 1),
                          self.study("a.npy", counts="9"),
                          self.study("a.npy", integrands="disk^2")):
            self.assert_fails(*arguments, mentions="5 patterns of 8 points in 3 dimensions")
        self.output_of(*kept)
        many = 1 << 40
        for shape, content, mentions in (
                ("(1, 5, 8, 3)", data, "4 axes; accepted are one"),
                ("(5, 8, 65)", data, "65 dimensions"),
                ("(5, 9, 3)", data, "has 120 numbers, where its header says 135"),
                ("(4, 8, 3)", data, "has 120 numbers, where its header says 96"),
                ("(0, 8, 3)", b"", "no points"),
                ("(5, 0, 3)", b"", "no points"),
                (f"({many}, {many}, 3)", data, "more than 1048576 points"),
                (f"({many}, 1, 3)", data, "more than 11184810 points"),
                ("(1000, 12000, 3)", data, "more than 11184810 points"),
                ("(5, 8, 3)", data[:-8] + struct.pack("<d", 1), "point 39: 1 is not in [0, 1)")):
            self.write("a.npy", npy("<f8", shape, content))
            self.assert_fails(*kept, mentions=mentions)


class JointTest(CliTest):
    def errors(self, generators):
        return study_rows(self.output_of(
            "study", "--generators", generators, "--integrands", "disk,gaussian^2", "--counts",
            "256", "--patterns", "200", "-o", "-"))

    def test_slots_are_better_together_and_as_good_alone(self):
        """Guards against slots that are drawn as padded domains, which would be level, with 7
        percent of noise: slots have a tenth to a quarter of the error in the product."""
        table = self.errors("pmj,long,joint,joint:3+7,long:3+7")
        for name, padded in (("joint", "pmj"), ("joint:3+7", "pmj"), ("long:3+7", "long")):
            ratio = [float(table[name, integrand, 256]["rmse"]) /
                     float(table[padded, integrand, 256]["rmse"])
                     for integrand in ("gaussian^2", "disk")]
            self.assertLess(ratio[0], 0.6)
            self.assertLess(abs(ratio[1] - 1), 0.3)

    def test_without_slots_the_first_are_meant(self):
        table = self.errors("joint,joint:0+1,joint:0x1+2")
        for integrand in ("disk", "gaussian^2"):
            rmse = [table[name, integrand, 256]["rmse"]
                    for name in ("joint", "joint:0+1", "joint:0x1+2")]
            self.assertEqual(rmse[0], rmse[1])
            self.assertNotEqual(rmse[0], rmse[2])

    def test_analyze(self):
        text = self.output_of("analyze", "--generator", "joint:5", "--count", "256").decode()
        self.assertIn("joint:5, pattern 0: 256 points", text)

    def test_refusals(self):
        for slots, mentions in (("16", "'16' is no slot"), ("x", "'x' is no slot"),
                                ("", "there is no slot"), ("3+3", "slot 3 comes twice"),
                                ("1++2", "'' is no slot")):
            for arguments in (("study", "--generators", f"joint:{slots}"),
                              ("analyze", "--count", "16", "--generator", f"joint:{slots}")):
                self.assert_fails(*arguments, mentions=mentions)


class LibrariesTest(CliTest):
    """GSL, Boost and we mean the same by Sobol'. Guards against comparisons with points that lack
    the origin, and against a rival that is set up wrongly."""

    PLANE = "linear,gaussian,triangle,checkerboard-8,edges,sines,boxes"

    def errors(self, counts, integrands):
        listed = self.output_of("study", "--list").decode()
        names = [name for name in ("gsl-sobol", "boost-sobol") if f"  {name} " in listed]
        if not names:
            self.skipTest("built without GSL and Boost")
        table = study_rows(self.output_of(
            "study", "--generators", ",".join(["sobol", *names]), "--integrands", integrands,
            "--counts", counts, "--patterns", "1", "-o", "-"))
        return names, table

    def assert_same(self, table, first, second):
        """Integrals, but for rounding: the order of points, and so that of sums, differs."""
        compared = 0
        for (generator, integrand, count), row in table.items():
            if generator == first:
                other = table[second, integrand, count]
                self.assertAlmostEqual(float(row["bias"]), float(other["bias"]), delta=1e-12,
                                       msg=(second, integrand, count))
                compared += 1
        self.assertGreater(compared, 100)

    def test_plane(self):
        """The first 2^m points are the same set; in between Gray code makes another order."""
        names, table = self.errors("pow2:1..4096", self.PLANE)
        for name in names:
            self.assert_same(table, "sobol", name)

    def test_libraries_have_the_same_order(self):
        names, table = self.errors("all:1..100", self.PLANE)
        if len(names) < 2:
            self.skipTest("built without GSL or Boost")
        self.assert_same(table, *names)

    def test_space(self):
        """Boost has the direction numbers of Joe and Kuo, as we; GSL has older ones."""
        names, table = self.errors("pow2:1..4096", "3d,box-3d-1,box-3d-2,sine-3d-1,sine-3d-8")
        if "boost-sobol" not in names:
            self.skipTest("built without Boost")
        self.assert_same(table, "sobol", "boost-sobol")


if __name__ == "__main__":
    unittest.main()
