# SPDX-License-Identifier: Apache-2.0
"""`wellstrat tables`: the exported numbers are the tables that samples come from."""

import array
import functools
import operator
import re
import shutil
import subprocess
import unittest

from support import CliTest, floats, read_csv, read_npy, words

TABLES, SIZE = 384, 4096


class TablesTest(CliTest):
    def export(self, name, *arguments):
        self.output_of("tables", "--export", name, *arguments)
        return self.read(name)

    def assert_same(self, a, b):
        """assertEqual, which would take hours over the difference of millions of numbers."""
        self.assertEqual(len(a), len(b))
        self.assertTrue(all(map(operator.eq, a, b)))

    def test_npy_and_bin_hold_equal_values(self):
        kind, shape, data = read_npy(self.export("tables.npy"))
        self.assertEqual((kind, shape), ("<u4", (TABLES, SIZE, 3)))
        self.assert_same(data, self.export("tables.bin"))
        kind, shape, float_data = read_npy(self.export("tables.npy", "--type", "float32"))
        self.assertEqual((kind, shape), ("<f4", (TABLES, SIZE, 3)))
        self.assert_same(float_data, self.export("tables.bin", "--type", "float32"))
        self.assert_same([value / 2**32 for value in words(data)], floats(float_data))

    def test_header_holds_equal_values(self):
        values = words(self.export("tables.bin"))
        text = self.export("tables.h").decode()
        self.assertIn(f"uint32_t wellstrat_tables[{TABLES}][{SIZE}][3]", text)
        literals = re.findall(r"\b0x([0-9a-f]+)u", text)
        self.assert_same([int(literal, 16) for literal in literals], values)
        text = self.export("tables.h", "--type", "float32").decode()
        self.assertIn(f"float wellstrat_tables[{TABLES}][{SIZE}][3]", text)
        literals = re.findall(r"\b(\d\S*)f\b", text)
        rounded = array.array("f", [float(literal) for literal in literals])
        self.assert_same([value * 2**32 for value in rounded], values)

    def test_layouts_hold_the_same_points_in_the_order_of_memory(self):
        everything = words(self.export("words.bin", "--layout", "words"))
        xy = words(self.export("xy.bin", "--layout", "xy"))
        z = words(self.export("z.bin", "--layout", "z"))
        self.assert_same(everything, xy + z)
        kind, shape, data = read_npy(self.export("z.npy", "--layout", "z"))
        self.assertEqual((kind, shape), ("<u4", (TABLES * SIZE,)))
        self.assert_same(words(data), z)

        values = words(self.export("tables.bin"))
        for table, sample in ((0, 0), (0, 1), (1, 0), (7, 300), (383, 4095)):
            place = ((sample // 256) * TABLES + table) * 256 + int(f"{sample % 256:08b}"[::-1], 2)
            point = xy[place] * (2**32 - 61679)
            start = (table * SIZE + sample) * 3
            expected = [(word % 2**32) & 0xFFFFFF00 for word in (point, point >> 32, z[place])]
            self.assertEqual(list(values[start:start + 3]), expected)

    def test_what_devices_look_up_ends_with_the_words(self):
        device = words(self.export("device.bin", "--layout", "device"))
        computed = words(self.export("computed.bin", "--layout", "computed"))
        self.assertEqual(len(computed), 17668)  # WELLSTRAT_XY of wellstrat.glsl
        self.assert_same(device, computed + words(self.export("words.bin", "--layout", "words")))

    @unittest.skipUnless(shutil.which("cc"), "no C compiler")
    def test_header_is_plain_c(self):
        """The first and last tables only: a compiler takes long over all of them."""
        for kind in ("uint32", "float32"):
            lines = self.export("tables.h", "--type", kind).decode().splitlines()
            opening = next(i for i, line in enumerate(lines) if "wellstrat_tables[" in line)
            head, tail = lines[:opening + 1], lines[-(SIZE + 2 + 3):]
            first = lines[opening + 1:opening + 1 + SIZE + 2]
            with open(self.path("short.c"), "w", encoding="ascii") as file:
                file.write("\n".join(head + first + tail) + "\n")
                file.write("int main(void) { return wellstrat_tables[0][0][0] < 0; }\n")
            subprocess.run(["cc", "-std=c99", "-Wall", "-Wno-type-limits", "-pedantic-errors",
                            "-Werror", "-fsyntax-only", "short.c"], cwd=self.directory, check=True,
                           timeout=120)

    def test_every_axis_of_every_table_is_stratified(self):
        values = words(self.export("tables.bin"))
        everything = set(range(SIZE))
        for table in range(TABLES):
            for c in range(3):
                begin = table * SIZE * 3
                column = values[begin + c:begin + SIZE * 3:3]
                self.assertEqual({value >> 20 for value in column}, everything)

    def test_samples_are_shifted_tables(self):
        """The first 256 samples of a pattern are the first 256 points of one table in another
        order, each coordinate XORed with a constant. The XOR of all 256 cancels the constant and
        so names the table."""
        values = words(self.export("tables.bin"))

        def xor_all(points):
            return tuple(functools.reduce(operator.xor, column) for column in zip(*points))

        def start_of(table):
            flat = values[table * SIZE * 3:(table * SIZE + 256) * 3]
            return list(zip(flat[0::3], flat[1::3], flat[2::3]))

        tables = {xor_all(start_of(table)): table for table in range(TABLES)}
        for pattern in (0, 1, 0xC0FFEE):
            rows = read_csv(self.output_of("sample", "--dims", "3", "--count", "256", "--pattern",
                                           str(pattern)))
            samples = [tuple(int(value * 2**32) for value in row) for row in rows]
            table = start_of(tables[xor_all(samples)])
            shifts = (tuple(a ^ b for a, b in zip(samples[0], point)) for point in table)
            shifted = ({tuple(a ^ b for a, b in zip(point, shift)) for point in table}
                       for shift in shifts)
            self.assertTrue(any(candidate == set(samples) for candidate in shifted))


if __name__ == "__main__":
    unittest.main()
