# SPDX-License-Identifier: Apache-2.0
"""Files appear complete or not at all, under any name; terminals get text only."""

import os
import resource
import signal
import stat
import subprocess
import unittest

from support import PROGRAM, CliTest

SAMPLE = ("sample", "--count", "100")
SAFE_NAMES = ("with space", "quo'te", 'double"quote', "back`touch pwned`tick", "$(touch pwned)",
              "new\nline", "<touch pwned", "|touch pwned", ";touch pwned", "&touch pwned", "~",
              "%s%n", "back\\slash", "\u00e9t\u00e9", "-dash", "*", "x" * 240)


def small_files():
    """Makes writes beyond 4 KiB fail in the child process."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))


class OutputTest(CliTest):
    def test_any_name(self):
        expected = self.output_of(*SAMPLE)
        for name in SAFE_NAMES:
            self.output_of(*SAMPLE, "--output=" + name + ".csv")
            self.assertEqual(self.read(name + ".csv"), expected)
        self.assertEqual(self.files(), sorted(name + ".csv" for name in SAFE_NAMES))

    def test_an_existing_file_is_replaced(self):
        with open(self.path("points.csv"), "wb") as file:
            file.write(b"x" * 100000)
        self.output_of(*SAMPLE, "-o", "points.csv")
        self.assertEqual(self.read("points.csv"), self.output_of(*SAMPLE))
        self.assertEqual(self.files(), ["points.csv"])

    def test_permissions_are_those_of_new_files(self):
        self.output_of(*SAMPLE, "-o", "points.csv", umask=0o027)
        self.assertEqual(stat.S_IMODE(os.stat(self.path("points.csv")).st_mode), 0o640)

    def test_a_link_stays(self):
        os.mkdir(self.path("elsewhere"))
        with open(self.path("elsewhere/target.csv"), "wb") as file:
            file.write(b"old")
        os.symlink("elsewhere/target.csv", self.path("link.csv"))
        self.output_of(*SAMPLE, "-o", "link.csv")
        self.assertTrue(os.path.islink(self.path("link.csv")))
        self.assertEqual(self.read("elsewhere/target.csv"), self.output_of(*SAMPLE))

    def test_devices_are_not_replaced(self):
        self.output_of(*SAMPLE, "-o", "/dev/null")
        self.assertTrue(stat.S_ISCHR(os.stat("/dev/null").st_mode))

    def test_failed_writes_leave_the_old_file(self):
        for name in ("points.csv", "points.npy", "tables.bin"):
            with open(self.path(name), "wb") as file:
                file.write(b"old")
        for name in ("points.csv", "points.npy"):
            self.assert_fails("sample", "--count", "100000", "-o", name, preexec_fn=small_files)
        self.assert_fails("tables", "--export", "tables.bin", preexec_fn=small_files)

    def test_signals_leave_no_file(self):
        """A long run, ended while it writes, leaves neither a part nor a temporary file."""
        for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.started(PROGRAM, "sample", "--count", "4000000000", "-o", "a.csv",
                              stderr=subprocess.PIPE) as process:
                self.wait_until(lambda: any(os.path.getsize(self.path(name))
                                            for name in self.files()))
                process.send_signal(stop)
                self.assertEqual(process.communicate(timeout=60)[1], b"")
                self.assertEqual(process.returncode, -stop)
            self.assertEqual(self.files(), [])

    @unittest.skipUnless(os.path.exists("/dev/full"), "no /dev/full")
    def test_full_standard_output_is_an_error(self):
        for arguments in (SAMPLE, ("info",), ("verify", "--tables", "0..0", "--patterns", "1")):
            with open("/dev/full", "wb") as full:
                self.assert_fails(*arguments, stdout=full, mentions="standard output")

    def test_no_binary_on_a_terminal(self):
        controller, terminal = self.open_terminal()
        try:
            self.assert_fails(*SAMPLE, "--format", "npy", stdout=terminal, mentions="-o")
            self.assertEqual(self.run_program(*SAMPLE, stdout=terminal).returncode, 0)
        finally:
            os.close(terminal)
            os.close(controller)


if __name__ == "__main__":
    unittest.main()
