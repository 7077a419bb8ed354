# SPDX-License-Identifier: Apache-2.0
"""Point files as other programs write them: each gives the measures of the plain points in it, and
what is no point file is refused with the place."""

import gzip
import json
import struct
import unittest

from test_analyze import CSV, POINTS, AnalyzeTest, npy, pack

VALUES = [value for point in POINTS for value in point]
# Each a multiple of 1/8, so that all types of numbers hold them exactly.
EIGHTHS = ((0, 5), (3, 1), (6, 7), (2, 4))
EIGHTH_CSV = "".join(f"{x / 8},{y / 8}\n" for x, y in EIGHTHS)


def utk(code, sets, count, dims, data, magic=b"UTK!"):
    return magic + struct.pack("<BBBBIII", code, 0, 0, 0, sets, count, dims) + data


def hammersley(shift):
    """16 points, a (0,4,2)-net for any shift of the first coordinate by bits."""
    return [((i ^ shift) / 16, int(f"{i:04b}"[::-1], 2) / 16) for i in range(16)]


def text_of(points, separator=" "):
    return "".join(separator.join(repr(value) for value in point) + "\n" for point in points)


class PointFileTest(AnalyzeTest):
    def assert_points(self, data, points, *arguments, name="points"):
        """The measures of a file are those of `points`."""
        expected = self.measures_of("expected.txt", text_of(points))
        self.assertEqual(self.measures_of(name, data, *arguments), expected, data[:80])

    def assert_refused(self, data, mentions, *arguments, name="points"):
        self.write(name, data)
        self.assert_fails("analyze", name, *arguments, mentions=mentions)
        self.assert_fails("analyze", name, *arguments, mentions=f"'{name}': ")


class TextTest(PointFileTest):
    def test_spellings_of_numbers(self):
        for data in (
                "\ufeff" + CSV,
                "\ufeffx,y\n" + CSV,
                CSV.replace("0.", "+0."),
                CSV.replace("0.", "+."),
                "1.0D-01 7d-1\n 0.4D+00 0.02D1\n+9D-1 0.5\n 0.0D0 95d-2\n",
                "".join(f'"{x}","{y}"\n' for x, y in POINTS),
                CSV.replace("\n", "\r\n")):
            self.assert_points(data, POINTS)

    def test_names(self):
        for names in ("x,y", '"x","y"', "x;y", "x y", "\tx\ty", "sample x, sample y", "\u03b8,\u03c6",
                      "# made by a program\nx,y"):
            self.assert_points(names.strip("\t") + "\n" + CSV, POINTS)
        self.assert_points("x\n0.25\n0.5\n", ((0.25,), (0.5,)))
        self.assert_points("x,y\n0,0.5\n0.25,0\n", ((0, 0.5), (0.25, 0)))

    def test_index_of_data_frames(self):
        rows = [f"{x},{y}\n" for x, y in POINTS]
        from_0 = "".join(f"{i},{row}" for i, row in enumerate(rows))
        from_1 = "".join(f"{i},{row}" for i, row in enumerate(rows, 1))
        quoted = "".join(f'"{i}",{row}' for i, row in enumerate(rows, 1))
        for data in (
                ",x,y\n" + from_0,  # pandas
                ",0,1\n" + from_0,  # columns without names
                ",x,y\n" + "".join(f"{i},{row}" for i, row in zip("abcd", rows)),
                "Unnamed: 0,x,y\n" + from_0,  # written, read and written again
                "index,x,y\n" + from_0,
                "\tx\ty\n" + from_0.replace(",", "\t"),
                "      x     y\n" + from_0.replace(",", "  "),  # printed
                '"","x","y"\n' + quoted,  # R
                '"","x","y"\n' + from_1,
                '"x" "y"\n' + quoted.replace(",", " "),
                "i;x;y\n" + from_1.replace(",", ";")):
            self.assert_points(data, POINTS)

    def test_numbers_that_may_be_coordinates_are(self):
        self.assert_points("x,y\n0,0.5\n", ((0, 0.5),))
        self.assert_points("index,x\n0,0.5\n0.5,0.25\n", ((0, 0.5), (0.5, 0.25)))
        self.assert_refused("0,0.1\n1,0.25\n", "line 2: 1 is not in [0, 1)")
        self.assert_refused("0,1\n0.5,0.25\n", "line 1: 1 is not in [0, 1)")

    def test_refusals(self):
        for data, mentions in (
                ("x,y\n", "line 1: 'x' is no number"),
                ("x,y\n0.5,0.5\nz,0.5\n", "line 3: 'z' is no number"),
                ("x,0.5\n0.5,0.5\n", "line 1: 'x' is no number"),
                ("0.5,0.5\nx,y\n", "line 2: 'x' is no number"),
                ("x,y,z\n0.5,0.5\n", "line 1 has 3 names, line 2 has 2 values"),
                ("halton\n0.1 0.5\n0.25 0.1\n", "line 1 has 1 names, line 2 has 2 values"),
                ("halton\n0 0.5\n0.25 0.1\n", "line 3: '0.25' in the column that counts"),
                ("i,x\n0,0.5\n1,0.5\n3,0.5\n", "line 4: '3' in the column that counts the rows, "
                                               "where 2 is expected"),
                (",x\n0,0.5\n1,1.5\n", "line 3: 1.5 is not in [0, 1)"),
                (",0.2\n0.5,0.5\n", "line 1: a value is missing"),
                ("0.5\n++0.5\n", "line 2: '++0.5' is no number"),
                ("0.5\n+-0.5\n", "line 2: '+-0.5' is no number"),
                ("0.5\n0.5D\n", "line 2: '0.5D' is no number"),
                ("0.5\n0.5D1E1\n", "line 2: '0.5D1E1' is no number"),
                ("0.5\n+1.5\n", "line 2: 1.5 is not in [0, 1)"),
                ("0.5 0.5\n".encode("utf-16"), "is UTF-16 text")):
            self.assert_refused(data, mentions)


