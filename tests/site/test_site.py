# SPDX-License-Identifier: Apache-2.0
"""Opens the site that scripts/docs has built in headless Chromium, cut off from any network.
Run by scripts/test --nightly."""

import html
import json
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SITE = ROOT / "build" / "docs" / "html"
sys.path.insert(0, str(ROOT / "tests" / "cli"))

from browser import PROBE, run_chromium  # noqa: E402


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        cls.site = pathlib.Path(cls.folder.name) / "site"
        shutil.copytree(SITE, cls.site)

    def opened(self, name, query=""):
        """What the browser says of a page."""
        page = self.site / f"{name}.html"
        source = page.read_text()
        page.write_text(source + PROBE)
        dom = run_chromium(self.folder.name, "--dump-dom", "--window-size=1280,800",
                           f"file://{page}{query}")
        page.write_text(source)
        probe = re.search(r'<pre id="probe">(.*?)</pre>', dom, re.DOTALL)
        self.assertTrue(probe, name)
        return json.loads(html.unescape(probe[1]))

    def test_first_page(self):
        seen = self.opened("index")
        self.assertIn("wellstrat", seen["title"])
        self.assertIn("Numbers", [heading.rstrip("#") for heading in seen["headings"]])
        self.assertTrue(seen["images"])
        for image in seen["images"]:
            self.assertGreater(image["naturalWidth"], 0, image["alt"])
            self.assertGreater(image["x"], 200, "right of the contents, by the style sheet")

    def test_nothing_is_loaded_from_the_web(self):
        for path in self.site.rglob("*.html"):
            found = re.findall(r'''<(?:link|script|img)[^>]*(?:href|src)="(https?:[^"]*)''',
                               path.read_text())
            self.assertEqual(found, [], path.name)

    def test_reference(self):
        for page, words in (
                ("reference/cpp/wellstrat_camera", "cameraContext(int x, int y, unsigned frame"),
                ("reference/cpp/RixRNG", "DrawSamples2D"),
                ("reference/c/wellstrat_c", "wellstrat_last_error(void)"),
                ("reference/python", "wellstrat.samples(pattern, count")):
            self.assertIn(words, self.opened(page)["text"], page)

    def test_search(self):
        found = self.opened("search", "?q=cameraContext")["text"]
        self.assertRegex(found, r"wellstrat/camera\.h")


if __name__ == "__main__":
    unittest.main()
