# SPDX-License-Identifier: Apache-2.0
"""Opens HTML pages in headless Chromium, cut off from any network, and says what they show."""

import dataclasses
import html
import json
import os
import re
import shutil
import subprocess
import tempfile

import numpy
import PIL.Image

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")

# What the rendered page tells about itself; a copy of the page writes it into its own text.
PROBE = """<script>
addEventListener("load", () => {
  const text = element => element.innerText.trim();
  const all = (selector, within = document) => Array.from(within.querySelectorAll(selector));
  const seen = {
    title: document.title,
    headings: all("h1, h2, h3").map(text),
    images: all("img").map(image => {
      const {x, y, width, height} = image.getBoundingClientRect();
      return {alt: image.alt, naturalWidth: image.naturalWidth, x, y, width, height};
    }),
    captions: all("figcaption, caption").map(text),
    labels: all(".label").map(text),
    marked: all("td strong").map(text),
    tables: all("table").map(table => all("tr", table).map(row => all("th, td", row).map(text))),
    text: text(document.body),
    width: document.documentElement.scrollWidth,
    height: document.documentElement.scrollHeight,
    loaded: performance.getEntriesByType("resource").map(entry => entry.name),
  };
  const probe = document.createElement("pre");
  probe.id = "probe";
  probe.textContent = JSON.stringify(seen);
  parent.document.documentElement.append(probe);
});
</script>"""


@dataclasses.dataclass
class Image:
    """An <img>, in pixels of the page. Its naturalWidth is 0 if it could not be decoded."""
    alt: str
    naturalWidth: float
    x: float
    y: float
    width: float
    height: float


@dataclasses.dataclass
class Page:
    """What a reader sees. `labels` are the texts in pictures, `marked` those of marked cells. tables[t][row][column] are texts, the header's row first; `loaded` are
    the addresses that the browser has loaded for the page; `screenshot` is an array of uint8 with
    shape (height, width, 3)."""
    title: str
    headings: list
    images: list
    captions: list
    labels: list
    marked: list
    tables: list
    text: str
    width: int
    height: int
    loaded: list
    screenshot: numpy.ndarray

    def pixels_of(self, image):
        """What the screenshot shows of an Image."""
        return self.screenshot[round(image.y):round(image.y + image.height),
                               round(image.x):round(image.x + image.width)]


def in_window(source, width, height):
    """An HTML page with one that is `width` wide in it: Chromium's own windows have 500 pixels or
    more."""
    return (f'<!DOCTYPE html><body style="margin:0"><iframe style="display:block;border:0;'
            f'width:{width}px;height:{height}px" srcdoc="{html.escape(source)}"></iframe>')


def open_page(path, width=1280):
    """The Page that a window of `width` pixels shows of the HTML file `path`."""
    with open(path, encoding="utf-8") as file:
        source = file.read()
    with tempfile.TemporaryDirectory() as directory:
        probed, shown, picture = (os.path.join(directory, name)
                                  for name in ("page.html", "shown.html", "shot.png"))
        with open(probed, "w", encoding="utf-8") as file:
            file.write(in_window(source + PROBE, width, 800))
        dom = run_chromium(directory, "--dump-dom", f"--window-size={width},800", probed)
        probe = re.search(r'<pre id="probe">(.*?)</pre>', dom, re.DOTALL)
        assert probe, "the page did not finish loading"
        seen = json.loads(html.unescape(probe.group(1)))
        seen["images"] = [Image(**image) for image in seen["images"]]
        height = max(seen["height"], 1)
        with open(shown, "w", encoding="utf-8") as file:
            file.write(in_window(source, width, height))
        run_chromium(directory, f"--screenshot={picture}", f"--window-size={width},{height}", shown)
        with PIL.Image.open(picture) as image:
            pixels = numpy.asarray(image.convert("RGB"))
            return Page(**seen, screenshot=pixels[:, :width])


def run_chromium(directory, *arguments):
    """What it prints. Each name leads nowhere, so that a page cannot load from a network."""
    process = subprocess.run(
        [CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
         "--host-resolver-rules=MAP * ~NOTFOUND", "--virtual-time-budget=10000", "--hide-scrollbars",
         f"--user-data-dir={directory}/profile", *arguments],
        stdin=subprocess.DEVNULL, capture_output=True, timeout=120, check=False,
        env={**os.environ, "HOME": directory})
    assert process.returncode == 0, process.stderr.decode(errors="replace")
    return process.stdout.decode()


def outside_references(source):
    """The addresses in HTML that lead out of the file: nothing in a page to read offline. Links
    that a reader may follow count, too."""
    found = re.findall(r"""(?:\s(?:src|href|srcset|data|poster|action)\s*=\s*["']?|url\(\s*["']?|"""
                       r"""@import\s+["']?)([^"'\s>)]+)""", source)
    return [address for address in found if not address.startswith(("data:", "#"))]
