# SPDX-License-Identifier: Apache-2.0
"""`wellstrat analyze`: its numbers against SciPy's, its inputs, its refusals."""

import array
import csv
import io
import json
import math
import random
import resource
import shutil
import struct
import subprocess
import unittest

from support import PROGRAM, CliTest, read_npy
from test_plot import png_size

try:
    import numpy
    from scipy.stats import qmc
except ImportError:
    qmc = None

L2 = ("star", "centered", "wrap_around", "mixture", "modified")
POINTS = ((0.1, 0.7), (0.4, 0.2), (0.9, 0.5), (0.0, 0.95))
CSV = "".join(f"{x},{y}\n" for x, y in POINTS)
MANY = 100_000_000


def npy(descr, shape, data, order="False"):
    """A NumPy file, written as the format's specification says."""
    text = f"{{'descr': '{descr}', 'fortran_order': {order}, 'shape': {shape}, }}"
    text += " " * (53 - len(text) % 64 + 64 * (len(text) % 64 > 53)) + "\n"
    assert (10 + len(text)) % 64 == 0
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(text)) + text.encode() + data


def pack(code, values):
    return struct.pack(f"{code[0]}{len(values)}{code[1]}", *values)


def little_memory():
    """Of 1.25 GiB, 0.8 are for the most points that are read, and some for shared libraries. 10^8
    points would take 1.5."""
    resource.setrlimit(resource.RLIMIT_AS, (5 << 28, 5 << 28))


class AnalyzeTest(CliTest):
    def write(self, name, data):
        with open(self.path(name), "wb") as file:
            file.write(data.encode() if isinstance(data, str) else data)
        return name

    def analyze(self, *arguments, **options):
        return json.loads(self.output_of("analyze", "--json", *arguments, **options))

    def measures_of(self, name, data, *arguments):
        """All measures of a file; what it is called apart."""
        result = self.analyze(self.write(name, data), *arguments)
        self.assertEqual(result.pop("subject"), name)
        return result

    def piped(self, data, *arguments):
        return subprocess.run([PROGRAM, "analyze", *arguments], input=data, cwd=self.directory,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=100,
                              check=False)


@unittest.skipUnless(qmc, "no SciPy")
class ScipyTest(AnalyzeTest):
    METHODS = {"centered": "CD", "wrap_around": "WD", "mixture": "MD", "star": "L2-star"}

    def assert_agrees(self, points):
        numpy.save(self.path("points.npy"), points)
        found = self.analyze("points.npy")["discrepancy"]
        for name, method in self.METHODS.items():
            expected = qmc.discrepancy(points, method=method)
            value = found["l2_" + name]
            # SciPy gives the squares of all but this.
            self.assertAlmostEqual(value if name == "star" else value**2, expected, delta=1e-10)

    def test_discrepancies(self):
        for dims in (1, 2, 3, 6):
            for count in (1, 5, 64, 1000):
                self.assert_agrees(numpy.random.default_rng(dims).random((count, dims)))

    def test_scrambled_sobol(self):
        points = qmc.Sobol(3, seed=1).random(1024)
        self.assert_agrees(points)
        result = self.analyze("points.npy")
        # Sobol' 1967: at most 0 for the first two dimensions, 1 with the third; and never 0 in 3D.
        qualities = [net["t"] for net in result["nets"]]
        self.assertEqual(qualities[:4], [0, 0, 0, 0])
        self.assertLessEqual(max(qualities[4:6]), 1)
        self.assertEqual(qualities[6], 1)

    def test_poisson_disk_keeps_its_distance(self):
        numpy.save(self.path("disk.npy"), qmc.PoissonDisk(2, radius=0.05, seed=1).random(200))
        result = self.analyze("disk.npy")
        self.assertGreaterEqual(result["nearest"]["cube"]["minimum"], 0.05)


