# SPDX-License-Identifier: Apache-2.0
"""`wellstrat domains`."""

import json
import math
import re
import unittest

from support import CliTest

SMALL = ("--size", "24x18", "--depth", "0", "--spp", "16", "--seeds", "8")
ROW = re.compile(r"^  (\w[\w ]*\w) +(-?\d\.\d{3}) \+- (\d\.\d{3})$", re.MULTILINE)


def rows(text):
    """(part, its standard error) by name."""
    return {name: tuple(map(float, numbers)) for name, *numbers in ROW.findall(text)}


class DomainsTest(CliTest):
    def table(self, *arguments):
        return rows(self.output_of("domains", *arguments).decode())

    def test_parts(self):
        table = self.table("spherelight", *SMALL, "--generators",
                           "pmj,random,joint,long,blue", "-o",
                           "d.json")
        self.assertEqual(list(table), ["pixel filter", "light 0", "bxdf 0", "sum", "floor", "pmj",
                                       "random", "joint", "long", "blue"])
        parts = [table[name] for name in ("pixel filter", "light 0", "bxdf 0")]
        for part, error in parts:
            self.assertGreater(part, -5 * error - 0.001)
        total = sum(part for part, _ in parts)
        self.assertAlmostEqual(table["sum"][0], total, delta=0.003)
        self.assertAlmostEqual(table["floor"][0], math.sqrt(total), delta=0.003)
        self.assertLess(table["floor"][0], 1)
        self.assertEqual(table["pmj"][0], 1)
        self.assertGreater(table["random"][0], 1.5)
        self.assertEqual(self.files(), ["d.json"])
        result = json.loads(self.read("d.json"))
        self.assertEqual((result["scene"], result["size"], result["samples"], result["seeds"]),
                         ("spherelight", [24, 18], 16, 8))
        for entry in result["domains"] + [result["sum"]]:
            for number, key in zip(table[entry["name"]], ("part", "standard_error")):
                self.assertAlmostEqual(entry[key], number, delta=0.0006)
        self.assertEqual([entry["name"] for entry in result["generators"]],
                         ["pmj", "random", "joint", "long", "blue"])

    def test_a_lamp_in_view_is_an_error_of_the_pixel_alone(self):
        """The lamp of `cornell` is far brighter than all else: its edge in view has most of the
        error, and there nothing but the place in the pixel decides."""
        self.assertGreater(self.table("cornell", *SMALL)["pixel filter"][0], 0.5)

    def test_domains_that_the_image_does_not_use_are_left_out(self):
        self.assertNotIn("lens", self.table("cornell", *SMALL))
        self.assertNotIn("environment 0", self.table("cornell", *SMALL))
        table = self.table("lens", *SMALL)
        self.assertIn("lens", table)
        self.assertNotIn("light 1", table)

    def test_without_errors_there_are_no_parts(self):
        table = self.table("cornell", *SMALL, "--camera", "0,0,-5", "--look-at", "0,0,-10")
        self.assertEqual(table, {name: (0, 0) for name in ("sum", "floor", "joint")})

    def test_it_ends_with_what_to_do(self):
        def advice(*arguments):
            return self.output_of("domains", *arguments).decode().splitlines()[-1]

        padded = ("lens", "--size", "24x16", "--depth", "0", "--seeds", "8", "--spp")
        gain = advice(*padded, "256")
        self.assertRegex(gain, r"^What to do: take joint, whose error is 0\.[67]\d of that of pmj\.")
        self.assertIn("none of the generators tried has less",
                      advice(*padded, "64", "--generators", "random"))
        self.assertRegex(advice("cornell", *SMALL), "within domains.* 'pixel filter'")
        self.assertEqual(advice("cornell", *SMALL, "--camera", "0,0,-5", "--look-at", "0,0,-10"),
                         "What to do: nothing, there is no error.")

    def test_bad_arguments(self):
        for arguments, mentions in (
                ((), "scene"), (("nothing",), "nothing"), (("cornell", "--spp", "0"), "--spp"),
                (("cornell", "--seeds", "1"), "--seeds"),
                (("cornell", "--generators", "sobl"), "sobl"),
                (("cornell", "-o", "d.csv"), ".json"),
                (("cornell", "-o", "none/d.json"), "none/d.json"),
                (("cornell", "--size", "9000x9000", "--seeds", "1000"), "--seeds")):
            self.assert_fails("domains", *arguments, mentions=mentions)

    def test_interrupt_leaves_nothing(self):
        self.assert_interrupt_leaves_nothing("domains", "cornell", "--spp", "100000", "-o",
                                             "d.json")


if __name__ == "__main__":
    unittest.main()
