# SPDX-License-Identifier: Apache-2.0
"""Looks at the samples of a generator: points over strata, spectrum, and the error of an integral.

Writes one picture. Each panel is one call of `wellstrat.plot`, which draws into any Axes of matplotlib.
"""

import argparse

import matplotlib

matplotlib.use("agg")  # needs no screen
from matplotlib import pyplot  # noqa: E402

import wellstrat  # noqa: E402


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--generator", default="pmj", choices=("pmj", "long", "blue", "random"))
    parser.add_argument("--output", metavar="FILE.png", default="python-plot.png",
                        help="default python-plot.png")
    options = parser.parse_args()

    patterns = wellstrat.samples(range(100), 256, generator=options.generator)
    errors = wellstrat.analysis.study(["random", "halton", options.generator], "gaussian",
                                      counts=[4**k for k in range(1, 7)])

    figure, (left, middle, right) = pyplot.subplots(1, 3, figsize=(11, 3.6), layout="constrained")
    wellstrat.plot.points(patterns[7], strata=(16, 16), ax=left)
    wellstrat.plot.spectrum(patterns, ax=middle)
    wellstrat.plot.errors(errors, ax=right)
    figure.savefig(options.output, dpi=90)


if __name__ == "__main__":
    main()