class InputTest(AnalyzeTest):
    def test_every_format_gives_the_same(self):
        values = [value for point in POINTS for value in point]
        columns = [point[d] for d in (0, 1) for point in POINTS]
        expected = self.measures_of("points.csv", CSV)
        self.assertEqual(expected["points"], 4)
        self.assertEqual(expected["dimensions"], 2)
        for name, data in (
                ("blanks.txt", CSV.replace(",", " \t")),
                ("windows.csv", CSV.replace("\n", "\r\n")),
                ("comments", "# x y\n\n" + CSV.replace("\n", "  # a point\n\n")),
                ("unended.csv", CSV.rstrip("\n")),
                ("exponents", "1e-1;7E-1\n.4;2.0e-1\n0.9;0.5\n0;0.95\n"),
                ("little.npy", npy("<f8", "(4, 2)", pack("<d", values))),
                ("big.npy", npy(">f8", "(4, 2)", pack(">d", values))),
                ("fortran.npy", npy("<f8", "(4, 2)", pack("<d", columns), "True")),
                ("no_suffix", npy("<f8", "(4, 2)", pack("<d", values)))):
            self.assertEqual(self.measures_of(name, data), expected, name)
        raw = ("--dims", "2", "--type", "float64")
        self.assertEqual(self.measures_of("points.raw", pack("<d", values), *raw), expected)
        self.assertEqual(self.measures_of("points", pack("<d", values), *raw, "--format", "raw"),
                         expected)

    def test_single_precision(self):
        values = array.array("f", [value for point in POINTS for value in point])
        expected = self.measures_of("points.csv", "".join(
            f"{values[i]!r} {values[i + 1]!r}\n" for i in range(0, 8, 2)))
        data = pack("<f", values)
        self.assertEqual(self.measures_of("a.npy", npy("<f4", "(4, 2)", data)), expected)
        self.assertEqual(self.measures_of("a.bin", data, "--dims", "2"), expected)

    def test_one_axis_is_one_dimension(self):
        result = self.measures_of("a.npy", npy("<f8", "(4,)", pack("<d", [0.1, 0.3, 0.6, 0.8])))
        self.assertEqual((result["points"], result["dimensions"]), (4, 1))
        self.assertEqual(result["nets"], [{"projection": [0], "t": 0, "sequence_t": 1,
                                           "base4_boxes": True}])

    def test_aligned_blocks_in_all_projections(self):
        self.write("a.txt", "".join(" ".join(repr(random.Random(6 * i + d).random())
                                             for d in range(6)) + "\n" for i in range(64)))
        nets = self.analyze("a.txt")["nets"]
        self.assertEqual(len(nets), 63)
        for net in nets:
            self.assertLessEqual(net["t"], net["sequence_t"])
            self.assertEqual(net["base4_boxes"] is None, len(net["projection"]) > 3)

    def test_every_source_of_a_study(self):
        listed = self.output_of("study", "--list").decode().split("Integrands")[0]
        names = [line.split()[0] for line in listed.splitlines() if line.startswith("  ")]
        self.assertIn("sobol-owen", names)
        for name in names:
            if name == "file:PATH":
                continue
            for dims in (1, 2, 3):
                result = self.analyze("--generator", name, "--count", "64", "--dims", str(dims),
                                      "--realizations", "2", "--pattern", "4294967295")
                self.assertEqual((result["points"], result["dimensions"]), (64, dims))
                self.assertEqual(len(result["independence"]), 3)
        nets = self.analyze("--generator", "sobol-owen", "--count", "64")["nets"]
        self.assertEqual([net["sequence_t"] for net in nets], [0, 0, 0])

    def test_standard_input(self):
        expected = self.measures_of("points.csv", CSV)
        for data in (CSV.encode(), npy("<f8", "(4, 2)", pack("<d", sum(POINTS, ())))):
            process = self.piped(data, "-", "--json")
            self.assertEqual((process.returncode, process.stderr), (0, b""))
            found = json.loads(process.stdout)
            self.assertEqual(found.pop("subject"), "standard input")
            self.assertEqual(found, expected)

    def test_realizations(self):
        """Several files are the patterns of one array; spectra are the mean of both."""
        names = ["0.npy", "1.npy", "2.npy"]
        for pattern, name in enumerate(names):
            self.output_of("sample", "--count", "64", "--pattern", str(pattern), "-o", name)
        generator = self.analyze("--generator", "pmj", "--count", "64", "--realizations", "3")
        files = self.analyze(*names)
        self.assertEqual(files["subject"], "0.npy, 1.npy, 2.npy")
        self.assertEqual(files["spectrum"], generator["spectrum"])
        self.assertEqual(files["nets"], self.analyze(names[0])["nets"])
        values = b"".join(read_npy(self.read(name))[2] for name in names)
        array = self.measures_of("a.npy", npy("<f4", "(3, 64, 2)", values))
        patterns, = array["independence"]
        for part in ("nets", "discrepancy", "nearest", "pair_correlation", "spectrum"):
            self.assertEqual(array[part], files[part], part)
        self.assertEqual(patterns["family"], "patterns")
        self.assertEqual(patterns["pairs"], 3 * 4)
        for pair in patterns["worst"]:
            self.assertRegex(pair["first"], r"\Aa.npy pattern [012] [xy]\Z")

    def test_generator_is_its_samples(self):
        self.output_of("sample", "--count", "64", "--dims", "3", "--pattern", "5", "-o", "a.npy")
        file = self.analyze("a.npy")
        generator = self.analyze("--generator", "pmj", "--count", "64", "--dims", "3", "--pattern",
                                 "5", "--realizations", "1")
        for part in ("nets", "discrepancy", "nearest", "pair_correlation", "spectrum"):
            self.assertEqual(file[part], generator[part], part)
        self.assertEqual(file["independence"], [])
        self.assertEqual(len(generator["independence"]), 3)

    def test_one_point(self):
        for line in ("0.5\n", "0.5 0.25\n", "0.5 0.25 0.125\n", "0 0 0 0 0 0 0\n"):
            result = self.measures_of("one.txt", line)
            self.assertIsNone(result["nearest"]["cube"])
            self.assertIn("1 points", self.output_of("analyze", "one.txt").decode())


