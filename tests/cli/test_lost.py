# SPDX-License-Identifier: Apache-2.0
"""Nothing is lost: whatever streams, disks, signals and limits do, results that are finished are
written, and nothing else stays."""

import fcntl
import json
import os
import resource
import signal
import struct
import subprocess
import termios
import unittest

from support import PROGRAM, RENDER_PROGRAM, CliTest, MpiCase

RENDER = ("render", "cornell", "--size", "16x16", "--spp", "4")
LONG_RENDER = ("render", "cornell", "--size", "40x24", "--spp", "1000000", "--save-every", "0")
STUDY = ("study", "--generators", "pmj", "--integrands", "disk", "--counts", "4,16", "--patterns",
         "8")
ENDLESS_STUDY = (*STUDY[:-1], "100000000", "--save-every", "0")


def closing(*descriptors):
    """For preexec_fn: the program starts without these standard streams."""
    def close():
        for descriptor in descriptors:
            os.close(descriptor)
    return close


def limited(limit, size):
    return lambda: resource.setrlimit(limit, (size, size))


needs_renderer = unittest.skipUnless(RENDER_PROGRAM, "built without the renderer")
needs_full = unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full")


class StreamTest(CliTest):
    """Standard streams that are closed, full, or read by nobody."""

    @needs_renderer
    def test_closed_streams_never_become_a_file_of_ours(self):
        self.output_of(*RENDER, "-o", "whole.png")
        for closed in ((0,), (1,), (2,), (1, 2), (0, 1, 2)):
            options = {"preexec_fn": closing(*closed)}
            process = self.run_program(*RENDER, "-o", "a.png", **options)
            self.assertEqual((process.returncode, process.stderr), (0, b""), closed)
            self.assertEqual(self.read("a.png"), self.read("whole.png"), closed)

    @needs_renderer
    def test_messages_do_not_get_into_the_picture(self):
        command = (*LONG_RENDER, "--time-limit", "0.3", "-o", "a.hdr")
        process = self.run_program(*command, preexec_fn=closing(0, 1, 2))
        self.assertEqual(process.returncode, 0)
        self.assertTrue(self.read("a.hdr").startswith(b"#?RADIANCE"))
        self.assertNotIn(b"wellstrat:", self.read("a.hdr"))

    def test_results_for_a_closed_stream_are_an_error(self):
        self.assert_fails("info", preexec_fn=closing(1), mentions="standard output")
        self.assert_fails("analyze", "-", preexec_fn=closing(0))

    @needs_full
    def test_help_to_a_full_stream_is_an_error(self):
        for arguments in (("--help",), ("--version",), ("sample", "--help")):
            with open("/dev/full", "wb") as full:
                self.assert_fails(*arguments, stdout=full, mentions="standard output")

    @needs_full
    @needs_renderer
    def test_full_streams_cost_no_picture(self):
        """Nor the frames after the first, nor the picture of a run whose time is up."""
        with open("/dev/full", "wb") as full:
            for command in ((*RENDER, "--frames", "3", "-o", "%04d.png"),
                            (*LONG_RENDER, "--time-limit", "0.3", "-o", "0003.png")):
                process = subprocess.run([PROGRAM, *command], cwd=self.directory, stdout=full,
                                         stderr=full, check=False, timeout=100)
                self.assertEqual(process.returncode, 0, command)
        self.assertEqual(self.files(), [f"{frame:04}.png" for frame in range(4)])

    @needs_renderer
    def test_pipes_that_nobody_reads_cost_no_picture(self):
        for command in ((*RENDER, "--frames", "3", "-o", "%04d.png"),
                        (*LONG_RENDER, "--time-limit", "0.3", "-o", "0003.png")):
            reader, writer = os.pipe()
            os.close(reader)
            try:
                process = subprocess.run([PROGRAM, *command], cwd=self.directory, stdout=writer,
                                         stderr=writer, check=False, timeout=100)
            finally:
                os.close(writer)
            self.assertEqual(process.returncode, 0, command)
        self.assertEqual(self.files(), [f"{frame:04}.png" for frame in range(4)])

    @needs_full
    def test_a_table_that_cannot_be_printed_costs_no_results(self):
        self.output_of(*STUDY, "-o", "whole.csv")
        with open("/dev/full", "wb") as full:
            process = self.run_program(*STUDY, "-o", "r.csv", stdout=full)
        self.assertEqual(process.returncode, 2)
        self.assertEqual(self.read("r.csv"), self.read("whole.csv"))

    def test_narrow_terminals_have_narrow_bars(self):
        for columns in (20, 50, 200):
            controller, terminal = self.open_terminal()
            fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, columns, 0, 0))
            with self.started(PROGRAM, *ENDLESS_STUDY, stdout=subprocess.DEVNULL,
                              stderr=terminal) as process:
                text = b""
                while text.count(b"\r") < 16:
                    text += os.read(controller, 4096)
                process.kill()
            os.close(terminal)
            os.close(controller)
            lines = [line.replace(b"\x1b[K", b"") for line in text.split(b"\r")[1:-1]]
            self.assertLess(max(map(len, lines)), columns)
            self.assertNotIn(b"left", lines[0])  # in the first second nobody knows
            if columns > 20:
                self.assertIn(b"left", lines[-1])
                self.assertIn(b"[", lines[-1])


