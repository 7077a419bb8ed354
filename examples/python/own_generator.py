# SPDX-License-Identifier: Apache-2.0
"""Your own generator against ours: the error of an integral, by the number of samples.

Replace `golden_points` by any function of a seed and a number of points. Each generator draws for
many seeds; what is printed is the root mean squared error over them.
"""

import argparse

import numpy as np

import wellstrat


def golden_points(seed, n):
    """The additive sequence of the plastic number, moved at random. Roberts 2018, "The Unreasonable
    Effectiveness of Quasirandom Sequences"."""
    plastic = 1.32471795724474602596
    steps = np.arange(1, n + 1)[:, np.newaxis] * np.array([1 / plastic, 1 / plastic**2])
    return (steps + np.random.default_rng(seed).random(2)) % 1


GENERATORS = {
    "random": lambda seed, n: wellstrat.samples(seed, n, generator="random", dtype=float),
    "own": golden_points,
    "pmj": lambda seed, n: wellstrat.samples(seed, n, dtype=float),
    "OwenSobol": lambda seed, n: wellstrat.qmc.OwenSobol(2, seed=seed).random(n),
}


def integrand(xy):
    """A soft spot of light over an edge; its integral is found with very many samples."""
    return np.exp(-4 * ((xy - 0.4) ** 2).sum(axis=1)) * (xy[:, 0] + 0.3 * xy[:, 1] < 0.7)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("--log-samples", type=int, default=12, help="up to 2^this, default 12")
    options = parser.parse_args()

    truth = integrand(wellstrat.qmc.OwenSobol(2, seed=0).random(2**22)).mean()
    print("samples", *(f"{name:>10}" for name in GENERATORS))
    for log_samples in range(2, options.log_samples + 1, 2):
        errors = [[integrand(points(seed, 2**log_samples)).mean() - truth
                   for seed in range(options.seeds)] for points in GENERATORS.values()]
        rmse = np.sqrt(np.mean(np.square(errors), axis=1))
        print(f"{2**log_samples:7}", *(f"{error:10.2e}" for error in rmse))


if __name__ == "__main__":
    main()
