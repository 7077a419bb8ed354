# SPDX-License-Identifier: Apache-2.0
"""Measures `wellstrat analyze` beside SciPy and OpenTURNS. For scripts/bench --analysis."""

import json
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
MOST_FOR_RIVALS = 1 << 14  # their time grows with the square of the number of points
IMPORT_SCIPY = "import sys, numpy; from scipy.stats import qmc; "
SCIPY = IMPORT_SCIPY + """points = numpy.load(sys.argv[1])
for method in ("L2-star", "CD", "WD", "MD"):
    qmc.discrepancy(points, method=method)
"""
IMPORT_OPENTURNS = "import sys, numpy, openturns; "
OPENTURNS = IMPORT_OPENTURNS + """points = openturns.Sample(numpy.load(sys.argv[1]).tolist())
print(openturns.LowDiscrepancySequence().computeStarDiscrepancy(points))
"""


def print_times():
    """Processor seconds of each measure of random points, of SciPy's four L2 discrepancies, and of
    OpenTURNS's star discrepancy, with its value beside ours."""
    build()
    python = "/usr/bin/python3" if os.path.exists("/usr/bin/python3") else sys.executable
    names = [name for name in MEASURES if name != "independence"]  # of several sets
    for dims in (2, 3):
        print(f"\nprocessor seconds, {dims}D, and star discrepancies")
        print(f"{'points':>9}{'all':>9}" + "".join(f"{name:>11}" for name in names)
              + f"{'SciPy L2':>11}{'OpenTURNS star':>16}{'its value':>11}   ours")
        for count in COUNTS:
            with tempfile.TemporaryDirectory() as folder:
                points = os.path.join(folder, "points.npy")
                run(PROGRAM, "sample", "--generator", "random", "--dims", str(dims), "--count",
                    str(count), "-o", points)
                reading = analyze(points)
                cells = [f"{analyze(points, *MEASURES):9.2f}"]
                cells += [f"{max(analyze(points, name) - reading, 0):11.2f}" for name in names]
                cells += rival_cells(python, points) if count <= MOST_FOR_RIVALS else []
                print(f"{count:9}" + "".join(cells), flush=True)


def rival_cells(python, points):
    scipy = seconds_of(python, "-c", SCIPY, points) - seconds_of(python, "-c", IMPORT_SCIPY)
    openturns = (seconds_of(python, "-c", OPENTURNS, points)
                 - seconds_of(python, "-c", IMPORT_OPENTURNS))
    star = json.loads(run(*analysis(points, "star")))["discrepancy"]["star"]
    ours = " to ".join(f"{bound:.5f}" for bound in sorted(set(star)))
    return [f"{scipy:11.2f}{openturns:16.2f}{float(run(python, '-c', OPENTURNS, points)):11.5f}   "
            + ours]


def analyze(points, *taken):
    """The seconds of an analysis that takes these measures only."""
    return seconds_of(*analysis(points, *taken))


def analysis(points, *taken):
    return (PROGRAM, "analyze", points, "--json",
            *(f"--no-{name}" for name in MEASURES if name not in taken))


def seconds_of(*command):
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime

    before = used()
    run(*command)
    return used() - before


def run(*command):
    """The standard output."""
    process = subprocess.run(command, stdout=subprocess.PIPE)
    if process.returncode != 0:
        sys.exit(f"bench: {command[0]} failed; scripts/setup bench installs what it needs")
    return process.stdout


def build():
    for command in (["cmake", "--preset", "release"],
                    ["cmake", "--build", "--preset", "release", "--target", "wellstrat_cli"]):
        if subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL).returncode != 0:
            sys.exit("bench: the build failed; scripts/setup build installs what it needs")
