# SPDX-License-Identifier: Apache-2.0
"""scripts/release makes the same archive each time, of what is committed, and dates the change log
only when it is asked to."""

import hashlib
import re
import shutil
import subprocess
import tarfile
import unittest

from support import TreeTest


@unittest.skipUnless(shutil.which("git"), "needs git")
class Release(TreeTest):
    COPIED = ("CMakeLists.txt", "CHANGELOG.md", "LICENSE", "include", "scripts", ".gitignore")

    def setUp(self):
        super().setUp()
        self.git("init", "--quiet", "--initial-branch=main")
        self.git("config", "user.name", "A tester")
        self.git("config", "user.email", "tester@localhost")
        self.git("add", ".")
        self.git("commit", "--quiet", "--message", "All")

    def git(self, *arguments):
        done = subprocess.run(["git", *arguments], cwd=self.tree, stdout=subprocess.PIPE, text=True,
                              check=True)
        return done.stdout

    def hash_of_release(self, *arguments):
        """What a run that must succeed prints as the hash, after a comparison with the archive's."""
        code, output = self.run_script("release", *arguments)
        self.assertEqual(code, 0, output)
        digest, name = output.splitlines()[-1].split()
        content = (self.tree / "build" / "archive" / name).read_bytes()
        self.assertEqual(hashlib.sha256(content).hexdigest(), digest)
        return digest

    def test_two_runs_give_one_hash(self):
        first = self.hash_of_release()
        for path in self.tree.glob("include/*.h"):
            path.touch()
        self.git("config", "tar.umask", "0077")
        self.assertEqual(self.hash_of_release(), first)

    def test_the_archive_is_what_is_committed(self):
        (self.tree / "stray").write_text("not committed\n")
        self.hash_of_release()
        [path] = (self.tree / "build" / "archive").glob("*.tar.gz")
        with tarfile.open(path) as archive:
            names = {member.name for member in archive if member.isfile()}
        top = path.name.removesuffix(".tar.gz")
        self.assertEqual(names, {f"{top}/{name}" for name in self.git("ls-files").splitlines()})
        notes = path.with_name(top + ".md").read_text()
        self.assertRegex(notes, r"\A## \d+\.\d+\.\d+ \(unreleased\), stream version \d+\n")
        self.assertEqual(len(re.findall("^## ", notes, re.MULTILINE)), 1)

    def test_changes_must_be_committed(self):
        self.replace("LICENSE", "Version 2.0, January 2004", "Version 2.1")
        code, output = self.run_script("release")
        self.assertEqual(code, 2, output)
        self.assertIn("not committed", output)

    def test_the_change_log_must_name_version_and_stream(self):
        self.replace("CMakeLists.txt", "project(wellstrat VERSION ", "project(wellstrat VERSION 9")
        self.git("commit", "--all", "--quiet", "--message", "Another version")
        code, output = self.run_script("release")
        self.assertEqual(code, 2, output)
        self.assertRegex(output, r"not with '## 9\S+ \(DATE\), stream version")

    def test_a_tag_dates_the_change_log(self):
        before = self.hash_of_release()
        self.assertIn("(unreleased)", (self.tree / "CHANGELOG.md").read_text())
        self.assertNotEqual(self.hash_of_release("--tag"), before)
        self.assertRegex((self.tree / "CHANGELOG.md").read_text(),
                         r"(?m)^## \d+\.\d+\.\d+ \(\d{4}-\d\d-\d\d\), stream version \d+$")
        self.assertRegex(self.git("tag", "--list", "-n"), r"v\S+ +wellstrat \S+, stream version \d+")
        self.assertEqual(self.git("describe"), self.git("tag"))
        code, output = self.run_script("release", "--tag")
        self.assertEqual(code, 2, output)
        self.assertIn("CHANGELOG.md says", output)


if __name__ == "__main__":
    unittest.main()
