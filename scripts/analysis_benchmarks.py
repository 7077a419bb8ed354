# SPDX-License-Identifier: Apache-2.0
"""Measures `wellstrat analyze` beside SciPy. For scripts/bench --analysis."""

import os
import pathlib
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAM = ROOT / "build" / "release" / "bin" / "wellstrat"
MEASURES = ("nets", "star", "l2", "distances", "pairs", "spectra", "independence")
COUNTS = (1 << 12, 1 << 14, 1 << 16, 1 << 20)
MOST_FOR_SCIPY = 1 << 14  # its time grows with the square of the number of points
SCIPY = """
import sys, numpy
from scipy.stats import qmc
points = numpy.load(sys.argv[1])
for method in ("L2-star", "CD", "WD", "MD"):
    qmc.discrepancy(points, method=method)
"""


def print_times():
    """Processor seconds of each measure of random points, and of SciPy's four L2 discrepancies."""
    build()
    python = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
    names = [name for name in MEASURES if name != "independence"]  # of several sets
    for dims in (2, 3):
        print(f"\nprocessor seconds, {dims}D")
        print(f"{'points':>9}{'all':>9}" + "".join(f"{name:>11}" for name in names)
              + f"{'SciPy L2':>11}")
        for count in COUNTS:
            with tempfile.TemporaryDirectory() as folder:
                points = os.path.join(folder, "points.npy")
                run(PROGRAM, "sample", "--generator", "random", "--dims", str(dims), "--count",
                    str(count), "-o", points)
                reading = analyze(points)
                cells = [f"{analyze(points, *MEASURES):9.2f}"]
                cells += [f"{max(analyze(points, name) - reading, 0):11.2f}" for name in names]
                if count <= MOST_FOR_SCIPY:
                    started = seconds_of(python, "-c", "import numpy; from scipy.stats import qmc")
                    cells.append(f"{seconds_of(python, '-c', SCIPY, points) - started:11.2f}")
                print(f"{count:9}" + "".join(cells), flush=True)


def analyze(points, *taken):
    """The seconds of an analysis that takes these measures only."""
    left_out = [f"--no-{name}" for name in MEASURES if name not in taken]
    return seconds_of(PROGRAM, "analyze", points, "--json", *left_out)


def seconds_of(*command):
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    before = used()
    run(*command)
    return used() - before


def run(*command):
    if subprocess.run(command, stdout=subprocess.DEVNULL).returncode != 0:
        sys.exit(f"bench: {command[0]} failed")


def build():
    for command in (["cmake", "--preset", "release"],
                    ["cmake", "--build", "--preset", "release", "--target", "wellstrat_cli"]):
        if subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL).returncode != 0:
            sys.exit("bench: the build failed; scripts/setup build installs what it needs")
