# SPDX-License-Identifier: Apache-2.0
"""Shaders in a browser give the library's bits: GLSL ES 3.00 by WebGL2, and WGSL by WebGPU, in
headless Chromium on the processor. $WELLSTRAT_QUESTIONS is the program of questions.cpp."""

import http.server
import os
import pathlib
import queue
import re
import shutil
import subprocess
import tempfile
import threading
import unittest

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
GOLDEN = [ROOT / "tests/golden" / f"{name}.txt" for name in ("samples", "joint", "long", "blue")]
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
RANDOM_QUESTIONS = 2000  # of each kind


def whole_source(name):
    """A shader with what it includes, which browsers do not do."""
    def included(match):
        inner = match.group(1)
        path = ROOT / "include" / inner if "/" in inner else HERE / "shaders" / inner
        return path.read_text()
    return re.sub(r'^#include "(.*)"$', included, (HERE / "shaders" / name).read_text(), flags=re.M)


class Server(http.server.ThreadingHTTPServer):
    """Gives a page what it asks for, and has what the page says in `results`."""

    def __init__(self, files):
        super().__init__(("127.0.0.1", 0), Handler)
        self.files, self.results = files, queue.Queue()


class Handler(http.server.BaseHTTPRequestHandler):
    def do_GET(self):
        name = self.path.lstrip("/")
        kind = "text/html" if name == "page" else "application/octet-stream"
        content = self.server.files.get(name)
        self.send_response(404 if content is None else 200)
        self.send_header("Content-Type", kind)
        self.end_headers()
        self.wfile.write(content or b"")

    def do_POST(self):
        self.server.results.put(self.rfile.read(int(self.headers["Content-Length"])).decode())
        self.send_response(204)
        self.end_headers()

    def log_message(self, *arguments):
        pass


@unittest.skipUnless(CHROMIUM, "no Chromium")
class BrowserTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        questions = self.folder / "questions"
        subprocess.run([os.environ["WELLSTRAT_QUESTIONS"], str(RANDOM_QUESTIONS), questions, *GOLDEN],
                       check=True)
        tables = self.folder / "tables.bin"
        subprocess.run([os.environ["WELLSTRAT"], "tables", "--export", tables, "--layout", "device"],
                       check=True, capture_output=True)
        page = f"<!DOCTYPE html><script>{(HERE / 'shaders/page.js').read_text()}</script>"
        self.files = {"page": page.encode(), "questions": questions.read_bytes(),
                      "tables": tables.read_bytes()}

    def ask(self, how, shader, *flags):
        """What the page says of a shader."""
        self.files[shader] = whole_source(shader).encode()
        server = Server(self.files)
        self.addCleanup(server.server_close)
        self.addCleanup(server.shutdown)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{server.server_address[1]}/page#{how}"
        command = [CHROMIUM, "--headless", "--no-sandbox", "--disable-dev-shm-usage",
                   f"--user-data-dir={self.folder}/profile", "--enable-unsafe-swiftshader", *flags,
                   "--remote-debugging-port=0", address]
        with subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL,
                              env={**os.environ, "HOME": str(self.folder)}) as browser:
            try:
                return server.results.get(timeout=100)
            except queue.Empty:
                self.fail("the page says nothing")
            finally:
                browser.terminate()

    def assert_all_agree(self, said):
        if said == "no device":
            self.skipTest("Chromium has no device for it here")
        self.assertRegex(said, r"^\d{5,} agree$")

    def test_glsl_es(self):
        self.assert_all_agree(self.ask("webgl", "answer.frag", "--use-angle=swiftshader"))

    def test_wgsl(self):
        self.assert_all_agree(self.ask("webgpu", "answer.wgsl", "--enable-unsafe-webgpu",
                                       "--use-webgpu-adapter=swiftshader"))


if __name__ == "__main__":
    unittest.main()
