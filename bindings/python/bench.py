# SPDX-License-Identifier: Apache-2.0
"""Measures the Python package beside NumPy and SciPy, in one run: speed, and the error of integrals.

    scripts/python-package --bench           builds, installs and measures everything
    scripts/python-package --bench speed     this part only

Prints a table for each part. Times are the shortest of several that take turns.
"""

import math
import subprocess
import sys
import time

import numpy as np
from scipy.special import erf
from scipy.stats import qmc

import wellstrat

SEEDS = 40
LOG_SIZES = range(4, 21)
LEVELS = 32


def shortest(*functions, turns=60):
    """The shortest time of each function, in seconds. They take turns of 3 ms or one call."""
    best = [math.inf] * len(functions)
    for _ in range(turns):
        for i, function in enumerate(functions):
            begin = end = time.perf_counter()
            while end < begin + 3e-3:
                start = end
                function()
                end = time.perf_counter()
                best[i] = min(best[i], end - start)
    return best


def shortest_alone(*statements):
    """The same of statements that allocate much, each in processes of its own: in one, it depends on
    their order who gets memory that is mapped already."""
    program = """if True:
        import timeit, wellstrat
        from scipy.stats import qmc
        wellstrat.qmc
        print(min(timeit.repeat(lambda: {}, number=1, repeat=60)))"""
    best = [math.inf] * len(statements)
    for _ in range(5):
        for i, statement in enumerate(statements):
            done = subprocess.run([sys.executable, "-c", program.format(statement)], check=True,
                                  capture_output=True, text=True)
            best[i] = min(best[i], float(done.stdout))
    return best


def print_table(head, rows):
    """As Markdown, in columns."""
    lines = [head, *rows]
    widths = [max(len(line[k]) for line in lines) for k in range(len(head))]
    lines.insert(1, ["-" * width for width in widths])
    for line in lines:
        print("| " + " | ".join(cell.ljust(width) for cell, width in zip(line, widths)) + " |")


def compared(name, other, wanted, times):
    """A row of the speeds: `times` are ours and the other's."""
    ours, theirs = (f"{1e3 * seconds:.3g} ms" for seconds in times)
    return [name, ours, other, theirs, f"{times[1] / times[0]:.1f}", f"{wanted}"]


def importing():
    """The shortest time that importing the package takes once NumPy is there, in seconds."""
    program = """if True:
        import numpy, time
        start = time.perf_counter()
        import wellstrat
        print(time.perf_counter() - start)"""
    return min(float(subprocess.run([sys.executable, "-c", program], check=True,
                                    capture_output=True, text=True).stdout) for _ in range(15))


def measure_speed():
    sobol = "SciPy's scrambled Sobol'"
    rows = [compared("`OwenSobol`: 2^20 points, 2D, float64", sobol, 4, shortest_alone(
        "wellstrat.qmc.OwenSobol(2, seed=1).random(2**20)", "qmc.Sobol(2, seed=1).random(2**20)"))]

    contexts = wellstrat.camera_contexts(1024, 1024)
    generator = np.random.default_rng(1)
    for name in ("pmj", "long", "blue"):
        rows.append(compared(
            f"`draw`: {name}, 2^20 contexts, 2D, float32", "NumPy's `Generator.random`", 1.5,
            shortest(lambda name=name: wellstrat.draw(contexts, generator=name),
                     lambda: generator.random((1024, 1024, 2), dtype=np.float32))))

    def sobol_patterns():
        for seed in range(200):
            qmc.Sobol(2, seed=seed).random(64)

    patterns = np.arange(200)
    for name in ("pmj", "long"):
        rows.append(compared(
            f"`samples`: {name}, 200 patterns x 64 points, 2D", sobol, 1000, shortest(
                lambda name=name: wellstrat.samples(patterns, 64, generator=name),
                sobol_patterns, turns=5)))

    # All that SciPy knows, at once and one by one.
    points = wellstrat.samples(7, 2**14, dims=3, dtype=np.float64)
    kinds = {"star": "L2-star", "centered": "CD", "wrap-around": "WD", "mixture": "MD"}
    for some in (list(kinds), *([kind] for kind in kinds)):
        rows.append(compared(
            f"`l2_discrepancies`: {', '.join(some)}; 2^14 points, 3D", "SciPy's `discrepancy`", 8,
            shortest(lambda some=some: wellstrat.analysis.l2_discrepancies(points, some),
                     lambda some=some: [qmc.discrepancy(points, method=kinds[kind]) for kind in some],
                     turns=3)))

    rows.append(["`import wellstrat`, after NumPy", f"{1e3 * importing():.0f} ms", "", "", "",
                 "60 ms at most"])
    print_table(["", "time", "beside", "its time", "ratio", "wanted"], rows)


