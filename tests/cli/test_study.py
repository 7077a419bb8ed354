# SPDX-License-Identifier: Apache-2.0
"""`wellstrat study`."""

import contextlib
import csv
import io
import json
import math
import os
import shutil
import signal
import subprocess
import unittest

from support import PROGRAM, CliTest, MpiCase

SMALL = ("study", "--generators", "pmj,random,jitter", "--integrands", "disk,linear,disk^2",
         "--counts", "4,16,64", "--patterns", "60")
ENDLESS = ("study", "--integrands", "disk,step", "--counts", "pow2:4..1024", "--patterns",
           "100000000", "-o", "r.csv", "--save-every", "0")


def rows(data):
    return list(csv.DictReader(io.StringIO(data.decode())))


class StudyTest(CliTest):
    def test_list(self):
        text = self.output_of("study", "--list").decode()
        for word in ("disk", "triangle", "step", "gaussian", "bilinear", "edge-A", "soft-shadow",
                     "checkerboard-Z", "exp(-x^2 - y^2)", "pmj", "sobol-owen", "jitter",
                     "halton", "joint", "joint:3+7", "long", "long:3+7", "blue", "blue:3+7", "file:PATH",
                     "classic"):
            self.assertIn(word, text)

    def test_csv(self):
        table = rows(self.output_of(*SMALL, "-o", "-"))
        self.assertEqual(len(table), 27)
        self.assertEqual(list(table[0]), ["generator", "integrand", "points", "patterns", "rmse",
                                          "low", "high", "bias"])
        for row in table:
            self.assertEqual(row["patterns"], "60")
            self.assertTrue(0 < float(row["low"]) < float(row["rmse"]) < float(row["high"]))
        # The error of random points for x is sqrt(1 / 12 / N); 60 patterns tell it to 9 %.
        for row in table:
            if (row["generator"], row["integrand"]) == ("random", "linear"):
                expected = math.sqrt(1 / 12 / int(row["points"]))
                self.assertAlmostEqual(float(row["rmse"]) / expected, 1, delta=0.4)

    def test_json_says_the_same(self):
        self.output_of(*SMALL, "-o", "r.json")
        self.output_of(*SMALL, "-o", "r.csv")
        result = json.loads(self.read("r.json"))
        values = [rmse for curve in result["curves"] for rmse in curve["rmse"]]
        self.assertEqual(values, [float(row["rmse"]) for row in rows(self.read("r.csv"))])
        self.assertEqual((result["patterns"], result["points"]), (60, [4, 16, 64]))
        self.assertIn("slope", result["curves"][0]["slope"])
        self.assertEqual(self.files(), ["r.csv", "r.csv.state", "r.json", "r.json.state"])

    def test_table(self):
        text = self.output_of(*SMALL, "--table", "16,64").decode()
        self.assertIn("N=16", text)
        self.assertNotIn("N=4 ", text)
        self.assertRegex(text, r"\njitter +\d\.\d{3}e-\d\d +\d\.\d{3}e-\d\d ")

    def test_counts(self):
        def counts(text):
            return [int(row["points"]) for row in rows(self.output_of(
                "study", "--generators", "pmj", "--integrands", "disk", "--counts", text,
                "--patterns", "2", "-o", "-"))]
        self.assertEqual(counts("all:3..7"), [3, 4, 5, 6, 7])
        self.assertEqual(counts("pow2:3..33"), [4, 8, 16, 32])
        self.assertEqual(counts("100,4,16,4"), [4, 16, 100])
        self.assertEqual(counts("9,pow2:1..4,all:2..3"), [1, 2, 3, 4, 9])

    def test_threads_change_no_bit(self):
        """All cores and one alone; guards against sums that depend on the order."""
        cores = os.sched_getaffinity(0)
        on_one = self.output_of(*SMALL, "-o", "-",
                                preexec_fn=lambda: os.sched_setaffinity(0, {min(cores)}))
        self.assertEqual(on_one, self.output_of(*SMALL, "-o", "-"))

    def test_points_of_files(self):
        points = self.output_of("sample", "--count", "64", "--pattern", "5")
        with open(self.path("points.csv"), "wb") as file:
            file.write(points)
        study = ("study", "--integrands", "disk", "--counts", "64", "--patterns", "1", "-o", "-")
        row = rows(self.output_of(*study, "--generators", "file:points.csv"))[0]
        inside = sum(1 for line in points.split()
                     if sum(float(x) ** 2 for x in line.split(b",")) < 2 / math.pi)
        self.assertAlmostEqual(float(row["bias"]), inside / 64 - 0.5, delta=1e-12)
        self.assertEqual(row["low"], "")
        self.assert_fails(*study, "--generators", "file:none.csv", mentions="none.csv")
        self.assert_fails("study", "--integrands", "gaussian-3d", "--generators",
                          "file:points.csv", "--counts", "64", "--patterns", "1",
                          mentions="64 points in 2 dimensions")

    def test_bad_arguments(self):
        for arguments, mentions in (
                (("--generators", "sobl"), "no generator is called 'sobl'"),
                (("--integrands", "dsk"), "no integrand is called 'dsk'"),
                (("--integrands", "disk^6"), "from 1 to 5"),
                (("--counts", "0"), "--counts"), (("--counts", "all:5..4"), "--counts"),
                (("--counts", "pow3:1..9"), "--counts"), (("--counts", ""), "--counts"),
                (("--counts", "all:1..9999999"), "--counts"),
                (("--counts", "pow2:5..7"), "--counts"),
                (("--patterns", "0"), "--patterns"), (("--patterns", "1e3"), "--patterns"),
                (("-o", "r.txt"), ".csv, .json"), (("--plot", "r.txt"), ".png"),
                (("--table", "x"), "x"), (("--resume",), "--resume"),
                (("--integrands", "edges,boxes", "--plot", "p.svg"), "--plot: at most 36")):
            self.assert_fails("study", *arguments, mentions=mentions)

    @unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
    def test_plot(self):
        self.output_of(*SMALL, "--plot", "error.svg", "--keep-plot-files")
        self.assertEqual(self.files(), ["error.dat", "error.gp", "error.svg"])
        self.assertIn(b"<svg", self.read("error.svg"))
        picture = self.read("error.svg").decode()
        for word in ("Disk in 2 domains", "Linear", "Jittered", "RMSE over 60 patterns"):
            self.assertIn(word, picture)
        self.assertEqual(self.read("error.dat").count(b"# curve"), 9)