class CheckpointTest(CliTest):
    """States that cannot be saved cost nothing but themselves."""

    def breaks(self, command, folder):
        """Ends a run by Ctrl-C after its folder of states has gone; its exit code and errors."""
        os.mkdir(self.path(folder))
        with self.started(PROGRAM, *command, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE) as process:
            self.wait_until(lambda: any(not name.startswith(".")
                                        for name in os.listdir(self.path(folder))))
            os.rename(self.path(folder), self.path("elsewhere"))
            first = process.stderr.readline()
            process.send_signal(signal.SIGINT)
            return process.communicate(timeout=100)[1], first, process.returncode

    @needs_renderer
    def test_the_picture_is_written_nevertheless(self):
        errors, first, code = self.breaks((*LONG_RENDER, "--checkpoint", "gone/part.exr", "-o",
                                           "a.png"), "gone")
        self.assertRegex(first, rb"\Awellstrat: cannot write 'gone/part.exr': [^\n]*; goes on ")
        self.assertRegex(errors, rb"\Awellstrat: interrupted with [^\n;]*\n\Z")
        self.assertEqual(code, 130)
        self.assertEqual(self.read("a.png")[:4], b"\x89PNG")

    @needs_renderer
    def test_a_picture_that_cannot_be_written_is_in_the_checkpoint(self):
        os.mkdir(self.path("gone"))
        command = (*LONG_RENDER, "--checkpoint", "part.exr", "-o", "gone/a.exr", "-o", "b.png")
        with self.started(PROGRAM, *command, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE) as process:
            self.wait_until(lambda: os.path.exists(self.path("part.exr")))
            os.rename(self.path("gone"), self.path("elsewhere"))
            process.send_signal(signal.SIGINT)
            errors = process.communicate(timeout=100)[1]
        self.assertEqual(process.returncode, 2)
        self.assertRegex(errors, rb"\Awellstrat: cannot write 'gone/a.exr': [^\n]*\n\Z")
        self.assertEqual(self.files(), ["b.png", "elsewhere", "part.exr"])

    def test_the_results_are_written_nevertheless(self):
        name = "r" * 250 + ".csv"  # too long with .state after it
        with self.started(PROGRAM, *ENDLESS_STUDY, "-o", name, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE) as process:
            first = process.stderr.readline()
            process.send_signal(signal.SIGINT)
            errors = process.communicate(timeout=100)[1]
        self.assertRegex(first, rb"\Awellstrat: cannot write 'r+.csv.state': [^\n]*; goes on ")
        self.assertRegex(errors, rb"\Awellstrat: interrupted after \d+ of 100000000 patterns\n\Z")
        self.assertEqual(process.returncode, 130)
        self.assertEqual(self.files(), [name])


class SignalTest(CliTest):
    def test_hangup_is_like_ctrl_c(self):
        commands = [("r.csv.state", (*ENDLESS_STUDY, "-o", "r.csv"))]
        if RENDER_PROGRAM:
            commands.append(("part.exr", (*LONG_RENDER, "--checkpoint", "part.exr", "-o", "r.exr")))
        for state, command in commands:
            with self.started(PROGRAM, *command, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE) as process:
                self.wait_until(lambda name=state: os.path.exists(self.path(name)))
                process.send_signal(signal.SIGHUP)
                errors = process.communicate(timeout=100)[1]
            self.assertEqual(process.returncode, 130)
            self.assertIn(b"interrupted", errors)
            self.assertTrue(os.path.exists(self.path(command[-1])))

    def test_nohup_is_obeyed(self):
        def ignore():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)
        with self.started(PROGRAM, *ENDLESS_STUDY, "-o", "r.csv", stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, preexec_fn=ignore) as process:
            self.wait_until(lambda: os.path.exists(self.path("r.csv.state")))
            for _ in range(3):
                process.send_signal(signal.SIGHUP)
            with self.assertRaises(subprocess.TimeoutExpired):
                process.wait(timeout=1)
            process.send_signal(signal.SIGINT)
            self.assertIn(b"interrupted", process.communicate(timeout=100)[1])


