# SPDX-License-Identifier: Apache-2.0
"""The error of integrals by OwenSobol is that of exact nested uniform scrambling, which bench.py
computes without drawing a sample."""

import importlib.util
import pathlib

import numpy as np
import pytest
from scipy.stats import qmc

import wellstrat

SPECIFICATION = importlib.util.spec_from_file_location(
    "bench", pathlib.Path(__file__).resolve().parents[1] / "bench.py")
bench = importlib.util.module_from_spec(SPECIFICATION)
SPECIFICATION.loader.exec_module(bench)


@pytest.mark.parametrize("integrand", bench.INTEGRANDS, ids=lambda integrand: integrand.name)
def test_errors_are_those_of_nested_scrambling(integrand):
    seeds = 2000  # the standard error of an RMSE is 1.6 %: errors are almost normal
    for log_samples in (4, 6, 7, 10):
        net = qmc.Sobol(integrand.dims, scramble=False).random(2**log_samples)
        points = (wellstrat.qmc.OwenSobol(integrand.dims, seed=seed).random(2**log_samples)
                  for seed in range(seeds))
        errors = [integrand.values(xy).mean() - integrand.mean**integrand.dims for xy in points]
        ratio = bench.root_mean_square(np.array(errors)) / integrand.exact_rmse(bench.gains(net))
        assert abs(ratio - 1) < 0.07


def test_gains_of_nets():
    gains = bench.gains(qmc.Sobol(2, scramble=False).random(256))
    for x in range(20):  # levels from 1 on; 256 samples know of 8 digits in all
        for y in range(20):
            if 0 < x + y <= 8:
                assert gains[x, y] == 0
            if max(x, y) > 8 and min(x, y) == 0:
                assert gains[x, y] == 1
