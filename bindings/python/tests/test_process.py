# SPDX-License-Identifier: Apache-2.0
"""The package in a process: threads, forks, exits, sub-interpreters, what is loaded when."""

import concurrent.futures
import multiprocessing
import subprocess
import sys
import textwrap

import numpy as np
import pytest

import wellstrat


def run(program, *options):
    """What a program prints; its exit code must be 0 and nothing on standard error."""
    done = subprocess.run([sys.executable, *options, "-c", textwrap.dedent(program)],
                          capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (0, ""), done.stderr
    return done.stdout


def test_threads_draw_the_same():
    contexts = wellstrat.camera_contexts(300, 200)
    expected = {g: wellstrat.draw(contexts, 3, g) for g in ("pmj", "long", "blue", "random")}

    def draws(generator):
        return generator, wellstrat.draw(contexts, 3, generator)

    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        for generator, drawn in pool.map(draws, list(expected) * 20):
            assert np.array_equal(drawn, expected[generator])


def test_other_threads_run_meanwhile():
    # With the lock held, a thread that looks at the clock would not see it for the whole draw.
    assert run("""
        import threading, time, wellstrat
        gap, last, done = 0, time.perf_counter(), False
        def look():
            global gap, last
            while not done:
                now = time.perf_counter()
                gap, last = max(gap, now - last), now
        thread = threading.Thread(target=look)
        thread.start()
        shares = []
        for _ in range(5):  # other processes may stop the thread as well, but not each time
            gap, start = 0, time.perf_counter()
            wellstrat.samples(1, 2**22, dims=1, generator="blue", dtype="float64")
            shares.append(gap / (time.perf_counter() - start))
        done = True
        thread.join()
        print(min(shares) < 0.5)
    """) == "True\n"


def digest(seed):
    xy = wellstrat.samples(seed, 5000)
    return float(xy.sum()), wellstrat.analysis.spectrum(xy, 8)["peak"]


def test_processes_after_first_use():
    expected = [digest(seed) for seed in range(8)]
    for method in ("fork", "spawn"):
        with multiprocessing.get_context(method).Pool(2) as pool:
            assert pool.map(digest, range(8)) == expected


def test_a_fork_while_threads_draw():
    assert run("""
        import os, threading, wellstrat
        def draws():
            while True:
                wellstrat.samples(1, 200000)
        for _ in range(3):
            threading.Thread(target=draws, daemon=True).start()
        expected = wellstrat.samples(2, 1000).sum()
        for _ in range(5):
            child = os.fork()
            if child == 0:
                same = wellstrat.samples(2, 1000).sum() == expected
                raise SystemExit(0 if same else 1)
            assert os.waitpid(child, 0)[1] == 0
        print("done")
    """) == "done\n"


def test_the_interpreter_exits_while_threads_draw():
    for milliseconds in range(0, 30, 5):
        assert run(f"""
            import threading, time, wellstrat
            def draws():
                while True:
                    wellstrat.samples([1, 2, 3], 50000, generator="long")
            for _ in range(3):
                threading.Thread(target=draws, daemon=True).start()
            time.sleep({milliseconds} / 1000)
        """) == ""


def test_interrupts_end_long_draws():
    assert run("""
        import _thread, signal, threading, time, wellstrat
        signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may ignore it
        threading.Timer(0.2, _thread.interrupt_main).start()
        start = time.perf_counter()
        try:
            wellstrat.samples(range(64), 2**22, 0, 1, "blue", dtype="float64")  # takes seconds
        except KeyboardInterrupt:
            print(time.perf_counter() - start < 1)
    """) == "True\n"


def test_interrupts_end_long_measures():
    assert run("""
        import _thread, signal, threading, time, numpy, wellstrat
        signal.signal(signal.SIGINT, signal.default_int_handler)
        points = numpy.random.default_rng(1).random((2**16, 6))
        threading.Timer(0.2, _thread.interrupt_main).start()
        start = time.perf_counter()
        try:
            wellstrat.analysis.l2_discrepancies(points)  # takes seconds
        except KeyboardInterrupt:
            print(time.perf_counter() - start < 1)
    """) == "True\n"


def test_interrupts_end_studies():
    assert run("""
        import _thread, signal, threading, time, wellstrat
        signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell may ignore it
        threading.Timer(0.2, _thread.interrupt_main).start()
        start = time.perf_counter()
        try:
            wellstrat.analysis.study("pmj", counts=[4096], patterns=10**6)
        except KeyboardInterrupt:
            print(time.perf_counter() - start < 1)
    """) == "True\n"


def test_threads_measure_meanwhile():
    points = np.random.default_rng(1).random((2000, 3))
    expected = wellstrat.analysis.l2_discrepancies(points)
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        for found in pool.map(wellstrat.analysis.l2_discrepancies, [points] * 32):
            assert found == expected


def test_what_the_computer_lacks_is_named():
    assert run("""
        import resource, numpy, wellstrat
        picture, points = numpy.zeros((2000, 2000)), numpy.full((4, 2), 0.5)
        measure, discrepancies = wellstrat.analysis.picture_spectrum, wellstrat.analysis.l2_discrepancies

        def within(mebibytes, call):  # beside what is in use
            with open("/proc/self/statm") as file:
                used = int(file.read().split()[0]) * resource.getpagesize()
            resource.setrlimit(resource.RLIMIT_AS, (used + mebibytes * 2**20, -1))
            try:
                call()
            except Exception as error:
                print(f"{type(error).__name__}: {error}")

        within(20, lambda: measure(picture))  # needs a copy of 32 MB
        within(4, lambda: discrepancies(points))  # needs a thread with a stack
    """) == ("MemoryError: there is not enough memory\n"
             "RuntimeError: no thread can be started: Resource temporarily unavailable\n")


def test_sub_interpreters_are_refused():
    interpreters = pytest.importorskip("_xxsubinterpreters")
    interpreter = interpreters.create()
    try:
        with pytest.raises(interpreters.RunFailedError, match="main interpreter only"):
            interpreters.run_string(interpreter, "import wellstrat")
    finally:
        interpreters.destroy(interpreter)
    assert wellstrat.samples(1, 1).shape == (1, 2)


def test_submodules_load_at_first_use():
    assert run("""
        import sys, wellstrat
        late = ("scipy", "matplotlib", "wellstrat.qmc", "wellstrat.plot", "wellstrat.analysis",
                "wellstrat._analysis")
        assert not any(name.startswith(late) for name in sys.modules)
        assert {"analysis", "plot", "qmc", "warp"} <= set(dir(wellstrat))
        wellstrat.analysis.t_value([[0.5]])
        assert not any(name.startswith(("scipy", "matplotlib")) for name in sys.modules)
        wellstrat.qmc.OwenSobol
        wellstrat.plot.points
        print("scipy" in sys.modules, "matplotlib" in sys.modules)
    """) == "True True\n"


@pytest.mark.parametrize("submodule, missing, needs", (
    ("qmc", "scipy", "SciPy 1.10 or newer: install python3-scipy of Debian, or scipy by pip"),
    ("plot", "matplotlib", "matplotlib: install python3-matplotlib of Debian, or matplotlib by pip"),
    ("analysis", "wellstrat._analysis", "FFTW 3: install libfftw3-double3 of Debian (import of "
     "wellstrat._analysis halted; None in sys.modules)"),
))
def test_without_what_a_submodule_needs(submodule, missing, needs):
    assert run(f"""
        import sys
        sys.modules["{missing}"] = None
        import wellstrat
        wellstrat.samples(1, 4)
        try:
            wellstrat.{submodule}
        except ImportError as error:
            print(error)
    """) == f"wellstrat.{submodule} needs {needs}\n"


def test_without_tqdm():
    assert run("""
        import sys
        sys.modules["tqdm"] = None
        import wellstrat
        try:
            wellstrat.analysis.spectrum(wellstrat.samples(1, 4), progress=True)
        except ImportError as error:
            print(str(error).split(":")[0])
    """) == "progress=True needs tqdm\n"


def test_unknown_names():
    with pytest.raises(AttributeError, match="module 'wellstrat' has no attribute 'sample'"):
        wellstrat.sample


def test_the_module_says_what_it_is():
    done = subprocess.run([sys.executable, "-m", "wellstrat"], capture_output=True, text=True,
                          check=True)
    version, stream, target = done.stdout.splitlines()
    assert version == f"wellstrat {wellstrat.__version__}"
    assert stream == f"stream version {wellstrat.stream_version}"
    assert target.startswith("instruction set ")
