# SPDX-License-Identifier: Apache-2.0
"""Builds the benchmark program, for this tree and for other revisions, and runs it. For
scripts/bench."""

import json
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILDS = ROOT / "build" / "benchmarks"
UNIT = "rival: drand48"  # two calls: the cost of a 2D sample that ratios refer to
CLUTTERED = "cluttered "  # begins the names of scenarios whose caches are full of something else


def build_here():
    """Builds the benchmarks of this tree; returns the program."""
    folder = BUILDS / "here"
    if not build(ROOT, folder):
        sys.exit("bench: the build failed; scripts/setup bench installs what it needs")
    return program_in(folder)


def build_revision(revision):
    """Builds the benchmarks of this tree with the headers and the library of another revision.
    Where that has another interface of jointly stratified domains, without these."""
    name = git("rev-parse", "--verify", "--quiet", revision + "^{commit}").decode().strip()[:12]
    if not name:
        sys.exit(f"bench: --against takes a revision of this repository, not '{revision}'")
    source, folder = BUILDS / name / "source", BUILDS / name / "build"
    if not source.is_dir():
        unpacked = BUILDS / name / "source.part"
        shutil.rmtree(unpacked, ignore_errors=True)
        unpacked.mkdir(parents=True)
        subprocess.run(["tar", "-x", "-C", unpacked], input=git("archive", name), check=True)
        unpacked.rename(source)
    if not build(source, folder, stderr=subprocess.DEVNULL):
        print(f"bench/joint.cpp does not compile with {revision}: left out there", flush=True)
        if not build(source, folder, "-DWELLSTRAT_BENCH_JOINT=OFF"):
            sys.exit(f"bench: today's benchmarks do not compile with {revision}")
    return program_in(folder)


def git(*arguments):
    return subprocess.run(["git", "-C", ROOT, *arguments], stdout=subprocess.PIPE).stdout


def build(library, folder, *options, stderr=None):
    """Builds bench/ of this tree with the wellstrat in `library`. False if that fails."""
    configure = ["cmake", "-S", ROOT / "bench", "-B", folder, "-DCMAKE_BUILD_TYPE=Release",
                 f"-DWELLSTRAT_BENCH_LIBRARY={library}", "-DCMAKE_RULE_MESSAGES=OFF", *options]
    if shutil.which("ccache"):
        configure.append("-DCMAKE_CXX_COMPILER_LAUNCHER=ccache")
    return all(subprocess.run(command, stdout=subprocess.DEVNULL, stderr=stderr).returncode == 0
               for command in (configure, ["cmake", "--build", folder, "-j2"]))


def build_batch_rounds():
    """Builds what the benchmark of the npm package measures in turn with; returns the program."""
    folder = BUILDS / "here"
    build_here()
    command = ["cmake", "--build", folder, "--target", "batch_rounds"]
    if subprocess.run(command, stdout=subprocess.DEVNULL).returncode != 0:
        sys.exit("bench: batch_rounds cannot be built")
    return folder / "bin" / "batch_rounds"


def program_in(folder):
    return folder / "bin" / "wellstrat_bench"


def measure(program, names, repetitions):
    """Runs the scenarios whose names match in one process, repetitions interleaved: what the
    program says about the machine, and by name the nanoseconds per item of each repetition."""
    command = [
        program,
        "--benchmark_format=json",
        f"--benchmark_repetitions={repetitions}",
        "--benchmark_enable_random_interleaving=true",
        "--benchmark_min_time=0.05",
        f"--benchmark_filter={names}",
    ]
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    if done.returncode != 0:
        sys.exit("bench: the benchmark program failed")
    report = json.loads(done.stdout)
    results = {}
    for run in report["benchmarks"]:
        if run["run_type"] == "iteration":  # the counter is scaled to nanoseconds
            results.setdefault(run["run_name"], []).append(run["ns"])
    return report["context"], dict(sorted(results.items()))


def measure_in_turn(programs, names, repetitions):
    """The results of each program, all of which run once for each repetition, in changing order."""
    results = [{} for _ in programs]
    for repetition in range(repetitions):
        order = list(zip(programs, results))
        for program, mine in order if repetition % 2 == 0 else reversed(order):
            context, times = measure(program, names, 1)
            for name, values in times.items():
                mine.setdefault(name, []).extend(values)
    return context, [dict(sorted(mine.items())) for mine in results]


def spread(values):
    """Half the interquartile range, of fewer than four values half the range, in per cent of the
    median."""
    quarters = statistics.quantiles(values, n=4) if len(values) > 3 else sorted(values)
    return 50 * (quarters[-1] - quarters[0]) / statistics.median(values)


def processor():
    text = pathlib.Path("/proc/cpuinfo").read_text() if os.path.exists("/proc/cpuinfo") else ""
    match = re.search(r"model name\s*:\s*(.*)", text)
    return match.group(1) if match else os.uname().machine


def table_times(program, runs):
    """Milliseconds to build all tables, each time in a process of its own."""
    command = [program, "--time-tables"]
    return [float(subprocess.check_output(command, text=True)) for _ in range(runs)]


def library_sizes():
    """KiB of text and data of each library of this tree that was built, by name."""
    sizes = {}
    for path in sorted((BUILDS / "here" / "wellstrat" / "src").glob("*.a")):
        last = subprocess.check_output(["size", "-t", path], text=True).splitlines()[-1].split()
        sizes[path.name] = (int(last[0]) + int(last[1])) / 1024
    return sizes


INSTRUCTION_PATHS = ("scalar", "scalar-3D", "path-of-8", "chain", "few-points", "joint", "long",
                     "batch")


def instructions_per_sample(program):
    """By path that the program has, from two callgrind runs of different length, less what makes
    the contexts."""
    if shutil.which("valgrind") is None:
        sys.exit("bench: --instructions needs valgrind")
    known = subprocess.run([program, "--count", "", "0"], stderr=subprocess.PIPE, text=True).stderr
    paths = [path for path in INSTRUCTION_PATHS if path in known.split()]
    counts = {path: (instructions(program, path, 300000) - instructions(program, path, 100000))
              / 200000 for path in ("nothing", *paths)}
    return {path: counts[path] - counts["nothing"] for path in paths}


def instructions(program, path, samples):
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program]
    done = subprocess.run(
        command + ["--count", path, str(samples)],
        stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
    )
    match = re.search(r"Collected : (\d+)", done.stderr)
    if done.returncode != 0 or match is None:
        sys.exit(f"bench: valgrind failed on {path}")
    return int(match.group(1))
