# SPDX-License-Identifier: Apache-2.0
"""`wellstrat compare`, seen through a browser."""

import unittest

import numpy

import browser
from support import CliTest

SCENE = ("spherelight", "--size", "40x30", "--depth", "0")
COMPARE = ("compare", *SCENE, "--spp", "1,4,16", "--reference-spp", "256", "-o", "c.html")
ROWS = [(generator, samples) for generator in ("pmj", "random") for samples in (1, 4, 16)]


def numbers(row):
    return [float(cell) for cell in row[1:]]


class CompareTest(CliTest):
    def test_page(self):
        printed = self.output_of(*COMPARE).decode().splitlines()
        self.assertEqual(self.files(), ["c.html"])
        self.assertEqual(browser.outside_references(self.read("c.html").decode()), [])
        page = browser.open_page(self.path("c.html"))
        self.assertEqual(page.loaded, [])
        self.assertLess(page.width, 1300)
        self.assertEqual(page.headings, ["spherelight: generators compared", "Reference", "Errors",
                                         "Side by side", "How to make this again"])
        self.assertEqual(len(page.images), 1 + 1 + 3 * 3)
        for image in page.images:
            self.assertGreater(image.naturalWidth, 0, image.alt)
        self.assertIn("--reference-spp 256", page.text)

        (header, *rows), = page.tables
        self.assertEqual(header, ["generator", "samples", "RMSE", "relative MSE", "filtered RMSE",
                                  "seconds", "samples of random"])
        self.assertEqual([(row[0], int(row[1])) for row in rows], ROWS)
        # What is printed says the same.
        for line, row in zip(printed[2:], rows):
            self.assertEqual([float(x) for x in line.split()[1:]], numbers(row))
        table = {(row[0], int(row[1])): numbers(row)[1:] for row in rows}
        for samples in (1, 4, 16):
            self.assertAlmostEqual(table["random", samples][4], samples, delta=0.11)
        # Stratification helps where light changes slowly: at 16 samples by far more than by the
        # factor 4 that is asked for here.
        self.assertGreater(table["pmj", 16][4], 64)
        self.assertLess(table["pmj", 16][0], table["pmj", 4][0])
        # A blur lowers errors that are not correlated.
        for rmse, _, filtered, _, _ in table.values():
            self.assertLess(filtered, 0.7 * rmse)

    def test_crops_show_the_noise(self):
        """Guards against pictures under wrong names: the more samples, the nearer the reference."""
        self.output_of("compare", "cornell", "--size", "64x48", "--spp", "1,16",
                       "--reference-spp", "512", "-o", "c.html")
        page = browser.open_page(self.path("c.html"))
        pixels = {image.alt: page.pixels_of(image).astype(float) for image in page.images}
        reference = pixels["The same part of the reference"]

        def difference(generator, samples):
            image = pixels[f"{generator}, {samples} of each pixel"]
            return numpy.abs(image - reference).mean()

        for generator in ("pmj", "random"):
            few, many = (difference(generator, n) for n in ("1 sample", "16 samples"))
            self.assertTrue(0 < many < 0.6 * few, (generator, few, many))
        self.assertLess(difference("pmj", "16 samples"), difference("random", "16 samples"))

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
        self.assertEqual(len(page.images), 1 + 2 * 3)

    def test_errors_from_seeds(self):
        """With --seeds there is no reference, and the errors are those against one."""
        same = ("compare", *SCENE, "--generators", "pmj,joint,random", "--spp", "4,16", "-o", "c.html")
        by_seeds = self.output_of(*same, "--seeds", "6").decode().splitlines()
        page = browser.open_page(self.path("c.html"))
        against_reference = self.output_of(*same, "--reference-spp", "4096").decode().splitlines()
        self.assertIn("its 6 seeds", by_seeds[0])
        self.assertIn("--seeds 6", page.text)
        (header, *rows), = page.tables
        self.assertEqual(header[-2:], ["+- RMSE", "+- filtered"])
        self.assertEqual(len(by_seeds), 2 + 6)
        for line, other, row in zip(by_seeds[2:], against_reference[2:], rows):
            self.assertEqual([float(x) for x in line.split()[1:]], numbers(row))
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
        self.assertEqual(self.files(), ["c-errors.dat", "c-errors.gp", "c-errors.svg", "c.html"])
        self.assertEqual(self.read("c-errors.dat").count(b"# curve"), 2)

    def test_bad_arguments(self):
        for arguments, mentions in (
                ((), "scene"), (("spherelight",), "--output"),
                (("spherelight", "-o", "c.txt"), ".html"),
                (("nothing", "-o", "c.html"), "nothing"),
                ((*SCENE, "-o", "c.html", "--spp", "0"), "--spp"),
                ((*SCENE, "-o", "c.html", "--spp", "1,x"), "--spp"),
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
