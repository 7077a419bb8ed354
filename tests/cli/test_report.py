# SPDX-License-Identifier: Apache-2.0
"""`wellstrat report`, seen through a browser."""

import csv
import io
import json
import os
import subprocess
import unittest

import numpy

import browser
from support import CliTest

GENERATORS = ("pmj", "random", "sobol")
REPORT = ("report", "--quick", "--patterns", "20", "--generators", ",".join(GENERATORS),
          "--integrands", "disk,linear,disk^2")
TITLES = ("Stratified", "Random", "Sobol")
INTEGRANDS = {"Disk": "disk", "Linear": "linear", "Disk in 2 domains": "disk^2"}
SECTIONS = ("Points", "Projections of 3D points", "1D points in their order", "Spectra",
            "Errors of integrals", "Independence", "Nets", "Discrepancies and distances")
BENCH = {
    "processor": "Test <b>CPU</b> & more", "context": {"batch_target": "AVX2", "date": "today"},
    "ns": {"coherent 2D AVX2/4096": [2.0, 1.5, 1.75], "rival: gsl_sobol": [5, 7, 6, 8, 4],
           "scalar 2D": [3.5]},
    "tables_ms": [9.0, 8.0, 8.5],
}


class ReportTest(CliTest):
    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)

    def page(self, *more):
        """The report with the tests' usual options, as a browser shows it."""
        self.assertEqual(self.output_of(*REPORT, "-o", "r.html", *more), b"")
        return browser.open_page(self.path("r.html"))

    def table(self, page, *header):
        """Rows below the header of the one table whose header begins with these texts."""
        found = [rows for rows in page.tables if tuple(rows[0][:len(header)]) == header]
        self.assertEqual(len(found), 1, header)
        return found[0][1:]

    def assert_drawn(self, page, image):
        """Guards against pictures that are broken, blank or a mere frame."""
        self.assertGreater(image.naturalWidth, 200, image.alt)
        self.assertGreater(image.width, 200, image.alt)
        pixels = page.pixels_of(image)
        inner = pixels[len(pixels) // 8:-len(pixels) // 8, pixels.shape[1] // 8:]
        dark = (inner.max(axis=2) < 200).mean()
        self.assertTrue(0.003 < dark < 0.9, (image.alt, dark))

    def test_page(self):
        self.write("bench.json", json.dumps(BENCH))
        page = self.page("--bench", "bench.json")
        self.assertEqual(self.files(), ["bench.json", "r.html"])
        self.assertEqual(page.headings[1:], [*SECTIONS, "Speed", "How to make this again"])
        self.assertLess(page.width, 1300)
        self.assertEqual(len(page.images), 6 * len(GENERATORS) + 3 + 4)
        for image in page.images:
            self.assert_drawn(page, image)
        for title in TITLES:
            self.assertEqual(sum(image.alt.startswith(title + ": ") for image in page.images), 6)
        self.assertTrue(all(len(caption) > 10 for caption in page.captions))
        self.assertEqual(len(page.captions), len(page.tables) + 8)
        self.assert_self_contained(page)
        self.assert_speeds(page)
        self.assertIn("stream version", page.text)

    def assert_self_contained(self, page):
        source = self.read("r.html").decode()
        self.assertEqual(browser.outside_references(source), [])
        self.assertEqual([name for name in page.loaded if not name.startswith("data:")], [])
        self.assertNotIn("<script", source)
        self.assertLess(len(source), 4 << 20)

    def assert_speeds(self, page):
        self.assertEqual(self.table(page, "benchmark", "ns"),
                         [["coherent 2D AVX2/4096", "1.75", "7"], ["rival: gsl_sobol", "6.00", "17"],
                          ["scalar 2D", "3.50", "0"]])
        for text in ("Test <b>CPU</b> & more", "AVX2", "8.5 ms", "scripts/bench --json bench.json"):
            self.assertIn(text, page.text)

    def test_tables_say_what_the_commands_say(self):
        """Guards against numbers of another pattern, count or column, and stale commands."""
        page = self.page()
        study = self.command_in(page, "study")
        self.output_of(*study[:study.index("--plot")])
        with open(self.path("errors.csv"), encoding="utf-8") as file:
            rmse = {(row["generator"], row["integrand"], row["points"]): float(row["rmse"])
                    for row in csv.DictReader(file)}
        integrand, rows = "", self.table(page, "integrand", "generator")
        self.assertEqual(len(rows), 9)
        for row in rows:
            integrand = row[0] or integrand
            name = GENERATORS[TITLES.index(row[1])]
            for count, text in zip(("4", "16", "64", "256", "1024"), row[2:], strict=True):
                self.assertEqual(text, f"{rmse[name, INTEGRANDS[integrand], count]:#.3g}")
        self.assert_verdict(page, rmse)
        measures = json.loads(self.output_of(*self.command_in(page, "analyze"), "--json"))
        discrepancy = measures["discrepancy"]
        row = [rows for rows in page.tables if rows[0][:2] == ["generator", "star"]][0][1]
        self.assertEqual(row[:3], ["Stratified", f"{discrepancy['star'][0]:#.3g}",
                                   f"{discrepancy['l2_star']:#.3g}"])
        worst = measures["independence"][0]["worst"][0]
        self.assertEqual(self.table(page, "generator", "one")[0][:4],
                         ["Stratified", worst["first"], worst["second"], f"{worst['correlation']:.3f}"])

    def assert_verdict(self, page, rmse):
        """The geometric mean over the integrands, at 1024 points, of the best over random."""
        least, title = min(
            (numpy.prod([rmse[name, integrand, "1024"] / rmse["random", integrand, "1024"]
                         for integrand in INTEGRANDS.values()]) ** (1 / 3), title)
            for name, title in zip(GENERATORS, TITLES))
        self.assertIn(f"With 1024 points, “{title}” has the least error of integrals of these 3: "
                      f"{least:.2g} of that of “Random”, in the geometric mean.", page.text)

    def test_readers_see_no_identifiers(self):
        page = self.page()
        before, commands = page.text.rsplit("How to make this again", 1)
        text = before[before.rindex("name in commands") + 100:]
        for name in ("pmj", "wrap_around", "disk^2", "r.html"):
            self.assertNotIn(name, text)
        self.assertIn("pmj", commands)
        self.assertIn("0 (0)", page.marked)

    def test_narrow_windows(self):
        """Nothing but tables, which scroll, is wider than the window, and pictures fill it."""
        self.output_of(*REPORT, "-o", "r.html")
        page = browser.open_page(self.path("r.html"), 480)
        self.assertEqual(page.width, 480)
        for image in page.images:
            self.assertGreater(image.width, 430, image.alt)
            self.assertLess(image.x + image.width, 480, image.alt)

    def command_in(self, page, subcommand):
        """The arguments of the first command of this name that the page shows."""
        line = next(line for line in page.text.splitlines()
                    if line.startswith(f"wellstrat {subcommand} "))
        return [word.strip("'") for word in line.split()[1:]]

    def test_faults_are_visible(self):
        """sobol is the same in all patterns, random is unstratified: the page must show both."""
        page = self.page()
        nets = {row[0]: row[1:] for row in self.table(page, "generator", "x", "y", "z", "(x, y)")}
        self.assertEqual(nets["Stratified"][:4], ["0 (0)"] * 4)
        self.assertEqual(nets["Stratified"][-2:], ["1 (1)", "one point each"])
        self.assertEqual(nets["Random"][-1], "not one each")
        families = {tuple(row[:2]): [float(cell) for cell in row[4:]]
                    for row in self.table(page, "generator", "between")}
        self.assertEqual(len(families), 9)
        self.assertGreater(families["Sobol", "patterns"][1], 10)
        self.assertLess(families["Sobol", "patterns"][2], 1e-30)
        for title in ("Stratified", "Random"):
            self.assertLess(families[title, "patterns"][1], 1.5)
            self.assertGreater(families[title, "patterns"][2], 1e-3)
        slopes = {row[0]: row[1:] for row in self.table(page, "integrand", "Stratified")}
        self.assertLess(float(slopes["Linear"][0].split()[0]), -1.3)
        self.assertAlmostEqual(float(slopes["Linear"][1].split()[0]), -0.5, delta=0.2)
        self.assert_spectra(page)

    def assert_spectra(self, page):
        """The middle of the first periodogram is dark for nets and gray for random."""
        gray = {}
        for image in page.images:
            if "periodograms" in image.alt:
                pixels = page.pixels_of(image).astype(float)
                height, third = len(pixels), pixels.shape[1] / 3
                band = pixels[int(height * 0.3):int(height * 0.9), int(third * 0.3):int(third * 0.7)]
                rows, columns = band.shape[0], band.shape[1]
                middle = band[rows * 2 // 5:rows * 3 // 5, columns * 2 // 5:columns * 3 // 5]
                gray[image.alt.split(":")[0]] = middle.mean()
        self.assertLess(gray["Stratified"], 60)
        self.assertGreater(gray["Random"], 100)

    def test_threads_change_nothing(self):
        cores = os.sched_getaffinity(0)
        self.output_of(*REPORT, "-o", "r.html")
        self.output_of(*REPORT, "-o", "one.html",
                       preexec_fn=lambda: os.sched_setaffinity(0, {min(cores)}))
        self.assertEqual(self.read("r.html"), self.read("one.html"))

    def test_kept_files_draw_the_pictures_again(self):
        self.output_of("report", "--quick", "--patterns", "2", "--generators", "pmj",
                       "--integrands", "disk", "--keep-plot-files")
        stems = [f"report-{name}" for name in ("anisotropy", "error-disk", "order-pmj", "pairs",
                                               "points-pmj", "projection-xy-pmj", "projection-xz-pmj",
                                               "projection-yz-pmj", "radial", "spectrum-pmj")]
        self.assertEqual(self.files(), sorted(["report.html", *(
            stem + suffix for stem in stems for suffix in (".dat", ".gp", ".svg"))]))
        for stem in stems:
            picture = self.read(stem + ".svg")
            os.remove(self.path(stem + ".svg"))
            subprocess.run(["gnuplot", "--default-settings", stem + ".gp"], cwd=self.directory,
                           check=True, timeout=60)
            self.assertEqual(self.read(stem + ".svg"), picture, stem)

    def test_bad_arguments(self):
        self.write("text.json", "text")
        self.write("empty.json", "{}")
        self.write("negative.json", json.dumps({**BENCH, "ns": {"a": [-1]}}))
        self.write("points.csv", "0.5,0.5\n")
        for arguments, mentions in (
                (("-o", "r.txt"), ".html"), (("-o", "none/r.html"), "none/r.html"),
                (("--generators", "sobl"), "no generator is called 'sobl'"),
                (("--generators", "file:points.csv"), "file:points.csv"),
                (("--integrands", "dsk"), "no integrand is called 'dsk'"),
                (("--integrands", "edges,boxes"), "--integrands: at most 36"),
                (("--patterns", "1"), "--patterns"), (("--count", "100"), "no power of two"),
                (("--count", "2"), "--count"), (("--quick", "--thorough"), "--thorough"),
                (("--bench", "none.json"), "none.json"),
                (("--bench", "text.json"), "scripts/bench --json writes: it is no JSON from byte"),
                (("--bench", "empty.json"), "scripts/bench --json writes: processor, context"),
                (("--bench", "negative.json"), "not above 0")):
            self.assert_fails("report", *arguments, mentions=mentions)

    def test_slots(self):
        self.output_of("report", "--quick", "--patterns", "4", "--count", "64", "--generators",
                       "long:3+7,joint:1,blue:0+1", "--integrands", "disk^2", "-o", "r.html")
        page = self.read("r.html").decode()
        for text in ("Stratified, long, slots 3+7", "Stratified jointly, slots 1", "long:3+7",
                     "slots of blue, for one domain each"):
            self.assertIn(text, page)

    def test_no_file_without_gnuplot(self):
        self.assert_fails(*REPORT, env={**os.environ, "PATH": self.directory}, mentions="gnuplot")


class BrowserTest(CliTest):
    """The tests' own eyes: broken pages must look broken."""

    def open(self, body):
        with open(self.path("page.html"), "w", encoding="utf-8") as file:
            file.write(f"<!DOCTYPE html><title>A &amp; B</title><body>{body}")
        return browser.open_page(self.path("page.html"))

    def test_what_is_there(self):
        page = self.open("<h1>One</h1><h2>Two</h2><table><tr><th>a<td>1</table>"
                         "<p style='width:2000px;height:3000px;background:#f00'>text")
        self.assertEqual((page.title, page.headings), ("A & B", ["One", "Two"]))
        self.assertEqual(page.tables, [[["a", "1"]]])
        self.assertGreater(page.width, 2000)
        self.assertEqual(page.screenshot.shape, (page.height, 1280, 3))
        self.assertTrue(numpy.array_equal(page.screenshot[2000, 1000], [255, 0, 0]))

    def test_broken_pictures(self):
        page = self.open("<img alt=x src='data:image/png;base64,AAAA'><img alt=y src='no.svg'>")
        self.assertEqual([image.naturalWidth for image in page.images], [0, 0])

    def test_outside_references(self):
        for text in ("<img src=http://a.b/c.png>", "<link rel=stylesheet href='style.css'>",
                     "<style>p {background: url(\"//a.b/c\")}</style>", "<img srcset='a.png 2x'>",
                     "<style>@import 'a.css';</style>", "<a href=\"https://a.b\">"):
            self.assertEqual(len(browser.outside_references(text)), 1, text)
        self.assertEqual(browser.outside_references(
            "<img src=\"data:image/png;base64,AA\"><a href='#top'>http://a.b"), [])


if __name__ == "__main__":
    unittest.main()