class LeftBehindTest(CliTest):
    def temporary_files(self):
        return [name for name in self.files() if name.startswith(".wellstrat")]

    def test_the_next_run_removes_what_a_killed_one_left(self):
        with self.started(PROGRAM, "sample", "--count", "4000000000", "-o", "a.csv") as process:
            self.wait_until(self.temporary_files)
            process.kill()
        self.assertEqual(len(self.temporary_files()), 1)
        self.output_of("sample", "--count", "4", "-o", "b.csv")
        self.assertEqual(self.files(), ["b.csv"])

    def test_files_in_work_stay(self):
        with self.started(PROGRAM, "sample", "--count", "4000000000", "-o", "a.csv"):
            self.wait_until(self.temporary_files)
            for _ in range(3):
                self.output_of("sample", "--count", "4", "-o", "b.csv")
            self.assertEqual(len(self.temporary_files()), 1)

    def test_files_of_others_stay(self):
        names = [".wellstrat-tmp-", ".wellstrat-tmp-1234567", ".wellstrat-config", "wellstrat-abcdef"]
        for name in names:
            with open(self.path(name), "wb"):
                pass
        os.mkdir(self.path(".wellstrat-tmp-folder"))
        os.symlink("b.csv", self.path(".wellstrat-tmp-alink1"))
        before = self.files()
        self.output_of("sample", "--count", "4", "-o", "b.csv")
        self.assertEqual(self.files(), sorted([*before, "b.csv"]))

    def test_limits_on_files_leave_nothing(self):
        """With the signal of such a limit as a shell leaves it."""
        self.assert_fails("sample", "--count", "100000", "-o", "a.csv", mentions="too large",
                          preexec_fn=limited(resource.RLIMIT_FSIZE, 4096))
        self.assert_fails("tables", "--export", "a.bin", mentions="too large",
                          preexec_fn=limited(resource.RLIMIT_FSIZE, 4096))

    def test_other_ends_leave_nothing(self):
        for end in (signal.SIGQUIT, signal.SIGXCPU, signal.SIGPIPE):
            with self.started(PROGRAM, "sample", "--count", "4000000000", "-o", "a.csv") as process:
                self.wait_until(self.temporary_files)
                process.send_signal(end)
                self.assertEqual(process.wait(timeout=60), -end)
            self.assertEqual(self.temporary_files(), [])


class MemoryTest(CliTest):
    """With too little memory: one line, exit code 2, and no more than what is finished."""

    def check(self, limits, *command):
        codes = set()
        for megabytes in limits:
            process = self.run_program(*command, preexec_fn=limited(resource.RLIMIT_AS,
                                                                    megabytes << 20))
            text = process.stderr.decode()
            if text.startswith("terminate called") or "error while loading shared" in text:
                continue  # libraries, before anything of ours runs
            codes.add(process.returncode)
            self.assertIn(process.returncode, (0, 2), (megabytes, text))
            if process.returncode == 2:
                self.assertRegex(text, r"\A(wellstrat|fftw): [^\n]+\n\Z", megabytes)
            self.assertEqual([name for name in self.files() if name.startswith(".")], [])
            for name in self.files():
                os.remove(self.path(name))
        self.assertEqual(codes, {0, 2})

    def test_points(self):
        self.check(range(12, 160, 8), *STUDY, "-o", "r.csv")
        self.check(range(12, 160, 8), "analyze", "--generator", "pmj", "--count", "1024")

    @needs_renderer
    def test_pictures(self):
        # With less than 500, OpenImageIO 2.4 may end when it is loaded, before anything of ours runs.
        self.check((*range(500, 900, 25), 4000), *RENDER[:2], "--size", "256x256", "--spp", "1",
                   "--threads", "1", "-o", "a.exr")

    @needs_renderer
    def test_a_black_picture_is_no_result(self):
        """Where memory ends before the first sample."""
        for megabytes in range(560, 700, 10):
            process = self.run_program(*RENDER, "-o", "a.png", preexec_fn=limited(
                resource.RLIMIT_AS, megabytes << 20))
            self.assertNotIn(b" with 0 of", process.stderr)
            self.assertEqual(os.path.exists(self.path("a.png")), process.returncode == 0)
            if process.returncode == 0:
                os.remove(self.path("a.png"))


