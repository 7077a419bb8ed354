# SPDX-License-Identifier: Apache-2.0
"""`wellstrat study --filter`: the errors of pictures."""

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

SMALL = ("study", "--filter", "1", "--window", "24", "--generators", "pmj,random,zsobol",
         "--integrands", "2d,step", "--counts", "1,3,4", "--patterns", "5")


def rows(data):
    return list(csv.DictReader(io.StringIO(data.decode())))


class PicturesTest(CliTest):
    def test_list(self):
        text = self.output_of("study", "--list").decode().partition("With --filter")[2]
        for word in ("zsobol", "tile", "half-space-4d", "penumbra", "exponential",
                     "edge gaussian smooth", "1d-3d"):
            self.assertIn(word, text)

    def test_outputs_say_the_same(self):
        table = rows(self.output_of(*SMALL, "-o", "-"))
        self.assertEqual(len(table), 3 * 4 * 3)
        self.output_of(*SMALL, "-o", "r.json")
        result = json.loads(self.read("r.json"))
        self.assertEqual([rmse for curve in result["curves"] for rmse in curve["rmse"]],
                         [float(row["rmse"]) for row in table])
        self.assertEqual((result["filter"], result["window"], result["patterns"]), (1, 24, 5))
        self.assertNotIn("integral", result["curves"][0])
        for row in table:
            self.assertTrue(0 < float(row["low"]) < float(row["rmse"]) < float(row["high"]))

    def test_table(self):
        """Ratios to the first generator, and their geometric means over whole groups alone."""
        text = self.output_of(*SMALL).decode()
        rmse = {(row["generator"], row["integrand"]): float(row["rmse"])
                for row in rows(self.output_of(*SMALL, "-o", "-")) if row["points"] == "4"}
        blocks = {block.splitlines()[0]: {line.split()[0]: line.split()[1:]
                                          for line in block.splitlines()[1:]}
                  for block in text.split("\n\n")[1:]}
        self.assertEqual(list(blocks), ["edge", "gaussian", "smooth", "step",
                                        "2d, geometric mean of its 3"])
        ratios = []
        for integrand in ("edge", "gaussian", "smooth"):
            self.assertEqual(blocks[integrand]["generator"], ["N=1", "N=3", "N=4"])
            self.assertEqual(blocks[integrand]["pmj"], ["1.000"] * 3)
            ratios.append(rmse["zsobol", integrand] / rmse["pmj", integrand])
            self.assertEqual(blocks[integrand]["zsobol"][2], f"{ratios[-1]:.3f}")
        mean = math.exp(sum(map(math.log, ratios)) / 3)
        self.assertEqual(blocks["2d, geometric mean of its 3"]["zsobol"][2], f"{mean:.3f}")

    def test_filter_leaves_less(self):
        """Of white noise, after a Gaussian of sigma, about 1 / (2 sigma sqrt(pi)), and of blue noise
        less than half of that; both without any filter about the same. 5 pictures tell it to a few
        percent of white noise, and to a fifth where all pixels share one scrambling."""
        def rmse(sigma):
            table = rows(self.output_of("study", "--filter", sigma, "--integrands", "gaussian",
                                        "--counts", "4", "--patterns", "5", "-o", "-"))
            return [float(row["rmse"]) for row in table]
        plain, filtered = rmse("0"), rmse("2")
        self.assertAlmostEqual(plain[1] / plain[0], 1, delta=0.5)
        self.assertAlmostEqual(filtered[0] / plain[0] * 4 * math.sqrt(math.pi), 1, delta=0.2)
        self.assertLess(filtered[1] / filtered[0], 0.5)

    def test_slots_and_other_generators(self):
        text = self.output_of("study", "--filter", "0", "--window", "4", "--generators",
                              "joint:0+1,halton,jitter,sobol-owen,tile", "--integrands",
                              "penumbra,half-space-3d", "--patterns", "1", "--counts", "2").decode()
        self.assertIn("relative to joint:0+1\n", text)
        self.assertEqual(text.count("tile "), 2)

    def test_generators_say_where_contexts_begin(self):
        """Guards against pixels of blue samples with the contexts of others, which are white: 3 samples
        of slots have 0.4 of the error of white noise in 2D, and 0.5 to 0.7 in 4D."""
        table = rows(self.output_of("study", "--filter", "2", "--generators", "pmj,blue,blue:2+1,long",
                                    "--integrands", "gaussian,penumbra", "--counts", "3",
                                    "--patterns", "5", "-o", "-"))
        rmse = {(row["generator"], row["integrand"]): float(row["rmse"]) for row in table}
        for generator, integrand, low, high in (("blue", "gaussian", 0.2, 0.5),
                                                ("blue:2+1", "gaussian", 0.2, 0.5),
                                                ("blue:2+1", "penumbra", 0.3, 0.75),
                                                ("long", "gaussian", 0.85, 1.15)):
            ratio = rmse[generator, integrand] / rmse["pmj", integrand]
            self.assertTrue(low < ratio < high, (generator, integrand, ratio))

    def test_threads_change_no_bit(self):
        """All cores and one alone; guards against sums that depend on the order."""
        cores = os.sched_getaffinity(0)
        on_one = self.output_of(*SMALL, "-o", "-",
                                preexec_fn=lambda: os.sched_setaffinity(0, {min(cores)}))
        self.assertEqual(on_one, self.output_of(*SMALL, "-o", "-"))

    def test_bad_arguments(self):
        for arguments, mentions in (
                (("--filter", "17"), "from 0 to 16"), (("--filter", "-1"), "from 0 to 16"),
                (("--filter", "x"), "'x'"), (("--window", "8"), "--filter"),
                (("--filter", "2", "--window", "12"), "more than 12 pixels a side, not 12"),
                (("--filter", "2", "--window", "257"), "from 1 to 256"),
                (("--filter", "2", "--table", "4"), "--table"),
                (("--filter", "2", "--generators", "file:p.csv"), "for no pixels"),
                (("--filter", "2", "--generators", "zobol"), "zsobol, tile"),
                (("--filter", "2", "--generators", "zsobol", "--counts", "65537"), "65536"),
                (("--generators", "zsobol"), "no generator is called 'zsobol'"),
                (("--filter", "2", "--integrands", "disk"), "there are edge"),
                (("--filter", "2", "--counts", "all:1..65"), "at most 64"),
                (("--filter", "2", "--patterns", "65537"), "at most 65536 pictures"),
                (("--filter", "2", "-o", "r.txt"), ".csv, .json")):
            self.assert_fails("study", *arguments, mentions=mentions)

    @unittest.skipUnless(shutil.which("gnuplot"), "no gnuplot")
    def test_plot(self):
        self.output_of(*SMALL, "--plot", "error.svg")
        picture = self.read("error.svg").decode()
        for word in ("ZSobol", "Gaussian", "RMSE after a Gaussian of 1 pixels over 5 pictures"):
            self.assertIn(word, picture)