class RefusalTest(AnalyzeTest):
    def assert_refused(self, data, mentions, *arguments, name="points"):
        self.write(name, data)
        self.assert_fails("analyze", name, *arguments, mentions=mentions)

    def test_bad_text(self):
        for data, mentions in (
                ("", "no points"),
                ("\n# nothing\n", "no points"),
                ("0.1 0.2\n0.3\n", "line 2 has 1 values, the lines before have 2"),
                ("0.1\n0.3 0.4\n", "line 2 has 2 values"),
                ("0.1,0.2,0.3\n0.1,,0.2\n", "line 2: a value is missing"),
                (",0.2\n", "line 1: a value is missing"),
                ("0.1;0.2; \n", "line 1: a value is missing"),
                ("0.1 zebra\n", "line 1: 'zebra' is no number"),
                ("0.1.2\n", "'0.1.2' is no number"),
                ("0.5\nnan\n", "line 2: nan is not in [0, 1)"),
                ("inf\n", "inf is not in [0, 1)"),
                ("0.5\n\n1.0\n", "line 3: 1 is not in [0, 1)"),
                ("-0.25\n", "-0.25 is not in [0, 1)"),
                ("0.1 " * 65 + "\n", "65 dimensions; accepted are 1 to 64"),
                ("0.1," * 2000, "line 1 is longer"),
                (b"\0" * 100000, "line 1 is longer"),
                (b"\xff\xd8\xff\xe0\n", "is no number")):
            self.assert_refused(data, mentions)

    def test_bad_npy(self):
        two = pack("<d", [0.25, 0.5])
        for data, mentions in (
                (npy("<f8", "(2, 1)", pack("<d", [0.25, 1.0])), "point 1: 1 is not in [0, 1)"),
                (npy("<f4", "(1, 2)", pack("<f", [0.25, float("nan")])), "point 0: nan"),
                (npy("<c8", "(2, 1)", two), "'<c8'; accepted are float16, float32, float64, uint8"),
                (npy("|b1", "(16, 1)", two), "'|b1'"),
                (npy("|O", "(2, 1)", two), "'|O'"),
                (npy("<f8", "(3, 1)", two), "has 2 numbers, where its header says 3"),
                (npy("<f8", "(1, 1)", two), "has 2 numbers, where its header says 1"),
                (npy("<f8", "(2, 1)", two[:-1]), "ends within a number"),
                (npy("<f8", "(0, 2)", b""), "no points"),
                (npy("<f8", "(2, 0)", b""), "0 dimensions"),
                (npy("<f8", "()", two), "0 axes"),
                (npy("<f8", "(1, 1, 1, 2)", two), "4 axes"),
                (npy("<f8", f"({MANY}, 1, 2)", two), "more than 16777216 points"),
                (npy("<f8", f"(1, {MANY}, 2)", two), "more than 1048576 points"),
                (npy("<f8", "(4097, 1, 1)", b"\0" * 8 * 4097), "more than 4096 patterns"),
                (npy("<f8", f"({MANY}, 2)", two), "more than 1048576 points"),
                (npy("<f8", "(99999999999999999999, 2)", two), "out of range"),
                (npy("<f8", "(2, 1)", two)[:30], "ends within the NumPy header"),
                (b"\x93NUMPY", "ends within the NumPy header"),
                (b"\x93NUMPY\x02\x00\xff\xff\xff\xff", "too long"),
                (b"\x93NUMPY\x01\x00\x04\x00{}  ", "NumPy header"),
                (b"0.1 0.2\n0.5 0.6\n", "no NumPy file")):
            self.assert_refused(data, mentions, name="points.npy")

    def test_bad_raw(self):
        raw = ("--format", "raw")
        self.assert_refused(pack("<f", [0.5, 0.5, 0.5]), "ends within a point", *raw, "--dims", "2")
        self.assert_refused(b"\0" * 7, "ends within a number", *raw, "--dims", "1")
        self.assert_refused(pack("<f", [0.5, 1.0]), "point 1: 1 is not", *raw, "--dims", "1")
        self.assert_refused(b"", "no points", *raw, "--dims", "1")
        self.assert_refused(b"\0" * 8, "--dims", *raw)
        self.assert_refused(b"\0" * 8, "'int8'", *raw, "--dims", "1", "--type", "int8")
        self.assert_refused(b"\0" * 8, "'float8'", *raw, "--dims", "1", "--type", "float8")
        self.assert_refused(b"\0" * 8, "text, npy, raw, utk", "--format", "xml")

    def test_bad_arguments(self):
        self.write("points.csv", CSV)
        self.write("other.csv", "0.5 0.5\n")
        for arguments, mentions in (
                ((), "--generator"),
                (("missing.csv",), "cannot read 'missing.csv'"),
                ((".",), "directory"),
                (("points.csv", "--generator", "pmj"), "--generator"),
                (("points.csv", "other.csv"), "'other.csv': has 1 points in 2 dimensions"),
                (("points.csv", "--domains", "1,2"), "1 + 2 are not the 2 dimensions"),
                (("points.csv", "--domains", "0,2"), "--domains"),
                (("--generator", "pmj", "--domains", "1,1"), "--domains"),
                (("points.csv", "--dims", "2"), "--dims goes with --generator"),
                (("--generator", "zebra"), "pmj, random, long, blue, joint, long-words, sobol-owen"),
                (("--generator", "file:points.csv"), "no generator is called"),
                (("--generator", "pmj", "--dims", "4"), "1 to 3"),
                (("--generator", "halton", "--dims", "4"), "1 to 3"),
                (("--generator", "pmj", "--count", "0"), "from 1"),
                (("--generator", "pmj", "--realizations", "0"), "from 1"),
                (("points.csv", "--count", "4"), "--generator"),
                (("points.csv", "--keep-plot-files"), "--plot"),
                (("points.csv", "--plot", "a.gif"), ".png, .svg, .pdf"),
                (("--generator", "pmj", "--count", "65537", "--plot", "a.png"), "65536")):
            self.assert_fails("analyze", *arguments, mentions=mentions)

    def test_too_many_rows_take_little_memory(self):
        """Text of 10^8 lines and an endless file are given up early."""
        command = f"yes 0.5 | head -n {MANY} | exec '{PROGRAM}' analyze -"
        process = subprocess.run(["sh", "-c", command], stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, timeout=100, check=False,
                                 preexec_fn=little_memory)
        self.assertEqual(process.returncode, 2)
        self.assertRegex(process.stderr.decode(), r"\Awellstrat: [^\n]*more than 1048576 points[^\n]*\n\Z")
        self.assert_fails("analyze", "/dev/zero", "--format", "raw", "--dims", "32",
                          mentions="more than 1048576 points", preexec_fn=little_memory)
        with open(self.path("sparse.npy"), "wb") as file:
            file.write(npy("<f8", f"({MANY}, 2)", b""))
            file.truncate(MANY * 16)
        for arguments in (("analyze", "sparse.npy"), ("study", "--generators", "file:sparse.npy")):
            process = self.run_program(*arguments, preexec_fn=little_memory)
            self.assertEqual((process.returncode, process.stdout), (2, b""))
            self.assertRegex(process.stderr.decode(), "more than 1048576 points")