class InputTest(CliTest):
    """Outputs that name an input are refused."""

    def write(self, name, content):
        with open(self.path(name), "wb") as file:
            file.write(content)

    def test_points(self):
        for name in ("a.dat", "a.gp"):
            self.output_of("sample", "--count", "16", "--format", "csv", "-o", name)
            for plot in ("a.png", os.path.join(self.directory, "..",
                                               os.path.basename(self.directory), "a.svg")):
                self.assert_fails("analyze", "--format", "text", name, "--plot", plot,
                                  "--keep-plot-files", mentions="input")
            os.remove(self.path(name))

    def test_points_of_studies(self):
        self.output_of("sample", "--count", "16", "-o", "a.csv")
        study = ("study", "--generators", "file:a.csv", "--integrands", "disk", "--counts", "4",
                 "--patterns", "1")
        self.assert_fails(*study, "-o", "a.csv", mentions="input")
        os.symlink("a.csv", self.path("link.csv"))
        self.assert_fails(*study, "-o", "link.csv", mentions="input")

    @needs_renderer
    def test_pictures(self):
        for first, name in ((0, "a.exr"), (2, "b.exr")):
            self.output_of("render", "cornell", "--size", "8x8", "--samples",
                           f"{first}:{first + 2}", "-o", name)
        for name in ("a.exr", "./b.exr"):
            self.assert_fails("merge", "a.exr", "b.exr", "-o", name, mentions="input")
        self.assert_fails("merge", "a.exr", "b.exr", "-o", "c.png", "-o", "b.exr", mentions="input")
        self.output_of("render", "cornell", "--size", "8x8", "--spp", "1", "-o", "sky.hdr")
        self.assert_fails("render", "cornell", "--environment", "sky.hdr", "-o", "sky.hdr",
                          mentions="input")
        self.output_of("render", "cornell", "--size", "8x8", "--samples", "0:4", "--resume",
                       "a.exr", "-o", "a.exr")  # the same picture, with more samples

    @needs_renderer
    def test_parts_of_scenes(self):
        """Textures, material libraries and buffers of a scene are inputs, too."""
        self.output_of("render", "cornell", "--size", "2x2", "--spp", "1", "-o", "color.png",
                       "-o", "sky.png")
        self.write("scene.obj", b"mtllib scene.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n"
                   b"usemtl a\nf 1/1 2/1 3/1\n")
        self.write("scene.mtl", b"newmtl a\nmap_Kd .\\color.png\n")
        self.write("buffer.png", struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0))
        self.write("scene.gltf", json.dumps({
            "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
            "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "buffers": [{"uri": "buffer.png", "byteLength": 36}]}).encode())
        os.symlink("scene.mtl", self.path("link.png"))
        for scene, output in (("scene.obj", "color.png"), ("scene.obj", "link.png"),
                              ("scene.gltf", "buffer.png")):
            render = ("render", scene, "--size", "2x2", "--spp", "1", "--camera", "0,0,3",
                      "--environment", "sky.png", "-o")
            self.assert_fails(*render, output, mentions=f"'{output}' is an input")
            self.output_of(*render, "out.png")


class MpiTest(MpiCase):
    def test_what_is_not_shared_is_done_once(self):
        process = self.mpirun(2, "info")
        self.assertEqual((process.returncode, process.stderr), (0, b""))
        self.assertEqual(process.stdout.count(b"table memory"), 1)
        process = self.mpirun(2, "sample", "--count", "3")
        self.assertEqual(len(process.stdout.split()), 3)
        self.assertEqual(self.mpirun(2, "study", "--list").stdout.count(b"Generators\n"), 1)
        self.assertEqual(self.mpirun(3, "--version").stdout.count(b"\n"), 1)

    def test_bad_options_are_said_once(self):
        for arguments in (("info", "--nonsense"), ("study", "--patterns", "x"), ("nonsense",)):
            process = self.mpirun(3, *arguments)
            self.assertEqual(process.returncode, 2)
            self.assertEqual(process.stderr.count(b"wellstrat: "), 1, process.stderr)

    @needs_renderer
    def test_an_error_of_one_process_ends_all(self):
        os.mkdir(self.path("gone"))
        command = self.command(2, *RENDER[:-1], "2000", "--frames", "1000", "-o", "gone/%04d.exr")
        with self.started(*command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
            self.wait_until(lambda: os.path.exists(self.path("gone/0000.exr")))
            # At once: removing file by file, it would find new ones.
            os.rename(self.path("gone"), self.path("elsewhere"))
            errors = process.communicate(timeout=100)[1]
        self.assertEqual(process.returncode, 2)
        self.assertRegex(errors, rb"wellstrat: cannot write 'gone/\d+.exr': No such file")


if __name__ == "__main__":
    unittest.main()