class Integrand:
    """A product of one function of each coordinate, and what scrambling leaves of its error."""

    def __init__(self, name, dims, function, antiderivative):
        self.name, self.dims, self.function = name, dims, function
        means = [np.diff(antiderivative(np.linspace(0, 1, 2**k + 1))) * 2**k for k in range(13)]
        self.mean = means[0][0]
        squares = [np.mean(m**2) for m in means]
        levels = np.diff(squares)  # the variance between cells of 2^-k and their halves
        tail = levels[-1] * 0.25 ** np.arange(1, LEVELS - len(levels) + 1)  # it is smooth
        self.levels = np.concatenate([[self.mean**2], levels, tail])  # the constant first

    def values(self, points):
        return self.function(points[:, :self.dims]).prod(axis=1)

    def exact_rmse(self, gains):
        """Of nested uniform scrambling of a net with these gains: Owen 1997, "Monte Carlo Variance
        of Scrambled Net Quadrature", SIAM J. Numer. Anal. 34(5)."""
        weights = self.levels
        for _ in range(self.dims - 1):
            weights = np.multiply.outer(weights, self.levels)
        terms = gains * weights
        terms[(0,) * self.dims] = 0
        return math.sqrt(terms.sum() / gains[(0,) * self.dims])


INTEGRANDS = (
    Integrand("smooth-1d", 1, lambda x: x * np.exp(x), lambda x: (x - 1) * np.exp(x)),
    Integrand("smooth", 2, lambda x: x * np.exp(x), lambda x: (x - 1) * np.exp(x)),
    Integrand("gaussian", 2, lambda x: np.exp(-(x**2)), lambda x: math.sqrt(math.pi) / 2 * erf(x)),
    Integrand("bilinear", 2, lambda x: x, lambda x: x**2 / 2),
)


def gains(points):
    """How many times the variance of a component, over that of independent points, is left by nested
    uniform scrambling of a digital net: by the level in each coordinate, the constant first."""
    leading = np.where(points > 0, -np.frexp(points)[1], LEVELS)  # zeros of the first digits
    counts = np.zeros((LEVELS + 1,) * points.shape[1], np.int64)
    np.add.at(counts, tuple(leading.T), 1)
    for axis in range(counts.ndim):
        above = np.flip(np.cumsum(np.flip(counts, axis), axis), axis)  # with k zeros or more
        at_least = np.moveaxis(above, axis, 0)
        exactly = np.moveaxis(counts, axis, 0)
        levels = np.concatenate([at_least[:1], at_least[1:] - exactly[:-1]])
        counts = np.moveaxis(levels, 0, axis)
    return counts.astype(float)


def errors_of(engine):
    """The errors by integrand, seed and number of samples."""
    ends = [0] + [2**m for m in LOG_SIZES]
    errors = np.empty((len(INTEGRANDS), SEEDS, len(LOG_SIZES)))
    for seed in range(SEEDS):
        points = {d: engine(d, seed=seed).random(2 ** LOG_SIZES[-1]) for d in (1, 2)}
        for i, integrand in enumerate(INTEGRANDS):
            values = integrand.values(points[integrand.dims])
            sums = np.cumsum([values[a:b].sum() for a, b in zip(ends, ends[1:])])
            errors[i, seed] = sums / ends[1:] - integrand.mean**integrand.dims
    return errors


def root_mean_square(values):
    return math.sqrt(np.mean(values**2))


def measure_errors():
    """Relative to the RMSE of exact nested uniform scrambling: over all integrands and seeds."""
    net = {d: qmc.Sobol(d, scramble=False).random(2 ** LOG_SIZES[-1]) for d in (1, 2)}
    exact = np.array([[integrand.exact_rmse(gains(net[integrand.dims][:2**m])) for m in LOG_SIZES]
                      for integrand in INTEGRANDS])
    ours, scipys = (np.abs(errors_of(engine)) / exact[:, np.newaxis]
                    for engine in (wellstrat.qmc.OwenSobol, qmc.Sobol))
    rows = []
    sizes = [(f"2^{m}", slice(k, k + 1)) for k, m in enumerate(LOG_SIZES)] + [("all", slice(None))]
    for name, some in sizes:
        rows.append([name] + [f"{measure(engine[..., some]):.3f}" for engine in (ours, scipys)
                              for measure in (root_mean_square, np.median)])
    print_table(["points", "`OwenSobol`: RMSE", "median", "SciPy's Sobol': RMSE", "median"], rows)


PARTS = {"speed": measure_speed, "errors": measure_errors}


def main():
    chosen = sys.argv[1:] or list(PARTS)
    for name in chosen:
        if name not in PARTS:
            sys.exit(f"bench.py: no part is called '{name}'; there are {', '.join(PARTS)}")
    for name in chosen:
        PARTS[name]()


if __name__ == "__main__":
    main()
