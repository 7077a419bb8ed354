# SPDX-License-Identifier: Apache-2.0
"""The files in packaging/ agree with the rest of the tree. What builds packages from them is
scripts/package."""

import json
import pathlib
import py_compile
import re
import subprocess
import tempfile
import unittest

from support import ROOT, TreeTest

PACKAGING = ROOT / "packaging"
DEBIAN = PACKAGING / "debian"
VERSION = re.search(r"project\(wellstrat VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]


def paragraphs(path):
    """Those of a file in the format of debian/control, as dictionaries."""
    for text in re.split(r"\n\s*\n", path.read_text().strip()):
        fields = re.findall(r"^(\S+): *(.*(?:\n[ \t].*)*)", text, re.MULTILINE)
        yield dict(fields)


def names_in(field):
    """The packages in a list of dependencies, without versions and substitutions."""
    return re.findall(r"(?:^|[,|])\s*([a-z0-9][a-z0-9.+-]+)", field)


class Debian(unittest.TestCase):
    def packages(self):
        return [paragraph["Package"] for paragraph in paragraphs(DEBIAN / "control")
                if "Package" in paragraph]

    def test_version_is_the_projects(self):
        first = (DEBIAN / "changelog").read_text().splitlines()[0]
        self.assertRegex(first, rf"^wellstrat \({re.escape(VERSION)}-\d+\) ")

    def test_names_of_libraries_are_those_of_the_record(self):
        sonames = [path.stem for path in (ROOT / "abi" / "x86_64").glob("*.xml")]
        libraries = [name for name in self.packages() if re.fullmatch(r"lib.*\d", name)]
        self.assertEqual(sorted(libraries), sorted(name.replace(".so.", "") for name in sonames))

    def test_each_package_installs_something_and_each_file_belongs_to_one(self):
        packages = self.packages()
        for name in set(packages) - {"python3-wellstrat"}:  # which pybuild installs by its name
            self.assertTrue((DEBIAN / f"{name}.install").is_file(), name)
        for suffix in ("install", "manpages", "symbols", "docs"):
            for path in DEBIAN.glob(f"*.{suffix}"):
                self.assertIn(path.stem, packages, path.name)

    def test_tests_are_there_and_need_packages_that_there_are(self):
        for paragraph in paragraphs(DEBIAN / "tests" / "control"):
            for name in paragraph["Tests"].split():
                path = DEBIAN / "tests" / name
                self.assertTrue(path.stat().st_mode & 0o111, name)
            ours = [name for name in names_in(paragraph["Depends"]) if "wellstrat" in name]
            self.assertTrue(ours)
            self.assertLessEqual(set(ours), set(self.packages()))

    def test_tools_need_neither_mpi_nor_gnuplot(self):
        for paragraph in paragraphs(DEBIAN / "control"):
            self.assertNotRegex(paragraph.get("Depends", ""), "mpi|gnuplot", paragraph)

    def test_shell_scripts_can_be_parsed(self):
        scripts = [DEBIAN / "make-man-pages", ROOT / "tools" / "completion" / "wellstrat.bash",
                   *(path for path in (DEBIAN / "tests").iterdir() if path.name != "control")]
        for path in scripts:
            head = path.read_text().partition("\n")[0]
            shell = "sh" if head.endswith("/sh") else "bash"
            done = subprocess.run([shell, "-n", path], capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stderr), (0, ""), path)


class Symbols(TreeTest):
    COPIED = ("packaging", "abi", "scripts")

    def test_differences_from_the_record_are_seen(self):
        self.assertEqual(self.run_script("debian-symbols"), (0, ""))
        self.replace("packaging/debian/libwellstrat0.1.symbols", " wellstrat_version@", " renamed@")
        code, output = self.run_script("debian-symbols")
        self.assertEqual(code, 1)
        self.assertRegex(output, r"the record has not: renamed@")
        self.assertRegex(output, r"has not, but the record: wellstrat_version@")
        self.assertEqual(self.run_script("debian-symbols", "--fix"), (0, ""))
        self.assertEqual(self.run_script("debian-symbols"), (0, ""))


class OtherPackagers(unittest.TestCase):
    def test_vcpkg(self):
        port = PACKAGING / "vcpkg" / "wellstrat"
        manifest = json.loads((port / "vcpkg.json").read_text())
        self.assertEqual((manifest["name"], manifest["version"]), ("wellstrat", VERSION))
        self.options_exist(port / "portfile.cmake")

    def test_conan(self):
        recipe = PACKAGING / "conan" / "conanfile.py"
        with tempfile.TemporaryDirectory() as folder:
            py_compile.compile(recipe, cfile=str(pathlib.Path(folder) / "recipe"), doraise=True)
        self.assertIn(f'version = "{VERSION}"', recipe.read_text())
        self.options_exist(recipe)

    def options_exist(self, path):
        """An option that CMakeLists.txt does not have would be ignored."""
        known = (ROOT / "CMakeLists.txt").read_text()
        for option in re.findall(r"WELLSTRAT_[A-Z_]+", path.read_text()):
            self.assertRegex(known, rf"option\({option} ", path)


if __name__ == "__main__":
    unittest.main()
