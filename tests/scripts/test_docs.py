# SPDX-License-Identifier: Apache-2.0
"""The contents of the site that scripts/docs builds name each document."""

import unittest

from support import ROOT


class Contents(unittest.TestCase):
    def test_each_document_is_listed_once(self):
        lines = (ROOT / "docs" / "site" / "index.md").read_text().splitlines()
        listed = [line for line in lines if line.startswith("docs/") and "/decisions/" not in line]
        documents = [f"docs/{path.stem}" for path in (ROOT / "docs").glob("*.md")]
        self.assertEqual(sorted(listed), sorted(documents))


if __name__ == "__main__":
    unittest.main()
