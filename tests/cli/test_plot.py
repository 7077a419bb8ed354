# SPDX-License-Identifier: Apache-2.0
"""`wellstrat sample --plot` and `--compare`."""

import os
import shutil
import subprocess
import unittest
import zlib

from support import CliTest, read_csv, to_float
from test_output import SAFE_NAMES


# Of a user who has changed what gnuplot draws.
SETTINGS = """
set logscale xy
set grid
set key off
set xrange [5:6]
set yrange [*:0.001]
set angles degrees
set samples 5
set style data lines
set style fill pattern 3
set datafile separator ','
set datafile missing '0'
set datafile commentschars '!'
set decimalsign ','
set encoding iso_8859_1
set minussign
set linetype 1 lc rgb 'red' lw 5 dashtype 3
set linetype 2 lc rgb 'green' pt 3
set linetype cycle 2
set colorsequence podo
set palette gray
set pointsize 3
set border 0
set title 'mine' font ',40'
set label 'mine' at screen 0.5,0.5
set arrow from 0,0 to 1,1
set object rectangle from 0,0 to 1,1
set dummy u
set parametric
set polar
set format '%e'
set tics font ',30'
set bars 5
set tmargin 10
set size 0.5,0.5
set origin 0.3,0.3
set view map
set timestamp
set boxwidth 3
set jitter
set xdata time
set xtics 0.001
set term svg size 100,100 font 'serif,30' dashed
set fontpath '/nonexistent'
data = 'mine'
stem = 'mine'
n = 3
f(x) = 7
"""


def png_size(data):
    """Width and height of a PNG whose chunks are whole. ISO/IEC 15948, section 5.3."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n"
    kinds, at = [], 8
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        body = data[at + 4:at + 8 + length]
        assert zlib.crc32(body) == int.from_bytes(data[at + 8 + length:at + 12 + length], "big")
        kinds.append(body[:4])
        at += 12 + length
    assert kinds[0] == b"IHDR" and kinds[-1] == b"IEND", kinds
    return int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big")


def data_sets(text):
    """The named sets of lines of a plot's data file."""
    sets = {}
    for part in text.split("\n\n\n"):
        name, *lines = part.splitlines()
        sets[name[2:]] = [tuple(to_float(field) for field in line.split()) for line in lines]
    return sets


@unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
class PlotTest(CliTest):
    def kept_data(self, *arguments):
        self.output_of("sample", *arguments, "--plot", "plot.png", "--keep-plot-files")
        return data_sets(self.read("plot.dat").decode())

    def test_compare(self):
        output = self.output_of("sample", "--compare", "random,pmj", "--count", "256", "--plot",
                                "compare.png")
        self.assertEqual(output, b"")
        self.assertEqual(self.files(), ["compare.png"])
        width, height = png_size(self.read("compare.png"))
        self.assertTrue(800 <= width <= 4000 and 0.45 < height / width < 0.6)
        self.assertGreater(len(self.read("compare.png")), 10000)

    def test_compare_draws_the_samples_in_order(self):
        sets = self.kept_data("--compare", "random,pmj", "--count", "256", "--pattern", "3")
        for number, generator in enumerate(("random", "pmj")):
            self.assertEqual(sets[f"points{number}"],
                             read_csv(self.output_of("sample", "--count", "256", "--pattern", "3",
                                                     "--generator", generator)))
        self.assertEqual(len(sets["xstrata1"]), 256)
        self.assertLess(len(sets["xstrata0"]), 216)

    def test_a_generator_that_is_named_twice_counts_once(self):
        once = self.kept_data("--compare", "pmj", "--count", "16")
        self.assertEqual(self.kept_data("--compare", "pmj,pmj", "--count", "16"), once)

    def test_strata(self):
        for count, lines in ((1, 2), (2, 2), (16, 5), (32, 5), (100, 9), (256, 17)):
            sets = self.kept_data("--count", str(count))
            self.assertEqual(len(sets["grid0"]), 2 * lines, count)
            self.assertEqual(len(sets["xstrata0"]), 1 << (count.bit_length() - 1), count)

    def test_one_dimension(self):
        sets = self.kept_data("--count", "64", "--dims", "1")
        values = [point[0] for point in sets["points0"]]
        order = [point[1] for point in sets["points0"]]
        self.assertEqual([(value,) for value in values],
                         read_csv(self.output_of("sample", "--count", "64", "--dims", "1")))
        self.assertEqual(order, sorted(order))

    def test_three_dimensions_are_three_planes(self):
        sets = self.kept_data("--count", "64", "--dims", "3")
        points = read_csv(self.output_of("sample", "--count", "64", "--dims", "3"))
        for number, (a, b) in enumerate(((0, 1), (0, 2), (1, 2))):
            self.assertEqual(sets[f"points{number}"], [(p[a], p[b]) for p in points])
        width, height = png_size(self.read("plot.png"))
        self.assertTrue(2.5 < width / height < 3)

    def test_formats(self):
        for suffix, magic in ((".png", b"\x89PNG"), (".svg", b"<?xml"), (".pdf", b"%PDF")):
            self.output_of("sample", "--count", "64", "--plot", "plot" + suffix)
            self.assertEqual(self.read("plot" + suffix)[:len(magic)], magic)

    def test_samples_are_written_on_request(self):
        plot = ("sample", "--count", "8", "--plot", "plot.png")
        csv = self.output_of("sample", "--count", "8")
        self.assertEqual(self.output_of(*plot, "--format", "csv"), csv)
        self.output_of(*plot, "-o", "points.csv")
        self.assertEqual(self.read("points.csv"), csv)

    def test_kept_files_draw_the_picture_again(self):
        for suffix in (".png", ".svg"):
            self.output_of("sample", "--count", "64", "--plot", "plot" + suffix,
                           "--keep-plot-files")
            self.assertEqual(self.files(), ["plot.dat", "plot.gp", "plot" + suffix])
            picture = self.read("plot" + suffix)
            os.remove(self.path("plot" + suffix))
            subprocess.run(["gnuplot", "--default-settings", "plot.gp"], cwd=self.directory,
                           check=True, timeout=60)
            self.assertEqual(self.read("plot" + suffix), picture)
            os.remove(self.path("plot" + suffix))

    def test_any_name(self):
        """Guards against names that a shell or gnuplot would take for a command."""
        for name in SAFE_NAMES:
            self.output_of("sample", "--count", "4", "--plot=" + name + ".png",
                           "--keep-plot-files")
            png_size(self.read(name + ".png"))
        self.assertEqual(self.files(), sorted(name + suffix for name in SAFE_NAMES
                                              for suffix in (".png", ".dat", ".gp")))

    def test_no_folder_for_temporary_files_is_needed(self):
        os.mkdir(self.path("tmp"))
        for folder in ("tmp", "missing"):
            self.output_of("sample", "--count", "4", "--plot", "plot.png",
                           env={**os.environ, "TMPDIR": self.path(folder)})
        self.assertEqual(self.files(), ["plot.png", "tmp"])
        self.assertEqual(os.listdir(self.path("tmp")), [])

    def test_kept_files_draw_the_same_under_other_settings(self):
        """gnuplot reads ~/.gnuplot first."""
        with open(self.path(".gnuplot"), "w", encoding="ascii") as file:
            file.write(SETTINGS)
        environment = {**os.environ, "HOME": self.directory}
        arguments = ("--plot", "plot.svg", "--keep-plot-files")
        for command in (("sample", "--count", "64"), ("analyze", "--generator", "pmj", "--count",
                                                      "64"),
                        ("study", "--integrands", "disk,step", "--patterns", "8")):
            process = self.run_program(*command, *arguments)
            self.assertEqual((process.returncode, process.stderr), (0, b""))
            picture = self.read("plot.svg")
            os.remove(self.path("plot.svg"))
            drawn = subprocess.run(["gnuplot", "plot.gp"], cwd=self.directory, env=environment,
                                   check=True, timeout=60, capture_output=True)
            self.assertTrue(self.read("plot.svg") == picture, (command, drawn.stderr))

    def test_pictures_without_text_are_told(self):
        with open(self.path("fonts.conf"), "w", encoding="ascii") as file:
            file.write("<fontconfig><dir>/nonexistent</dir></fontconfig>\n")
        environment = {**os.environ, "FONTCONFIG_FILE": self.path("fonts.conf")}
        for suffix in (".png", ".pdf", ".svg"):
            process = self.run_program("sample", "--count", "4", "--plot", "plot" + suffix,
                                       env=environment)
            self.assertEqual(process.returncode, 0)
            if suffix == ".svg":  # the fonts are those of who looks at it
                self.assertEqual(process.stderr, b"")
            else:
                self.assertRegex(process.stderr,
                                 rb"\Awellstrat: [^\n]*no fonts[^\n]*fonts-dejavu-core\n\Z")


if __name__ == "__main__":
    unittest.main()
