# SPDX-License-Identifier: Apache-2.0
"""`wellstrat sample`: the values and their file formats."""

import json
import unittest

from support import CliTest, floats, read_csv, read_npy, to_float

STRATIFIED = 48 * 4096  # samples of a pattern


class SampleTest(CliTest):
    def csv(self, *arguments):
        return read_csv(self.output_of("sample", *arguments))

    def npy(self, *arguments):
        return read_npy(self.output_of("sample", "--format", "npy", *arguments))

    def test_formats_hold_equal_values(self):
        for dims in (1, 2, 3):
            for generator in ("pmj", "random", "joint", "long", "blue"):
                arguments = ("--dims", str(dims), "--count", "1000", "--pattern", "0xDEADBEEF",
                             "--first", "4000", "--generator", generator)
                rows = self.csv(*arguments)
                kind, shape, data = self.npy(*arguments)
                points = json.loads(self.output_of("sample", "--format", "json", *arguments))
                self.assertEqual((kind, shape), ("<f4", (1000, dims)))
                flat = [value for row in rows for value in row]
                self.assertEqual(list(floats(data)), flat)
                self.assertTrue(all(len(row) == dims for row in rows))
                self.assertTrue(all(len(point) == dims for point in points["points"]))
                self.assertEqual([to_float(value) for point in points["points"]
                                  for value in point], flat)

    def test_csv_is_exact(self):
        """The numbers are multiples of 2^-24 in [0, 1) only if no digit was lost."""
        for row in self.csv("--count", "5000"):
            for value in row:
                self.assertTrue(0 <= value < 1 and (value * 2**24).is_integer())

    def test_json_says_how_to_draw_again(self):
        run = json.loads(self.output_of("sample", "--dims", "3", "--count", "5", "--first", "7",
                                        "--pattern", "11", "--generator", "random", "--format",
                                        "json"))
        self.assertEqual(
            {key: run[key] for key in ("generator", "dims", "pattern", "first", "count")},
            {"generator": "random", "dims": 3, "pattern": 11, "first": 7, "count": 5})
        self.assertGreaterEqual(run["stream_version"], 1)
        self.assertEqual([len(point) for point in run["points"]], [3] * 5)

    def test_numpy_loads_npy(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("no NumPy")
        self.output_of("sample", "--count", "10", "-o", "points.npy")
        points = numpy.load(self.path("points.npy"), allow_pickle=False)
        self.assertEqual((points.dtype, points.shape), (numpy.dtype("float32"), (10, 2)))
        self.assertEqual([tuple(row) for row in points.tolist()], self.csv("--count", "10"))

    def test_suffix_names_the_format(self):
        for name in ("csv", "npy", "json"):
            self.output_of("sample", "--count", "10", "-o", "points." + name)
            self.assertEqual(self.read("points." + name),
                             self.output_of("sample", "--count", "10", "--format", name))
        self.output_of("sample", "--count", "10", "-o", "points.txt")
        self.assertEqual(self.read("points.txt"), self.read("points.csv"))
        self.output_of("sample", "--count", "10", "--format", "json", "-o", "points.csv")
        self.assertEqual(self.read("points.csv"), self.read("points.json"))

    def test_first_continues_a_shorter_run(self):
        """Across a change of table, where the tables end, and near the last sample."""
        for start in (4090, STRATIFIED - 6, 2**32 - 12):
            whole = self.csv("--first", str(start), "--count", "12")
            self.assertEqual(whole, self.csv("--first", str(start), "--count", "5") +
                             self.csv("--first", str(start + 5), "--count", "7"))

    def test_dimensions_agree(self):
        points = self.csv("--dims", "3", "--count", "300")
        self.assertEqual([point[:2] for point in points],
                         self.csv("--dims", "2", "--count", "300"))
        self.assertEqual([point[2:] for point in points],
                         self.csv("--dims", "1", "--count", "300"))

    def test_pattern_is_decimal_or_hexadecimal(self):
        run = self.csv("--count", "8", "--pattern", "4294967295")
        self.assertEqual(run, self.csv("--count", "8", "--pattern", "0xffffffff"))
        self.assertEqual(run, self.csv("--count", "8", "--pattern", "0XFFFFFFFF"))
        self.assertNotEqual(run, self.csv("--count", "8"))

    def test_defaults(self):
        self.assertEqual(self.csv("--count", "8"),
                         self.csv("--count", "8", "--dims", "2", "--first", "0", "--pattern", "0",
                                  "--generator", "pmj", "--format", "csv", "-o", "-"))

    def test_pmj_is_stratified_and_random_is_not(self):
        """256 random points leave about 94 of 256 squares empty; fewer than 40 or none is beyond
        10 standard deviations."""
        def squares(generator):
            points = self.csv("--count", "256", "--generator", generator)
            return {(int(16 * x), int(16 * y)) for x, y in points}
        self.assertEqual(len(squares("pmj")), 256)
        self.assertLess(len(squares("random")), 216)

    def test_pmj_is_random_beyond_the_tables(self):
        arguments = ("--first", str(STRATIFIED), "--count", "20", "--dims", "3")
        self.assertEqual(self.csv(*arguments), self.csv(*arguments, "--generator", "random"))
        last = ("--first", str(STRATIFIED - 1), "--count", "1")
        self.assertNotEqual(self.csv(*last), self.csv(*last, "--generator", "random"))


if __name__ == "__main__":
    unittest.main()
