# SPDX-License-Identifier: Apache-2.0
"""What the tool loads when, and how `wellstrat` finds wellstrat-render and the module for MPI."""

import os
import re
import shutil
import signal
import subprocess
import unittest

from support import PROGRAM, RENDER_PROGRAM, CliTest

RENDERING = ("render", "merge", "compare", "domains")
MODULE = "wellstrat-mpi.so"
SMALL_STUDY = ("study", "--generators", "pmj", "--counts", "16", "--patterns", "4")


class LoadingTest(CliTest):
    def libraries(self, *arguments):
        """The names of the libraries that the program loads, as glibc's loader tells them."""
        process = self.run_program(*arguments, env={**os.environ, "LD_DEBUG": "libs"})
        self.assertEqual(process.returncode, 0)
        names = re.findall(rb"calling init: \S*/(\S+)", process.stderr)
        if not names:
            self.skipTest("the loader of this system does not tell")
        return {name.decode() for name in names}

    def test_version_loads_little(self):
        self.assertLessEqual(len(self.libraries("--version")), 20)

    def test_study_alone_loads_no_mpi(self):
        for name in self.libraries(*SMALL_STUDY):
            self.assertNotIn("mpi", name)


class LoneTest(CliTest):
    """A program as it is where nothing else is installed."""

    def setUp(self):
        super().setUp()
        self.folders = {"bin": self.path(os.environ["WELLSTRAT_BINDIR"]),
                        "lib": self.path(os.environ["WELLSTRAT_LIBDIR"] + "/wellstrat"),
                        "path": self.path("elsewhere")}
        for folder in self.folders.values():
            os.makedirs(folder)
        self.program = os.path.join(self.folders["bin"], "wellstrat")
        shutil.copy(PROGRAM, self.program)
        self.environment = {**os.environ, "PATH": f"{self.path('none')}:{self.folders['path']}"}

    def run_program(self, *arguments, **options):
        return self.run_file(self.program, *arguments, **options)

    def files(self):
        return []

    def run_file(self, file, *arguments, **options):
        options.setdefault("env", self.environment)
        options.setdefault("input", b"")
        return subprocess.run([file, *arguments], cwd=self.directory, capture_output=True,
                              timeout=100, check=False, **options)

    def write_program(self, folder, text):
        path = os.path.join(self.folders[folder], "wellstrat-render")
        with open(path, "w", encoding="ascii") as file:
            file.write("#!/bin/sh\n" + text)
        os.chmod(path, 0o755)
        return path

    def test_says_what_to_install(self):
        for name in RENDERING:
            self.assert_fails(name, mentions="install wellstrat-render")
            self.assert_fails(name, "--help", mentions="install wellstrat-render")
        self.assert_fails("renders", mentions="render, merge, compare, domains")
        self.assertIn(b"384", self.output_of("info"))

    def test_help_marks_what_is_missing(self):
        for here in (False, True):
            if here:
                self.write_program("bin", "exit 0\n")
            text = self.output_of("--help").decode()
            for name in RENDERING:
                self.assertRegex(text, rf"(?m)^  {name} +\S.*" + ("[^)]$" if here else
                                                                 r"\(not installed\)$"))
            self.assertLessEqual(max(map(len, text.splitlines())), 100)

    def test_beside_the_program_then_in_its_folder_then_on_path(self):
        programs = [self.write_program(folder, f"echo {folder}\n")
                    for folder in ("path", "lib", "bin")]
        for folder, path in zip(("bin", "lib", "path"), reversed(programs)):
            self.assertEqual(self.output_of("merge"), folder.encode() + b"\n")
            os.remove(path)
        self.assert_fails("merge", mentions="install wellstrat-render")

    def test_is_found_through_a_link(self):
        self.write_program("bin", "echo here\n")
        os.symlink(self.program, self.path("link"))
        self.assertEqual(self.run_file(self.path("link"), "render").stdout, b"here\n")

    def test_nothing_changes_on_the_way(self):
        """Arguments, standard streams and the exit code are those of wellstrat-render."""
        self.write_program("bin", "printf '<%s>' \"$@\"; /bin/cat; echo error >&2; exit 77\n")
        process = self.run_file(self.program, "--x", "render", "", "a b", "--", "--help", "\n$0",
                                input=b"input\n", env={**self.environment, "PATH": "/bin"})
        self.assertEqual(process.stdout, b"<--x><render><><a b><--><--help><\n$0>input\n")
        self.assertEqual((process.stderr, process.returncode), (b"error\n", 77))

    def test_it_is_the_same_process(self):
        self.write_program("bin", "echo $$; kill -TERM $$\n")
        with self.started(self.program, "compare", stdout=subprocess.PIPE) as process:
            self.assertEqual(int(process.stdout.readline()), process.pid)
            self.assertEqual(process.wait(timeout=30), -signal.SIGTERM)

    def test_a_program_that_cannot_run(self):
        os.chmod(self.write_program("bin", ""), 0o644)
        self.assert_fails("render", mentions="cannot run '")

    def test_under_mpirun_without_its_module(self):
        for variable in ("OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"):
            environment = {**self.environment, variable: "1"}
            self.assert_fails(*SMALL_STUDY, mentions="install wellstrat-mpi", env=environment)
            self.assertEqual(self.run_program("info", env=environment).returncode, 0)
        with open(os.path.join(self.folders["lib"], MODULE), "wb") as file:
            file.write(b"no module")
        self.assert_fails(*SMALL_STUDY, mentions="cannot use MPI", env=environment)


@unittest.skipUnless(RENDER_PROGRAM, "built without the renderer")
class RenderProgramTest(CliTest):
    def run_render_program(self, *arguments):
        return subprocess.run([RENDER_PROGRAM, *arguments], cwd=self.directory,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=100,
                              check=False)

    def test_works_by_itself(self):
        process = self.run_render_program("render", "--list")
        self.assertEqual((process.returncode, process.stderr), (0, b""))
        self.assertEqual(process.stdout, self.output_of("render", "--list"))
        process = self.run_render_program("sample")
        self.assertEqual(process.returncode, 2)
        self.assertRegex(process.stderr, rb"\Awellstrat: [^\n]*render, merge, compare, domains\n\Z")

    def test_version(self):
        version = os.environ["WELLSTRAT_VERSION"]
        self.assertRegex(self.run_render_program("--version").stdout.decode(),
                         rf"\Awellstrat-render {version}, stream version \d+\n\Z")

    def test_help_names_the_program_that_was_called(self):
        text = self.run_render_program("--help").stdout.decode()
        self.assertIn("Usage: wellstrat-render [OPTIONS] SUBCOMMAND\n", text)
        for name in RENDERING:
            self.assertRegex(text, rf"(?m)^  {name} +\S")
            for run, called in ((self.run_render_program, "wellstrat-render"),
                                (self.run_program, "wellstrat")):
                self.assertIn(f"Usage: {called} {name} [OPTIONS]",
                              run(name, "--help").stdout.decode())


if __name__ == "__main__":
    unittest.main()