class UnfinishedPicturesTest(CliTest):
    def test_interrupted_pictures_go_on(self):
        """The same bits as in one go, and only with the same filter and window."""
        endless = [*SMALL[:-1], "60000", "-o", "r.csv", "--save-every", "0"]
        with self.started(PROGRAM, *endless, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE) as process:
            self.wait_until(lambda: os.path.exists(self.path("r.csv.state")))
            process.send_signal(signal.SIGINT)
            errors = process.communicate(timeout=100)[1].decode()
        done = json.loads(self.read("r.csv.state").split(b"\n")[0])["patterns"]
        self.assertEqual(errors, f"wellstrat: interrupted after {done} of 60000 pictures; "
                                 "--resume goes on\n")
        for option, value in (("--filter", "2"), ("--window", "25")):
            other = list(endless)
            other[other.index(option) + 1] = value
            self.assert_fails(*other, "--resume", mentions="differs in: filter")
        endless[endless.index("60000")] = str(done + 3)
        self.output_of(*endless, "--resume")
        endless[endless.index("r.csv")] = "whole.csv"
        self.output_of(*endless)
        self.assertEqual(self.read("r.csv"), self.read("whole.csv"))


class MpiPicturesTest(MpiCase):
    def test_processes_change_no_bit(self):
        process = self.mpirun(3, *SMALL, "-o", "-")
        self.assertEqual((process.returncode, process.stderr), (0, b""))
        self.assertEqual(process.stdout, self.output_of(*SMALL, "-o", "-"))


if __name__ == "__main__":
    unittest.main()