class UnfinishedTest(CliTest):
    @contextlib.contextmanager
    def unfinished(self, command, state="r.csv.state"):
        """The process of an endless study, when its first state is saved."""
        with self.started(*command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            self.wait_until(lambda: os.path.exists(self.path(state)))
            yield process

    def remove_temporaries(self):
        for name in self.files():
            if name.startswith(".wellstrat-"):
                os.remove(self.path(name))

    def remove_results(self):
        for name in self.files():
            os.remove(self.path(name))

    def finished_patterns(self):
        return json.loads(self.read("r.csv.state").split(b"\n")[0])["patterns"]

    def with_patterns(self, patterns, output):
        arguments = list(ENDLESS)
        arguments[arguments.index("--patterns") + 1] = str(patterns)
        arguments[arguments.index("-o") + 1] = output
        return arguments

    def assert_goes_on(self):
        """Resumed and then complete: the same bits as in one go."""
        patterns = self.finished_patterns() + 10
        self.assert_fails(*ENDLESS, mentions="--resume")
        self.output_of(*self.with_patterns(patterns, "r.csv"), "--resume")
        self.output_of(*self.with_patterns(patterns, "whole.csv"))
        self.assertEqual(self.read("r.csv"), self.read("whole.csv"))
        self.assertEqual(self.files(), ["r.csv", "r.csv.state", "whole.csv", "whole.csv.state"])


class ResumeTest(UnfinishedTest):
    def interrupted(self, stop):
        """The exit code, the output and the errors of an endless study that a signal ends."""
        with self.unfinished([PROGRAM, *ENDLESS]) as process:
            process.send_signal(stop)
            output, errors = process.communicate(timeout=100)
            return process.returncode, output, errors.decode()

    def test_interrupt_keeps_what_is_finished(self):
        code, output, errors = self.interrupted(signal.SIGINT)
        self.assertEqual(code, 130)
        patterns = self.finished_patterns()
        self.assertEqual(errors, f"wellstrat: interrupted after {patterns} of 100000000 patterns; "
                                 "--resume goes on\n")
        self.assertIn(f"RMSE over {patterns} patterns".encode(), output)
        self.assertEqual({row["patterns"] for row in rows(self.read("r.csv"))}, {str(patterns)})
        self.assert_goes_on()

    def test_killed_runs_go_on_from_the_last_saving(self):
        self.interrupted(signal.SIGKILL)
        self.remove_temporaries()
        self.assert_goes_on()

    def test_only_the_same_study_goes_on(self):
        self.interrupted(signal.SIGTERM)
        for option, value, mentions in (("--integrands", "disk", "integrands"),
                                        ("--counts", "4", "counts"),
                                        ("--generators", "pmj", "generators"),
                                        ("--patterns", "1", "--patterns 1")):
            arguments = [*ENDLESS, option, value]
            if option in ENDLESS:
                arguments = list(ENDLESS)
                arguments[arguments.index(option) + 1] = value
            self.assert_fails(*arguments, "--resume", mentions=mentions)

    def test_a_finished_study_can_be_extended(self):
        self.output_of(*self.with_patterns(10, "r.csv"))
        self.output_of(*self.with_patterns(30, "r.csv"), "--resume")
        self.output_of(*self.with_patterns(30, "whole.csv"))
        self.assertEqual(self.read("r.csv"), self.read("whole.csv"))
        self.assertEqual(self.read("r.csv.state"), self.read("whole.csv.state"))
        self.assert_fails(*self.with_patterns(20, "r.csv"), "--resume", mentions="--patterns 20")
        self.output_of(*self.with_patterns(20, "r.csv"))  # from the beginning

    def test_damaged_states_are_found(self):
        self.interrupted(signal.SIGINT)
        state = self.read("r.csv.state")
        for damaged in (b"", b"{}", b"text\n", state[:-1 - len("end\n")], state[:len(state) // 2],
                        state.replace(b"\n0", b"\nx", 1), state.replace(b"\nf", b"\n-", 1)):
            if damaged == state:
                continue
            with open(self.path("r.csv.state"), "wb") as file:
                file.write(damaged)
            self.assert_fails(*ENDLESS, "--resume", mentions="--resume")


class MpiTest(MpiCase, UnfinishedTest):
    def test_splits_change_no_bit(self):
        self.output_of(*SMALL, "-o", "alone.csv")
        for processes in (1, 2, 3, 4):
            process = self.mpirun(processes, *SMALL, "-o", "split.csv")
            self.assertEqual((process.returncode, process.stderr), (0, b""))
            self.assertEqual(self.read("split.csv"), self.read("alone.csv"))
            self.assertEqual(process.stdout.count(b"RMSE over"), 1)

    def test_errors_are_said_once(self):
        process = self.mpirun(3, "study", "--counts", "none")
        self.assertEqual(process.returncode, 2)
        self.assertEqual(process.stderr.count(b"wellstrat: --counts"), 1)

    def test_interrupt_keeps_what_is_finished(self):
        """Under mpirun, under other numbers of processes and alone, it goes on to the same bits."""
        with self.unfinished(self.command(2, *ENDLESS)) as process:
            process.send_signal(signal.SIGINT)
            output, errors = process.communicate(timeout=100)
        self.assertNotEqual(process.returncode, 0)
        self.assertIn(b"RMSE over", output)
        self.assertEqual(errors.count(b"--resume goes on"), 1)
        patterns = self.finished_patterns() + 10
        process = self.mpirun(3, *self.with_patterns(patterns, "r.csv"), "--resume")
        self.assertEqual((process.returncode, process.stderr), (0, b""))
        self.output_of(*self.with_patterns(patterns, "whole.csv"))
        self.assertEqual(self.read("r.csv"), self.read("whole.csv"))
        self.assertEqual(self.files(), ["r.csv", "r.csv.state", "whole.csv", "whole.csv.state"])

    def test_a_killed_process_ends_all(self):
        for rank in (0, 1):
            with self.unfinished(self.command(2, *ENDLESS)) as process:
                os.kill(self.rank(process, rank), signal.SIGKILL)
                _, errors = process.communicate(timeout=100)
            self.assertEqual(process.returncode, 128 + signal.SIGKILL)
            self.assertRegex(errors.decode(), rf"rank {rank} [^.]*\n?[^.]*signal 9")
            self.remove_temporaries()
            self.assert_goes_on()
            self.remove_results()


if __name__ == "__main__":
    unittest.main()