class ManyPointsTest(AnalyzeTest):
    def test_time_and_memory(self):
        """All measures of 2^18 points, in time that grows about as their number: pair by pair, the
        L2 discrepancies alone would be over a minute of processor time."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        found = self.analyze("--generator", "random", "--count", str(1 << 18), "--realizations",
                             "1", preexec_fn=little_memory)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertLess(after.ru_utime - before.ru_utime, 30)
        for measured in (found["nets"][2]["sequence_t"], found["nearest"]["torus"],
                         found["pair_correlation"], *found["discrepancy"].values()):
            self.assertIsNotNone(measured)
        lower, upper = found["discrepancy"]["star"]
        self.assertEqual(lower, upper)


class FaultTest(AnalyzeTest):
    """Each fault is seen by the measure that exists to see it, and not where there is none."""

    def sobol(self, faulty_column=None):
        """256 points of the first two Sobol' dimensions; a bit of a column may be flipped."""
        columns = [[1 << (31 - k) for k in range(8)], [1 << 31]]
        for _ in range(7):
            columns[1].append(columns[1][-1] ^ columns[1][-1] >> 1)
        if faulty_column is not None:
            columns[1][faulty_column] ^= 1 << (31 - faulty_column)
        points = []
        for i in range(256):
            point = [0, 0]
            for d in (0, 1):
                for k in range(8):
                    if i >> k & 1:
                        point[d] ^= columns[d][k]
            points.append(tuple(value / 2**32 for value in point))
        return points

    def write_points(self, name, points):
        return self.write(name, "".join(" ".join(repr(value) for value in point) + "\n"
                                        for point in points))

    def measures(self, points, *arguments):
        return self.analyze(self.write_points("points.txt", points), *arguments)

    def random_points(self, dims, seed=1):
        numbers = random.Random(seed)
        return [tuple(numbers.random() for _ in range(dims)) for _ in range(256)]

    def test_flipped_matrix_bit_by_t(self):
        self.assertEqual([net["t"] for net in self.measures(self.sobol())["nets"]], [0, 0, 0])
        nets = self.measures(self.sobol(faulty_column=5))["nets"]
        self.assertEqual(nets[0]["t"], 0)
        self.assertGreater(nets[1]["t"], 0)

    def test_duplicated_point_by_distance(self):
        points = self.sobol()
        self.assertGreater(self.measures(points)["nearest"]["torus"]["minimum"], 0)
        nearest = self.measures(points + [points[100]])["nearest"]
        self.assertEqual((nearest["cube"]["minimum"], nearest["torus"]["minimum"]), (0, 0))

    def test_duplicated_points_by_t_and_pair_correlation(self):
        points = self.sobol()
        pairs = [points[i // 2] for i in range(256)]
        right, wrong = self.measures(points), self.measures(pairs)
        self.assertEqual([net["t"] for net in wrong["nets"]], [1, 1, 1])
        self.assertLess(right["pair_correlation"]["values"][0], 2)
        self.assertGreater(wrong["pair_correlation"]["values"][0], 20)

    def test_missing_scramble_by_peaks(self):
        """The same points for each pattern, against scrambled points."""
        names = [f"{k}.txt" for k in range(8)]
        for pattern, name in enumerate(names):
            self.output_of("sample", "--count", "256", "--pattern", str(pattern), "-o", name,
                           "--format", "csv")
        right = self.analyze(*names)
        for name in names:
            self.write_points(name, self.sobol())
        wrong = self.analyze(*names)
        peaks = [result["spectrum"]["projections"][0]["peak"]["power"] for result in (right, wrong)]
        self.assertGreater(peaks[1], 5 * peaks[0])

    def test_missing_scramble_by_independence(self):
        for name in ("a.txt", "b.txt"):
            self.write_points(name, self.random_points(2))
        patterns, = self.analyze("a.txt", "b.txt")["independence"]
        self.assertEqual(patterns["family"], "patterns")
        worst = patterns["worst"][:2]
        self.assertEqual({(pair["first"], pair["second"]) for pair in worst},
                         {("a.txt x", "b.txt x"), ("a.txt y", "b.txt y")})
        for pair in worst:
            self.assertAlmostEqual(pair["correlation"], 1, delta=1e-9)

    def test_copies_are_named_before_lockstep(self):
        """Three copies of one Sobol' set, whose x and y fill any grid too evenly."""
        names = ("a.csv", "b.csv", "c.csv")
        for name in names:
            self.write_points(name, self.sobol())
        patterns, = self.analyze(*names)["independence"]
        self.assertEqual({(pair["first"][-1], pair["second"][-1]) for pair in patterns["worst"]},
                         {("x", "x"), ("y", "y")})

    def test_missing_scramble_by_bias(self):
        """In a study, patterns that are all the same have an error that is all bias."""
        self.write_points("points.txt", self.sobol())
        for generator, patterns in (("sobol", 4), ("file:points.txt", 1)):
            row, = csv.DictReader(io.StringIO(self.output_of(
                "study", "--generators", generator, "--integrands", "gaussian", "--counts", "64",
                "--patterns", str(patterns), "-o", "-").decode()))
            self.assertAlmostEqual(abs(float(row["bias"])) / float(row["rmse"]), 1, delta=1e-12)

    def test_correlated_domains_by_independence(self):
        points = self.random_points(5)
        def domains(points):
            family, = self.measures(points, "--domains", "2,2,1")["independence"]
            self.assertEqual((family["family"], family["pairs"]), ("domains", 8))
            return family["worst"]
        self.assertGreater(domains(points)[0]["probability"], 1e-4)
        wrong = domains([(a, b, c, (d + 4 * a) / 5, e) for a, b, c, d, e in points])
        self.assertEqual((wrong[0]["first"], wrong[0]["second"]), ("domain 0 x1", "domain 1 x2"))
        self.assertLess(wrong[0]["probability"], 1e-20)
        self.assertGreater(wrong[1]["probability"], 1e-4)

    def test_values_outside_by_name(self):
        """1.0 and NaN are refused by each command that takes points, in every place and format."""
        for bad in (1.0, math.nan, math.inf, -0.5):
            points = self.sobol()
            points[77] = (0.5, bad)
            self.write_points("points.txt", points)
            self.write("points.npy", npy("<f8", "(256, 2)", pack("<d", sum(points, ()))))
            self.write("points.raw", pack("<f", sum(points, ())))
            for name, place in (("txt", "line 78"), ("npy", "point 77"), ("raw", "point 77")):
                mentions = f"{place}: {bad:g} is not in [0, 1)"
                dims = ("--dims", "2") if name == "raw" else ()
                self.assert_fails("analyze", f"points.{name}", *dims, mentions=mentions)
                if name != "raw":
                    self.assert_fails("study", "--generators", f"file:points.{name}", "--counts",
                                      "4", "--patterns", "1", mentions=mentions)

    def test_lattice_by_its_peak(self):
        lattice = self.measures([(x / 16, y / 16) for x in range(16) for y in range(16)])
        peak = lattice["spectrum"]["projections"][0]["peak"]
        self.assertAlmostEqual(peak["power"], 256, delta=1e-6)
        self.assertEqual([f % 16 for f in peak["frequency"]], [0, 0])

    def test_bias_by_discrepancy(self):
        points = self.sobol()
        pushed = [(x * 0.97, y) for x, y in points]
        for key in ("star", *("l2_" + name for name in L2)):
            right, wrong = (self.measures(p)["discrepancy"][key] for p in (points, pushed))
            if key == "star":
                right, wrong = right[0], wrong[0]
            self.assertGreater(wrong, 1.2 * right, key)

    def test_independence_names_families(self):
        families = self.analyze("--generator", "pmj", "--count", "1024")["independence"]
        self.assertEqual([family["family"] for family in families],
                         ["patterns", "pixels and frames", "domains"])
        for family in families:
            self.assertEqual(family["pairs"], 28 * 4)
            self.assertEqual(len(family["worst"]), 5)
            self.assertLess(abs(family["worst"][0]["correlation"]), 0.25)


class ReportTest(AnalyzeTest):
    def test_text(self):
        text = self.output_of("analyze", "--generator", "pmj", "--count", "256", "--dims",
                              "3").decode()
        for part in ("pmj, pattern 0: 256 points in 3 dimensions", "(x, y, z)", "aligned blocks",
                     "L2 centered", "nearest", "pair correlation", "anisotropy", "peak",
                     "pixels and frames", "worst pairs"):
            self.assertIn(part, text)

    def test_other_than_powers_of_two(self):
        text = self.output_of("analyze", "--generator", "pmj", "--count", "100").decode()
        self.assertIn("no power of two", text)

    def test_radial_mean(self):
        projection, = self.analyze("--generator", "random", "--count", "1024", "--realizations",
                                   "64")["spectrum"]["projections"]
        rings = projection["radial_mean"]
        self.assertEqual(len(rings), projection["max_frequency"] + 1)
        # Standard error of the mean of 8,000 frequencies of 64 realizations: 0.0014.
        self.assertAlmostEqual(sum(rings[20:]) / len(rings[20:]), 1, delta=0.01)

    @unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
    def test_plot(self):
        for dims, size in (("1", (480, 480)), ("2", (1440, 960)), ("3", (1440, 1920))):
            self.output_of("analyze", "--generator", "pmj", "--count", "64", "--dims", dims,
                           "--plot", "a.png", "--keep-plot-files")
            self.assertEqual(png_size(self.read("a.png")), size)
            self.assertEqual(self.files(), ["a.dat", "a.gp", "a.png"])
        sets = [part.splitlines() for part in self.read("a.dat").decode().split("\n\n\n")]
        self.assertEqual([part[0] for part in sets],
                         [f"# {name}{row}" for row in range(3)
                          for name in ("points", "periodogram", "radial")] + ["# pairs0"])
        self.assertEqual(len(sets[0]), 1 + 64)
        self.assertEqual(len(sets[1]), 1 + 33 * 33)


if __name__ == "__main__":
    unittest.main()
