# SPDX-License-Identifier: Apache-2.0
"""A copy of the tree to plant faults in."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


class TreeTest(unittest.TestCase):
    """Works in self.tree, a copy of COPIED."""

    COPIED = ()

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = pathlib.Path(folder.name).resolve()
        for name in self.COPIED:
            if (ROOT / name).is_dir():
                shutil.copytree(ROOT / name, self.tree / name)
            else:
                shutil.copy2(ROOT / name, self.tree / name)

    def run_script(self, name, *arguments):
        """Its exit code, and what it prints."""
        done = subprocess.run([self.tree / "scripts" / name, *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, check=False)
        return done.returncode, done.stdout

    def replace(self, name, old, new):
        """Replaces text that occurs once in a file."""
        path = self.tree / name
        text = path.read_text()
        self.assertEqual(text.count(old), 1, f"{old} in {name}")
        path.write_text(text.replace(old, new))
