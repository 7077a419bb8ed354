# SPDX-License-Identifier: Apache-2.0
"""What the tests of the command line tool share. The program is named by $WELLSTRAT, and the one
that renders, if it is built, by $WELLSTRAT_RENDER."""

import array
import ast
import contextlib
import os
import pty
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

PROGRAM = os.environ["WELLSTRAT"]
RENDER_PROGRAM = os.environ.get("WELLSTRAT_RENDER")


class CliTest(unittest.TestCase):
    """Runs the program in an empty directory of its own."""

    def open_terminal(self):
        """The two ends of a pseudo-terminal; skips the test on a machine without any."""
        try:
            return pty.openpty()
        except OSError as error:
            self.skipTest(f"no pseudo-terminal: {error}")

    def on_terminal(self, *arguments, stdout=subprocess.PIPE):
        """(What a terminal shows of the standard error, the standard output.)"""
        controller, terminal = self.open_terminal()
        shown = []

        def read():
            try:
                while data := os.read(controller, 4096):
                    shown.append(data)
            except OSError:
                pass  # as Linux says that the other end is closed

        reader = threading.Thread(target=read)
        reader.start()
        process = subprocess.run([PROGRAM, *arguments], cwd=self.directory, stderr=terminal,
                                 stdout=terminal if stdout is None else stdout, check=True,
                                 timeout=100)
        os.close(terminal)
        reader.join()
        os.close(controller)
        return b"".join(shown).decode(), process.stdout

    def setUp(self):
        directory = tempfile.TemporaryDirectory()
        self.addCleanup(directory.cleanup)
        self.directory = directory.name

    def path(self, name):
        return os.path.join(self.directory, name)

    def files(self):
        return sorted(os.listdir(self.directory))

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def run_program(self, *arguments, **options):
        """The finished process; its output is bytes."""
        options.setdefault("stdout", subprocess.PIPE)
        options.setdefault("timeout", 200)
        return subprocess.run(
            [PROGRAM, *arguments], cwd=self.directory, stdin=subprocess.DEVNULL,
            stderr=subprocess.PIPE, check=False, **options)

    @contextlib.contextmanager
    def started(self, *command, **options):
        """A process that runs at the same time, and does not outlive the block."""
        options.setdefault("stdin", subprocess.DEVNULL)
        with subprocess.Popen(command, cwd=self.directory, **options) as process:
            try:
                yield process
            finally:
                if process.poll() is None:
                    process.terminate()  # of which mpirun tells its processes
                    try:
                        process.wait(timeout=30)
                    except subprocess.TimeoutExpired:
                        process.kill()

    def wait_until(self, condition):
        deadline = time.monotonic() + 100
        while not condition():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)

    def output_of(self, *arguments, **options):
        """What a run that must succeed, without a word on standard error, prints."""
        process = self.run_program(*arguments, **options)
        self.assertEqual((process.returncode, process.stderr), (0, b""), arguments)
        return process.stdout

    def assert_fails(self, *arguments, mentions="", **options):
        """Exit code 2, one line on standard error, nothing on standard output, no file changed."""
        before = {name: self.read(name) for name in self.files()}
        process = self.run_program(*arguments, **options)
        message = process.stderr.decode()
        self.assertEqual(process.returncode, 2, (arguments, message))
        self.assertRegex(message, r"\Awellstrat: [^\n]+\n\Z", arguments)
        self.assertIn(mentions, message, arguments)
        self.assertFalse(process.stdout, arguments)
        self.assertEqual({name: self.read(name) for name in self.files()}, before, arguments)

    def assert_interrupt_leaves_nothing(self, *arguments):
        """Ctrl-C in a command that renders for long: it says so, and removes what it has begun."""
        with self.started(PROGRAM, *arguments, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE) as process:
            self.wait_until(self.files)
            time.sleep(2)  # until it renders
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.communicate(timeout=60)[1], b"wellstrat: interrupted\n")
            self.assertEqual(process.returncode, 130)
        self.assertEqual(self.files(), [])


def children(process):
    """The ids of the processes that a process has started."""
    with open(f"/proc/{process}/task/{process}/children", encoding="ascii") as file:
        return [int(child) for child in file.read().split()]


@unittest.skipUnless(os.environ.get("WELLSTRAT_WITH_MPI") == "1" and shutil.which("mpirun"),
                     "built without MPI")
class MpiCase(CliTest):
    """Runs the program in several processes at once."""

    def command(self, processes, *arguments):
        # Without /sys, as in some containers, hwloc would write errors among those of the program.
        return ["env", "HWLOC_HIDE_ERRORS=2", "mpirun", "--allow-run-as-root", "--oversubscribe",
                "-n", str(processes), PROGRAM, *arguments]

    def mpirun(self, processes, *arguments):
        return subprocess.run(self.command(processes, *arguments), cwd=self.directory,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=200,
                              check=False)

    def rank(self, launcher, rank):
        """The process id of one of the processes that `launcher` has started."""
        for process in children(launcher.pid):
            with open(f"/proc/{process}/environ", "rb") as file:
                if b"OMPI_COMM_WORLD_RANK=%d" % rank in file.read().split(b"\0"):
                    return process
        return self.fail(f"there is no rank {rank}")


def floats(data):
    """The numbers of bytes that hold little-endian 32-bit floats."""
    return numbers("f", data)


def words(data):
    """The numbers of bytes that hold little-endian 32-bit unsigned integers."""
    return numbers("I", data)


def numbers(code, data):
    values = array.array(code)
    assert values.itemsize == 4
    values.frombytes(data)
    if sys.byteorder == "big":
        values.byteswap()
    return values


def read_npy(data):
    """(type, shape, data) of a .npy file, read as the format's specification says."""
    assert data[:8] == b"\x93NUMPY\x01\x00", data[:8]
    end = 10 + int.from_bytes(data[8:10], "little")
    header = data[10:end].decode("ascii")
    assert end % 64 == 0 and header.endswith("\n"), header
    fields = ast.literal_eval(header)
    assert set(fields) == {"descr", "fortran_order", "shape"} and not fields["fortran_order"]
    return fields["descr"], fields["shape"], data[end:]


def read_csv(data):
    """Rows of numbers, each the double of a float that the text stands for."""
    return [tuple(to_float(field) for field in line.split(",")) for line in data.decode().split()]


def to_float(text):
    """The 32-bit float that a decimal number, or a double that was read from one, stands for."""
    return array.array("f", [float(text)])[0]
