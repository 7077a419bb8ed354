# SPDX-License-Identifier: Apache-2.0
"""scripts/check-layers sees circles and steps across layers."""

from support import TreeTest


class CheckLayers(TreeTest):
    COPIED = ("scripts", "include", "src")

    def includes(self, name, header):
        """Lets a file include a header."""
        path = self.tree / name
        path.write_text(path.read_text() + f'\n#include "{header}"\n')

    def test_the_tree_is_in_order(self):
        self.assertEqual(self.run_script("check-layers"), (0, ""))

    def test_headers_in_a_circle(self):
        self.includes("include/wellstrat/platform.h", "wellstrat/batch.h")
        code, output = self.run_script("check-layers")
        self.assertEqual(code, 1)
        self.assertRegex(output, "circle: .*include/wellstrat/platform.h")

    def test_sources_in_a_circle(self):
        self.includes("src/core/tables.cpp", "wellstrat/one.h")
        (self.tree / "include/wellstrat/one.h").write_text("#pragma once\n")
        (self.tree / "src/core/one.cpp").write_text(
            '#include "wellstrat/one.h"\n\n#include "wellstrat/tables.h"\n')
        code, output = self.run_script("check-layers")
        self.assertEqual(code, 1)
        self.assertRegex(output, r"circle: .*wellstrat/(one|tables)\.h -> .*wellstrat/(one|tables)\.h")

    def test_a_source_of_a_header_of_another_name_in_a_circle(self):
        # pattern_faults.cpp implements what fault_search.h declares.
        self.includes("src/debug/pattern_faults.cpp", "debug/domain_faults.h")
        code, output = self.run_script("check-layers")
        self.assertEqual(code, 1)
        self.assertIn("circle", output)
        self.assertIn("src/debug/fault_search.h", output)

    def test_the_core_does_not_know_the_linter(self):
        self.includes("src/generators/joint.cpp", "wellstrat/domain_linter.h")
        code, output = self.run_script("check-layers")
        self.assertEqual(code, 1)
        self.assertIn("wellstrat/domain_linter.h: generators source may not include debug", output)
