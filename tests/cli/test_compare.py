# SPDX-License-Identifier: Apache-2.0
"""`wellstrat compare`, seen through a browser."""

import re
import unittest

import numpy
import PIL.Image

import browser
from support import CliTest

SCENE = ("spherelight", "--size", "40x30", "--depth", "0")
COMPARE = ("compare", *SCENE, "--spp", "1,4,16", "--reference-spp", "256", "-o", "c.html")
TITLES = {"pmj": "Stratified", "random": "Random"}
ROWS = [(generator, samples) for generator in ("pmj", "random") for samples in (1, 4, 16)]


def numbers(row):
    return [float(cell) for cell in row[1:]]


class CompareTest(CliTest):
    def assert_printed(self, line, row):
        """A line says the same as a row, whose errors have three digits."""
        printed = [float(x) for x in line.split()[1:]]
        self.assertEqual(len(printed), len(row) - 1)
        for number, shown in zip(printed, numbers(row)):
            self.assertLessEqual(abs(number - shown), 0.0051 * number, row)

    def test_page(self):
        printed = self.output_of(*COMPARE).decode().splitlines()
        self.assertEqual(self.files(), ["c.html"])
        self.assertEqual(browser.outside_references(self.read("c.html").decode()), [])
        page = browser.open_page(self.path("c.html"))
        self.assertEqual(page.loaded, [])
        self.assertLess(page.width, 1300)
        self.assertEqual(page.headings, ["Samples compared in pictures", "Side by side", "Errors",
                                         "Spectra", "Reference", "How to make this again"])
        self.assertEqual(len(page.images), 1 + 4 + 3 + 3 * 2 * 3)
        for image in page.images:
            self.assertGreater(image.naturalWidth, 0, image.alt)
        self.assertIn("--reference-spp 256 --filter 2 -o", page.text)

        ratios, (header, *rows) = page.tables
        self.assertEqual(header, ["generator", "samples", "RMSE", "relative MSE", "RMSE at 2px",
                                  "seconds", "as samples of Random"])
        self.assertEqual([(row[0], int(row[1])) for row in rows],
                         [(TITLES[name], samples) for name, samples in ROWS])
        # What is printed says the same.
        for line, row in zip(printed[2:], rows):
            self.assert_printed(line, row)
        self.assertEqual([line.split()[1:] for line in printed[-2:]], [row[1:] for row in ratios[1:]])
        table = {(name, samples): numbers(row)[1:] for (name, samples), row in zip(ROWS, rows)}
        for samples in (1, 4, 16):
            self.assertAlmostEqual(table["random", samples][4], samples, delta=0.11)
        # Stratification helps where light changes slowly: at 16 samples by far more than by the
        # factor 4 that is asked for here.
        self.assertGreater(table["pmj", 16][4], 64)
        self.assertLess(table["pmj", 16][0], table["pmj", 4][0])
        # A blur lowers errors that are not correlated.
        for rmse, _, filtered, _, _ in table.values():
            self.assertLess(filtered, 0.7 * rmse)
        self.assertEqual(ratios[0], ["generator", "filter", "1 sample", "4 samples", "16 samples"])
        exact = {row: [float(x) for x in line.split()[2:]] for row, line in zip(ROWS, printed[2:])}
        for (_, name, *cells), column in zip(ratios[1:], (0, 2)):
            self.assertEqual(name, {0: "none", 2: "2px"}[column])
            for samples, cell in zip((1, 4, 16), cells):
                ratio = exact["pmj", samples][column] / exact["random", samples][column]
                self.assertAlmostEqual(float(cell), ratio, delta=0.0011)
        # The verdict is that of the tables.
        ratio, samples = float(ratios[1][4]), table["pmj", 16][4]
        self.assertEqual(page.text.splitlines()[2],
                         f"With 16 samples of each pixel, “Stratified” has {ratio:.2f} of the error "
                         f"of “Random”, which needs about {samples:.0f} for the same.")
        # The least errors of each number of samples, of three kinds, are marked.
        self.assertEqual(len(page.marked), 9)
        self.assertIn(rows[2][2], page.marked)
        self.assertNotIn(rows[5][2], page.marked)

    def test_readers_see_no_identifiers(self):
        self.output_of(*COMPARE, "--generators", "pmj,joint,blue,random")
        page = browser.open_page(self.path("c.html"))
        before, command = page.text.rsplit("How to make this again", 1)
        self.assertIn("pmj,joint,blue,random", command)
        for name in ("pmj", "joint,", "spherelight", "c.html"):
            self.assertNotIn(name, before)
        self.assertIn("a diffuse plane lit by a sphere", before)
        for label in ("Stratified", "Stratified jointly", "Stratified, blue noise", "Random"):
            self.assertEqual(page.labels.count(label), 3 * 2)
        self.assertEqual(page.labels.count("Reference"), 3 * 2 + 1)

    def test_narrow_windows(self):
        """Nothing but tables, which scroll, is wider than the window, and pictures fill it."""
        self.output_of(*COMPARE)
        page = browser.open_page(self.path("c.html"), 480)
        self.assertEqual(page.width, 480)
        for image in page.images:
            self.assertGreater(image.width, 200, image.alt)
            self.assertLess(image.x + image.width, 480, image.alt)
            if image.alt.startswith(("RMSE", "Spectra")):
                self.assertGreater(image.width, 430)

    def test_axes_end_with_the_data(self):
        self.output_of(*COMPARE, "--keep-plot-files")
        script = self.read("c-rmse.gp").decode()
        self.assertIn("set xrange [1:16]\nset xtics (1, 2, 4, 8, 16)\n", script)
        values = [float(line.split()[1]) for line in self.read("c-rmse.dat").decode().splitlines()
                  if line and line[0] != "#"]
        self.assertEqual(len(values), 6)
        low, high = re.search(r"set yrange \[(.*):(.*)\]", script).groups()
        self.assertEqual((float(low), float(high)), (min(values), max(values)))

    def test_crops_show_the_noise(self):
        """Guards against pictures under wrong names: the more samples, the nearer the reference."""
        self.output_of("compare", "cornell", "--size", "64x48", "--spp", "1,16",
                       "--reference-spp", "512", "-o", "c.html")
        page = browser.open_page(self.path("c.html"))
        # Browsers draw pictures of one size a pixel larger or smaller.
        pixels = {image.alt: page.pixels_of(image).astype(float)[:200, :280] for image in page.images}
        reference = pixels["The same part of the reference"]

        def difference(generator, samples):
            image = pixels[f"{generator}, {samples} of each pixel"]
            return numpy.abs(image - reference).mean()

        for generator in TITLES.values():
            few, many = (difference(generator, n) for n in ("1 sample", "16 samples"))
            self.assertTrue(0 < many < 0.6 * few, (generator, few, many))
        self.assertLess(difference("Stratified", "16 samples"), difference("Random", "16 samples"))
        filtered = pixels["The same part of the reference, filtered at 2px"]
        self.assertGreater(numpy.abs(filtered - reference).mean(), 1)
        for generator in TITLES.values():
            image = pixels[f"{generator}, 1 sample of each pixel, filtered at 2px"]
            self.assertLess(numpy.abs(image - filtered).mean(), 0.6 * difference(generator, "1 sample"))

    def test_reference_from_file(self):
        self.output_of("render", *SCENE, "--seed", "7", "--spp", "256", "-o", "ref.exr")
        arguments = ("compare", *SCENE, "--generators", "pmj", "--spp", "4", "-o", "c.html")
        text = self.output_of(*arguments, "--reference", "ref.exr").decode()
        self.assertIn("reference: ref.exr, by pmj", text)
        self.assertEqual(len(text.splitlines()), 3)
        self.output_of("render", *SCENE, "-o", "same.exr")
        self.output_of("render", *SCENE[:-1], "2", "--seed", "7", "-o", "deep.exr")
        self.output_of("render", *SCENE, "--fov", "9", "--seed", "7", "-o", "fov.exr")
        self.output_of("render", *SCENE, "-o", "picture.png")
        for name, mentions in (("same.exr", "seed"), ("deep.exr", "differs in: depth"),
                               ("fov.exr", "differs in: scene"), ("none.exr", "none.exr"),
                               ("picture.png", "no exact sums")):
            self.assert_fails(*arguments, "--reference", name, mentions=mentions)
        self.assert_fails("compare", "spherelight", "--depth", "0", "--reference", "ref.exr", "-o", "c.html",
                          mentions="40x30 pixels, not")

    def test_without_errors_there_are_no_curves(self):
        """A picture of nothing: logarithmic axes have no place for errors of 0."""
        text = self.output_of("compare", "cornell", "--camera", "0,0,-5", "--look-at", "0,0,-10",
                              "--size", "16x16", "--spp", "1,4", "-o", "c.html",
                              "--keep-plot-files").decode()
        self.assertNotIn("nan", text)
        self.assertEqual(self.files(), ["c.html"])
        page = browser.open_page(self.path("c.html"))
        self.assertIn("there are no error curves", page.text)
        self.assertNotIn("Spectra", page.headings)
        self.assertEqual(len(page.images), 1 + 2 * 2 * 3)
        self.assertEqual(page.tables[0][1:], [["Stratified", "none", "-", "-"],
                                                  ["Stratified", "2px", "-", "-"]])
        self.assertEqual(page.marked, [])
        self.assertIn("No image differs from the reference.", page.text)

    def test_errors_from_seeds(self):
        """With --seeds there is no reference, and the errors are those against one."""
        same = ("compare", *SCENE, "--generators", "pmj,joint,random", "--spp", "4,16", "-o", "c.html")
        by_seeds = self.output_of(*same, "--seeds", "6").decode().splitlines()
        page = browser.open_page(self.path("c.html"))
        against_reference = self.output_of(*same, "--reference-spp", "4096").decode().splitlines()
        self.assertIn("its 6 seeds", by_seeds[0])
        self.assertIn("--seeds 6", page.text)
        _, (header, *rows) = page.tables
        self.assertEqual(header[-2:], ["± RMSE", "± at 2px"])
        self.assertEqual(len(by_seeds), 2 + 6 + 3 + 4)
        for line, other, row in zip(by_seeds[2:], against_reference[2:], rows):
            self.assert_printed(line, row)
            rmse, relative, filtered, *_, rmse_error, filtered_error = numbers(row)[1:]
            expected = [float(x) for x in other.split()[2:5]]
            self.assertTrue(0 < rmse_error < 0.2 * rmse)
            self.assertTrue(0 < filtered_error < 0.5 * filtered)
            # Against the reference there is one image, whose error varies 6^(1/2) times as much; 5 of
            # these and a tenth for uncertain uncertainties are exceeded by chance once in 10^5 runs.
            self.assertAlmostEqual(rmse, expected[0], delta=0.1 * rmse + 5 * 7 ** 0.5 * rmse_error)
            self.assertAlmostEqual(filtered, expected[2],
                                   delta=0.1 * filtered + 5 * 7 ** 0.5 * filtered_error)
            self.assertAlmostEqual(relative, expected[1], delta=0.5 * relative)

    def test_plot_files(self):
        self.output_of(*COMPARE, "--keep-plot-files")
        names = ("relative-mse", "rmse", "rmse-2px", "spectrum-1", "spectrum-16", "spectrum-4", "time")
        self.assertEqual(self.files(), sorted(["c.html", *(
            f"c-{name}.{suffix}" for name in names for suffix in ("dat", "gp", "svg"))]))
        for name in names:
            self.assertEqual(self.read(f"c-{name}.dat").count(b"# curve"), 2)

    def test_filters(self):
        """One after the other, sorted; that of a tenth of a pixel changes nothing."""
        counts = (1, 2, 3, 6)
        lines = self.output_of(*COMPARE[:-6], "--spp", "1,2,3,6", "--reference-spp", "256", "-o",
                               "c.html", "--filter", "4,0.1", "--filter", "1", "--generators",
                               "pmj,joint,random").decode().splitlines()
        self.assertEqual(lines[1].split("MSE")[-1].split()[:6], ["at", "0.1px", "at", "1px", "at",
                                                                 "4px"])
        rows = [line.split() for line in lines[2:14]]
        self.assertEqual([(row[0], int(row[1])) for row in rows],
                         [(name, n) for name in ("pmj", "joint", "random") for n in counts])
        for _, _, rmse, _, *filtered, _, _ in rows:
            self.assertEqual(filtered[0], rmse)
            self.assertTrue(float(filtered[2]) < float(filtered[1]) < float(rmse))
        self.assertEqual([tuple(line.split()[:2]) for line in lines[17:]],
                         [(name, after) for name in ("pmj", "joint")
                          for after in ("none", "0.1px", "1px", "4px")])
        alts = [image.alt for image in browser.open_page(self.path("c.html")).images]
        for name in ("Stratified", "Stratified jointly", "Random"):
            self.assertIn(f"{name}, 3 samples of each pixel", alts)
            self.assertIn(f"{name}, 3 samples of each pixel, filtered at 4px", alts)

    def test_spectra(self):
        """Random samples have white noise. In 40 x 30 pixels it is known to a tenth, but three
        colors that know of each other and pixels that are brighter count for less than their
        number; 0.4 is four times what other seeds show."""
        self.output_of(*COMPARE, "--keep-plot-files")
        sets = [one for samples in (1, 4, 16)
                for one in self.read(f"c-spectrum-{samples}.dat").decode().split("# curve")[1:]]
        self.assertEqual([int(one.split()[0]) for one in sets], 3 * [0, 1])
        for place, one in enumerate(sets):
            rings = numpy.array([line.split() for line in one.split("\n")[1:] if line], float)
            numpy.testing.assert_allclose(rings[:, 0], numpy.arange(1, 16) / 30, rtol=1e-8)
            self.assertTrue((rings[:, 1] > 0).all())
            if place % 2 == 1:  # random
                mean = numpy.average(rings[:, 1], weights=rings[:, 0])
                self.assertAlmostEqual(mean, 1, delta=0.4)

    def mean_square(self, *mask):
        """(The first line about the mask, the mean squared errors of pmj with 1 and 4 samples.)"""
        lines = self.output_of("compare", *SCENE, "--generators", "pmj,pmj", "--spp", "1,4",
                               "--reference", "ref.exr", "-o", "c.html", *mask).decode().splitlines()
        return lines[1], numpy.array([float(line.split()[2]) ** 2 for line in lines[-2:]])

    def save_mask(self, name, value, size=(40, 30)):
        """A picture with value(x, y), from 0 to 255."""
        picture = PIL.Image.new("L", size)
        picture.putdata([value(x, y) for y in range(size[1]) for x in range(size[0])])
        picture.save(self.path(name))

    def test_masks(self):
        """Mean squares over two parts, by their sizes, are that over all pixels."""
        self.output_of("render", *SCENE, "--seed", "7", "--spp", "256", "-o", "ref.exr")
        self.save_mask("left.png", lambda x, y: 1 if x < 10 else 0)
        self.save_mask("right.png", lambda x, y: 255 if x >= 10 else 0)
        _, everywhere = self.mean_square()
        said, left = self.mean_square("--mask", "left.png")
        self.assertEqual(said, "errors of 25.0 % of the pixels, those that are not black in "
                               "left.png")
        self.assertIn("--mask left.png", browser.open_page(self.path("c.html")).text)
        _, right = self.mean_square("--mask", "right.png")
        numpy.testing.assert_allclose(0.25 * left + 0.75 * right, everywhere, rtol=1e-3)

        said, smooth = self.mean_square("--mask", "smooth")
        share = float(said.split()[2])
        self.assertTrue(2 < share < 90, share)
        self.assertTrue((smooth < everywhere).all())
        page = browser.open_page(self.path("c.html"))
        white, = (image for image in page.images if image.alt == "The pixels that count")
        self.assertAlmostEqual(100 * (page.pixels_of(white)[1:-1, 1:-1] > 127).mean(), share, delta=6)

    def test_smooth_areas_by_seeds(self):
        """They are those of a reference that serves for nothing else: of the same one, whatever is
        compared, and none of the images decides which of its pixels count."""
        same = (*SCENE, "--spp", "1,16", "-o", "c.html", "--reference-spp", "512", "--mask", "smooth")
        mask = self.output_of("compare", *same).decode().splitlines()[1]
        self.assertRegex(mask, "errors of .* % of the pixels, the smooth areas of twice 256")
        by_seeds = self.output_of("compare", *same, "--seeds", "4").decode().splitlines()
        self.assertIn("its 4 seeds", by_seeds[0])
        self.assertEqual(by_seeds[1], mask)
        alone = self.output_of("compare", *same, "--seeds", "4", "--generators",
                               "random").decode().splitlines()
        self.assertEqual(alone[1], mask)
        self.assertEqual(alone[3].split()[:5], by_seeds[5].split()[:5])
        self.assertIn("--seeds 4 --reference-spp 512 --filter 2 --mask smooth",
                      browser.open_page(self.path("c.html")).text)

    def test_bad_masks(self):
        self.save_mask("black.png", lambda x, y: 0)
        self.save_mask("small.png", lambda x, y: 1, (40, 29))
        with open(self.path("text.png"), "w", encoding="ascii") as file:
            file.write("no picture")
        for mask, mentions in (("none.png", "none.png"), ("text.png", "text.png"),
                               ("rough", "'rough' is neither 'smooth' nor a picture"),
                               ("black.png", "no pixel would count"), ("small.png", "40x29")):
            self.assert_fails(*COMPARE, "--mask", mask, mentions=mentions)
        # The noise of two samples is nowhere smooth.
        self.assert_fails("compare", "lens", "--size", "24x18", "--spp", "1", "--reference-spp",
                          "2", "-o", "c.html", "--mask", "smooth", mentions="smooth")

    def test_bad_arguments(self):
        for arguments, mentions in (
                ((), "scene"), (("spherelight",), "--output"),
                (("spherelight", "-o", "c.txt"), ".html"),
                (("nothing", "-o", "c.html"), "nothing"),
                ((*SCENE, "-o", "c.html", "--spp", "0"), "--spp"),
                ((*SCENE, "-o", "c.html", "--spp", "1,x"), "--spp"),
                ((*SCENE, "-o", "c.html", "--filter", "0"), "--filter"),
                ((*SCENE, "-o", "c.html", "--filter", "-1"), "--filter"),
                ((*SCENE, "-o", "c.html", "--filter", "2,101"), "from 0.1 to 100"),
                ((*SCENE, "-o", "c.html", "--filter", "nan"), "--filter"),
                ((*SCENE, "-o", "c.html", "--filter", "2x"), "--filter"),
                ((*SCENE, "-o", "c.html", "--generators", "pmj,sobl"), "sobl"),
                ((*SCENE, "-o", "c.html", "--reference-spp", "0"), "--reference-spp"),
                ((*SCENE, "-o", "c.html", "--reference-spp", "9", "--reference", "r.exr"),
                 "--reference"),
                ((*SCENE, "-o", "c.html", "--seeds", "1"), "--seeds"),
                ((*SCENE, "-o", "c.html", "--seeds", "256"), "--seeds"),
                ((*SCENE, "-o", "c.html", "--seeds", "4", "--reference-spp", "9"), "--seeds"),
                ((*SCENE, "-o", "c.html", "--seeds", "4", "--reference", "r.exr"), "--seeds"),
                ((*SCENE, "-o", "none/c.html"), "none/c.html")):
            self.assert_fails("compare", *arguments, mentions=mentions)

    def test_interrupt_leaves_nothing(self):
        self.assert_interrupt_leaves_nothing("compare", "cornell", "-o", "c.html",
                                             "--reference-spp", "1000000")


if __name__ == "__main__":
    unittest.main()