class SetsTest(PointFileTest):
    def assert_sets(self, name, data, sets, *arguments):
        """Each set has the measures that a file of its own has."""
        found = self.analyze(self.write(name, data), *arguments)
        self.assertEqual(len(found["sets"]), len(sets))
        self.assertEqual((found["points"], found["dimensions"]), (len(sets[0]), len(sets[0][0])))
        for number, (points, measured) in enumerate(zip(sets, found["sets"])):
            alone = self.measures_of("alone.txt", text_of(points))
            self.assertEqual(measured.pop("name"), f"{name} pattern {number}")
            alone["nearest"].pop("of_largest_minimum")
            self.assertEqual(measured, {key: alone[key] for key in measured})
        return found

    def test_every_format(self):
        sets = [hammersley(shift) for shift in (0, 5, 9)]
        values = [value for points in sets for point in points for value in point]
        words = [int(value * 2**32) for value in values]
        texts = [text_of(points) for points in sets]
        for name, data in (
                ("a.dat", "#\n".join(texts)),
                ("ended.dat", "#\n".join(texts) + "#\n"),
                ("begun.dat", "#\n#\n# x y\n" + " # \r\n".join(texts)),
                ("named.csv", "x y\n" + "#\n".join(texts)),
                ("a.npy", npy("<f8", "(3, 16, 2)", pack("<d", values))),
                ("a.bin", utk(5, 3, 16, 2, pack("<d", values))),
                ("float.bin", utk(4, 3, 16, 2, pack("<f", values))),
                ("word.bin", utk(2, 3, 16, 2, pack("<I", words)))):
            found = self.assert_sets(name, data, sets)
            self.assertEqual([[net["t"] for net in measured["nets"]] for measured in found["sets"]],
                             [[0, 0, 0]] * 3)

    def test_counts_go_on_or_anew(self):
        sets = [hammersley(0), hammersley(3)]
        rows = [text_of(points, ",").splitlines(True) for points in sets]
        anew = "#\n".join("".join(f"{i},{row}" for i, row in enumerate(part)) for part in rows)
        going_on = "#\n".join("".join(f"{i + 16 * k},{row}" for i, row in enumerate(part))
                              for k, part in enumerate(rows))
        for data in (anew, going_on):
            self.assert_sets("a.csv", "n,x,y\n" + data, sets)

    def test_mean_and_worst(self):
        """One bad set among good ones: t of its pairs is 1."""
        pairs = [(i // 2 / 8, int(f"{i // 2:03b}"[::-1], 2) / 8) for i in range(16)]
        self.write("a.dat", "#\n".join(text_of(p) for p in (hammersley(0), hammersley(1), pairs)))
        found = self.analyze("a.dat")
        summary = {row["measure"]: row for row in found["summary"]}
        self.assertEqual(summary["t (x, y)"]["worst_set"], "a.dat pattern 2")
        self.assertEqual(summary["t (x, y)"]["worst"], 1)
        self.assertAlmostEqual(summary["t (x, y)"]["mean"], 1 / 3, delta=1e-12)
        stars = [measured["discrepancy"]["star"][1] for measured in found["sets"]]
        self.assertAlmostEqual(summary["star"]["mean"], sum(stars) / 3, delta=1e-12)
        self.assertEqual(summary["star"]["worst"], max(stars))
        self.assertEqual((summary["distance on torus"]["worst"],
                          summary["distance on torus"]["worst_set"]), (0, "a.dat pattern 2"))
        text = self.output_of("analyze", "a.dat").decode()
        self.assertIn("a.dat: 3 sets of 16 points in 2 dimensions", text)
        self.assertRegex(text, r"t \(x, y\) +0\.333333 +1  a\.dat pattern 2")

    def test_one_set_has_no_summary(self):
        found = self.measures_of("a.dat", text_of(hammersley(0)) + "#\n")
        self.assertEqual((found["sets"], found["summary"]), ([], []))

    def test_patterns_of_a_study(self):
        self.write("a.dat", "#\n".join(text_of(hammersley(shift)) for shift in range(4)))
        self.output_of("study", "--generators", "file:a.dat", "--integrands", "smooth", "--counts",
                       "16", "--patterns", "4", "-o", "a.json")

    def test_sizes_differ(self):
        self.assert_refused("0.1\n0.2\n#\n0.3\n#\n0.1\n0.2\n", "line 5: set 2 ends with 1 points, "
                            "the sets before have 2")
        self.assert_refused("0.1\n0.2\n#\n0.3\n", "the end: set 2 ends with 1 points")
        self.assert_refused("0.1\n#\n0.3 0.4\n", "line 3 has 2 values, the lines before have 1")


class BinaryTest(PointFileTest):
    def test_types(self):
        numbers = [value for point in EIGHTHS for value in point]
        fractions = [value / 8 for value in numbers]
        points = tuple((x / 8, y / 8) for x, y in EIGHTHS)
        cases = [("float16", "f2", "e", fractions), ("float32", "f4", "f", fractions),
                 ("float64", "f8", "d", fractions)]
        for code, bits in (("B", 8), ("H", 16), ("I", 32), ("Q", 64)):
            words = [value << (bits - 3) for value in numbers]
            cases.append((f"uint{bits}", f"u{bits // 8}", code, words))
        for name, numpy_name, code, values in cases:
            for order in "<>":
                descr = ("|" if code == "B" else order) + numpy_name
                self.assert_points(npy(descr, "(4, 2)", pack(order + code, values)), points,
                                   name="a.npy")
            self.assert_points(pack("<" + code, values), points, "--format", "raw", "--dims", "2",
                               "--type", name)
        for code, bits in (("b", 8), ("h", 16), ("i", 32), ("q", 64)):
            words = [value << (bits - 4) for value in numbers]
            scale = ("--scale", f"2^-{bits - 1}")
            descr = "|i1" if bits == 8 else f"<i{bits // 8}"
            self.assert_points(npy(descr, "(4, 2)", pack("<" + code, words)), points, *scale,
                               name="a.npy")
        for code, letter in enumerate("iqIQfd"):
            values = numbers if code < 4 else fractions
            scale = ("--scale", "0.125") if code < 4 else ()
            self.assert_points(utk(code, 1, 4, 2, pack("<" + letter, values)), points, *scale)

    def test_the_largest_numbers_stay_below_1(self):
        for descr, data in (("<u8", b"\xff" * 8), ("<u4", b"\xff" * 4), ("|u1", b"\xff"),
                            ("<f2", b"\xff\x3b")):
            found = self.measures_of("a.npy", npy(descr, "(1,)", data), "--no-spectra")
            self.assertGreater(found["discrepancy"]["star"][0], 0.99)
        # The smallest float16: denormal, 2^-24.
        self.assert_points(npy("<f2", "(1,)", b"\x01\x00"), ((2.0**-24,),), name="a.npy")

    def test_scale_of_text(self):
        self.assert_points("0 5\n3 1\n6 7\n2 4\n", tuple((x / 8, y / 8) for x, y in EIGHTHS),
                           "--scale", "2^-3")

    def test_gzip(self):
        for name, data in (("a.csv.gz", CSV.encode()), ("a.npy.gz", None), ("a", CSV.encode())):
            data = data or npy("<f8", "(4, 2)", pack("<d", VALUES))
            self.assert_points(gzip.compress(data), POINTS, name=name)
        raw = gzip.compress(pack("<d", VALUES))
        self.assert_points(raw, POINTS, "--dims", "2", "--type", "float64", name="a.bin.gz")
        process = self.piped(gzip.compress(CSV.encode()), "-", "--json")
        self.assertEqual((process.returncode, process.stderr), (0, b""))
        self.assertEqual(json.loads(process.stdout)["points"], 4)

    def test_damaged_gzip(self):
        data = bytearray(gzip.compress(CSV.encode() * 1))
        self.assert_refused(bytes(data[:-9]), "compressed by gzip, but damaged or cut off")
        data[-6] ^= 1  # of the checksum
        self.assert_refused(bytes(data), "compressed by gzip, but damaged or cut off")

    def test_refusals(self):
        two = pack("<d", [0.25, 0.5])
        for data, mentions in (
                (utk(5, 1, 3, 1, two), "has 2 numbers, where its header says 3"),
                (utk(5, 1, 1, 1, two), "has 2 numbers, where its header says 1"),
                (utk(5, 0, 1, 1, b""), "holds no points"),
                (utk(5, 1, 2, 0, two), "0 dimensions"),
                (utk(5, 1, 2, 65, two), "65 dimensions; accepted are 1 to 64"),
                (utk(6, 1, 2, 1, two), "type 6; accepted are 0 to 5"),
                (utk(5, 1, 2, 1, two)[:15], "ends within the UTK header"),
                (utk(5, 1, 2, 1, two)[:-3], "ends within a number"),
                (utk(5, 1, 2**31, 1, two), "more than 1048576 points"),
                (utk(5, 2**31, 2**10, 1, two), "more than 33554432 points"),
                (utk(0, 1, 4, 1, two), "signed integers, 'int32'"),
                (utk(1, 1, 2, 1, two), "--scale 2^-63"),
                (utk(5, 1, 2, 1, pack("<d", [0.25, 1.0])), "point 1: 1 is not in [0, 1)"),
                (npy("<i8", "(2, 1)", two), "signed integers, 'int64'")):
            self.assert_refused(data, mentions)
        self.write("a.npy", npy("<i4", "(1, 2)", pack("<i", [-4, 3])))
        self.assert_fails("analyze", "a.npy", "--scale", "0.125", mentions="-0.5 is not in [0, 1)")
        for scale in ("0", "-1", "2^", "2^x", "x", "inf", "nan", "2^99999", "1/4", ""):
            self.assert_fails("analyze", "a.npy", f"--scale={scale}", mentions="--scale")
        self.assert_fails("analyze", "--generator", "pmj", "--scale", "1", mentions="--scale")


class DimensionsTest(PointFileTest):
    def test_up_to_64(self):
        row = " ".join(f"0.{k:02}" for k in range(64))
        self.write("a.txt", f"{row}\n" * 4)
        found = self.analyze("a.txt")
        self.assertEqual(found["dimensions"], 64)
        self.assertEqual(len(found["nets"]), 64 + 64 * 63 // 2)
        self.assertEqual(len(found["spectrum"]["projections"]), 64 * 63 // 2)
        self.assertIsNone(found["discrepancy"]["star"])
        self.assertIsNone(found["pair_correlation"])
        self.assertEqual(found["nearest"]["torus"]["minimum"], 0)
        text = self.output_of("analyze", "a.txt").decode()
        self.assertIn("more than 6 dimensions: projections to one and two only", text)
        self.assertEqual(text.count("not there: more than 3 dimensions"), 2)
        self.assert_refused(f"{row} 0.5\n", "65 dimensions; accepted are 1 to 64")


class ChoiceTest(PointFileTest):
    def test_each_measure_can_be_left_out(self):
        self.write("a.csv", CSV * 2)
        everything = self.analyze("a.csv", "a.csv")
        for option, part, empty in (
                ("--no-nets", "nets", []),
                ("--no-pairs", "pair_correlation", None),
                ("--no-distances", "nearest", {"cube": None, "torus": None,
                                               "of_largest_minimum": None}),
                ("--no-independence", "independence", []),
                ("--no-spectra", "spectrum", {"realizations": 2, "projections": []})):
            found = self.analyze("a.csv", "a.csv", option)
            self.assertEqual(found[part], empty)
            self.assertNotEqual(everything[part], empty)
        for option, kept in (("--no-star", False), ("--no-l2", True)):
            discrepancy = self.analyze("a.csv", option)["discrepancy"]
            self.assertEqual({key for key, value in discrepancy.items() if value is None},
                             {key for key in discrepancy if (key != "star") == kept})
        options = [f"--no-{name}" for name in ("nets", "star", "l2", "distances", "pairs",
                                               "spectra", "independence")]
        self.assertEqual(len(self.output_of("analyze", "a.csv", *options).splitlines()), 2)
        self.assert_fails("analyze", "a.csv", *options, "--plot", "a.png", mentions="nothing to draw")


if __name__ == "__main__":
    unittest.main()
