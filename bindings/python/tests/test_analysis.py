# SPDX-License-Identifier: Apache-2.0
"""wellstrat.analysis: against values that follow from definitions, and what is refused."""

import itertools
import math
from fractions import Fraction

import numpy as np
import pytest

import wellstrat
from wellstrat import analysis

KINDS = ("star", "centered", "wrap-around", "mixture", "modified")


def exact_l2(points, kind):
    """The square of the discrepancy, by its definition over all pairs in long double."""
    one = np.longdouble(1)
    x = points.astype(np.longdouble)
    z = abs(x - one / 2)
    n, dims = x.shape
    x1, x2, z1, z2 = x[:, None], x[None], z[:, None], z[None]
    mean, single, pair = {
        "star": (one / 3, (1 - x**2) / 2, 1 - np.maximum(x1, x2)),
        "centered": (one * 13 / 12, 1 + z / 2 - z**2 / 2, 1 + z1 / 2 + z2 / 2 - abs(x1 - x2) / 2),
        "wrap-around": (one * 4 / 3, 0 * x + one * 4 / 3, one * 3 / 2 - abs(x1 - x2) * (1 - abs(x1 - x2))),
        "mixture": (one * 19 / 12, one * 5 / 3 - z / 4 - z**2 / 4,
                    one * 15 / 8 - z1 / 4 - z2 / 4 - 3 * abs(x1 - x2) / 4 + (x1 - x2)**2 / 2),
        "modified": (one * 4 / 3, (3 - x**2) / 2, 2 - np.maximum(x1, x2)),
    }[kind]
    return mean**dims - 2 * single.prod(-1).mean() + pair.prod(-1).mean()


@pytest.mark.parametrize("dims", (1, 2, 3, 5))
def test_l2_discrepancies(dims):
    points = np.random.default_rng(dims).random((500, dims))
    found = analysis.l2_discrepancies(points)
    assert tuple(found) == KINDS
    for kind in KINDS:
        assert abs(found[kind] - math.sqrt(exact_l2(points, kind))) < 1e-12
    assert analysis.l2_discrepancies(points, ["mixture"]) == {"mixture": pytest.approx(found["mixture"], 1e-12)}


def test_l2_discrepancies_beside_scipy():
    qmc = pytest.importorskip("scipy.stats.qmc")
    points = np.random.default_rng(1).random((100, 3))
    found = analysis.l2_discrepancies(points)
    assert found["star"] == pytest.approx(qmc.discrepancy(points, method="L2-star"), 1e-9)
    for kind, method in (("centered", "CD"), ("wrap-around", "WD"), ("mixture", "MD")):
        assert found[kind]**2 == pytest.approx(qmc.discrepancy(points, method=method), 1e-9)


def test_l2_discrepancies_of_many_points():
    """Of which SciPy has four digits left: an exact sum of integers has the value."""
    n, dims = 2**13, 3
    points = wellstrat.samples(7, n, dims=dims, dtype=np.float64)
    a = np.floor(points * n).astype(np.int64)
    z = abs(a - n // 2)
    single = sum(int(p) * int(q) * int(r) for p, q, r in 2 * n * n + n * z - z * z)
    double = sum(int((2 * n + z[i] + z - abs(a[i] - a)).prod(axis=1).sum()) for i in range(n))
    square = (Fraction(13, 12)**dims - Fraction(2 * single, n * (2 * n * n)**dims)
              + Fraction(double, n * n * (2 * n)**dims))
    assert abs(analysis.l2_discrepancies(a / n)["centered"] - math.sqrt(square)) < 1e-12


def test_t_values():
    corners = np.array([[i / 8, 0.0] for i in range(8)])
    assert analysis.t_value(corners) == 3
    assert analysis.t_value(np.stack([np.arange(8) / 8, np.roll(np.arange(8), 1) / 8], axis=1)) == 2
    xyz = wellstrat.samples(3, 256, dims=3)
    found = analysis.projected_t_values(xyz, 3)
    assert list(found) == [c for k in (1, 2, 3) for c in itertools.combinations(range(3), k)]
    assert found[0, 1] == 0 and found[0, 1, 2] == analysis.t_value(xyz) == 1
    backwards = wellstrat.samples(3, 256)[::-1]  # any strides
    assert analysis.t_value(backwards) == 0
    turned = np.roll(wellstrat.samples(3, 256), 5, axis=0)
    assert analysis.t_value(turned) == 0 < analysis.t_value(turned, sequence=True)


def test_star_discrepancy():
    assert analysis.star_discrepancy([[0.5, 0.5]]) == {"lower": 0.75, "upper": 0.75}
    few = analysis.star_discrepancy(wellstrat.samples(1, 512, dims=3), max_sweeps=3)
    more = analysis.star_discrepancy(wellstrat.samples(1, 512, dims=3))
    assert few["lower"] <= more["lower"] <= more["upper"] < few["upper"]


def test_distances():
    square = [[0.0, 0.0], [0.0, 0.9]]
    assert analysis.nearest_distances(square)["minimum"] == pytest.approx(0.1)
    assert analysis.nearest_distances(square, "cube")["minimum"] == pytest.approx(0.9)
    grid = np.array([[i / 4, 0.5] for i in range(4)])
    assert analysis.nearest_distances(grid)["mean"] == 0.25
    assert analysis.nearest_distances([[0.0], [0.5]])["relative"] == 1
    assert "relative" not in analysis.nearest_distances(np.zeros((2, 4)))
    assert analysis.nearest_distances([[0.5, 0.5]])["minimum"] == math.inf
    pairs = analysis.pair_correlation([[0.0], [0.26]], range=0.5, bins=5)
    assert pairs["distance"] == pytest.approx([0.05, 0.15, 0.25, 0.35, 0.45])
    assert pairs["density"] == pytest.approx([0, 0, 5, 0, 0])


def test_spectrum():
    xy = wellstrat.samples([1, 2], 32, dtype=np.float64)
    found = analysis.spectrum(xy, 6)
    assert list(found["frequency"]) == list(range(-6, 7))
    for fy, fx in itertools.product(range(-6, 7), repeat=2):
        sums = np.exp(-2j * np.pi * (fx * xy[..., 0] + fy * xy[..., 1])).sum(axis=1)
        assert found["power"][fy + 6, fx + 6] == pytest.approx(np.mean(abs(sums)**2) / 32, abs=1e-8)
    (fx, fy), power = found["peak"]["frequency"], found["peak"]["power"]
    assert found["power"][fy + 6, fx + 6] == power
    assert len(found["radial"]) == len(found["anisotropy_db"])


def test_picture_spectrum():
    columns = np.tile(np.cos(2 * np.pi * 4 * np.arange(32) / 32), (16, 1))  # 1/8 of a cycle a pixel
    found = analysis.picture_spectrum(columns)
    assert np.argmax(found["power"]) == np.argmin(abs(found["frequency"] - 1 / 8 - 1 / 64))
    white = np.random.default_rng(1).normal(size=(8, 32, 32))
    assert analysis.picture_spectrum(white)["power"] == pytest.approx(np.ones(16), abs=0.35)


def test_independence():
    streams = wellstrat.samples(range(4), 1024)
    found = analysis.independence(streams, worst=3)
    assert found["pairs"] == 4 * 3 // 2 * 2 * 2
    assert len(found["worst"]) == 3
    assert found["probability"] > 0.01
    same = analysis.independence([streams[0], streams[1], streams[0]], worst=1)
    assert same["worst"][0]["streams"] == (0, 2)
    assert same["worst"][0]["correlation"] == pytest.approx(1)
    assert same["probability"] < 1e-9


def test_study_is_the_error_of_integrals():
    def own(pattern, count):
        return np.random.default_rng(pattern).random((count, 2))

    found = analysis.study(own, "bilinear", [3, 10], 50)["own"]["bilinear"]
    for k, count in enumerate((3, 10)):
        errors = [own(p, count).prod(axis=1).mean() - 0.25 for p in range(50)]
        assert found["rmse"][k] == pytest.approx(np.sqrt(np.mean(np.square(errors))))
        assert found["bias"][k] == pytest.approx(np.mean(errors))
        assert found["low"][k] < found["rmse"][k] < found["high"][k]
    assert list(found["count"]) == [3, 10]


def test_study_of_generators():
    found = analysis.study(["random", "pmj", "long"], ["disk", "step", "linear"], [4, 64, 1024], 60)
    for integrand in ("disk", "step", "linear"):
        for generator in ("pmj", "long"):
            ratio = found[generator][integrand]["rmse"] / found["random"][integrand]["rmse"]
            assert ratio[-1] < 0.35
    assert found["random"]["disk"]["slope"] == pytest.approx(-0.5, abs=0.15)
    assert found["pmj"]["linear"]["slope"] < -1


def test_study_of_point_sets():
    def grid(pattern, count):
        return (np.arange(count)[:, np.newaxis] + 0.5) / count

    exact = analysis.study(grid, "linear", [2, 8], 3, progressive=False)["grid"]["linear"]
    assert exact["rmse"] == pytest.approx([0, 0], abs=1e-15)
    halves = analysis.study(grid, "linear", [4, 8], 3)["grid"]["linear"]  # the left half of 8
    assert halves["rmse"] == pytest.approx([0.25, 0], abs=1e-15)


def test_progress():
    said = []
    analysis.spectrum(wellstrat.samples(range(4), 16), progress=lambda *step: said.append(step))
    assert said == [(1, 4), (2, 4), (3, 4), (4, 4)]
    said.clear()
    counts = [2**17]
    analysis.study("random", "disk", counts, 20, progress=lambda *step: said.append(step))
    assert said[0] == (8, 20) and said[-1] == (20, 20)


def test_progress_by_tqdm(capsys):
    pytest.importorskip("tqdm")
    analysis.spectrum(wellstrat.samples(range(4), 16), progress=True)
    assert "4/4" in capsys.readouterr().err


XY = np.full((4, 2), 0.5)
WRONG = [
    (lambda: analysis.t_value([0.5, 0.5]), ValueError, r"shape \(count, dims\), not \(2,\)"),
    (lambda: analysis.t_value(XY[:3]), ValueError, "the number of points is 3"),
    (lambda: analysis.t_value(XY * 2), ValueError, r"accepted are values in \[0, 1\)"),
    (lambda: analysis.t_value(XY * np.nan), ValueError, "point 0 is -?nan"),
    (lambda: analysis.t_value(np.zeros((2, 7))), ValueError, "dimensions is 7; accepted are 1 to 6"),
    (lambda: analysis.t_value(XY.astype(str)), TypeError, "points must be real numbers"),
    (lambda: analysis.projected_t_values(XY, 0), ValueError, "max_dims must be from 1 to 6"),
    (lambda: analysis.l2_discrepancies(XY, None), TypeError, "kinds must be a list of names, not None"),
    (lambda: analysis.independence(7), TypeError, "streams must be a list of arrays, not 7"),
    (lambda: analysis.l2_discrepancies(XY[:0]), ValueError, "there are no points"),
    (lambda: analysis.l2_discrepancies(np.zeros((2, 0))), ValueError, "from 1 to 64, not 0"),
    (lambda: analysis.l2_discrepancies(np.zeros((2, 65))), ValueError, "from 1 to 64, not 65"),
    (lambda: analysis.l2_discrepancies(XY, ["CD"]), ValueError, "'wrap-around', .*, not 'CD'"),
    (lambda: analysis.l2_discrepancies(XY, "star"), TypeError, "a list of names, not 'star'"),
    (lambda: analysis.star_discrepancy(np.zeros((2, 4))), ValueError, "dimensions"),
    (lambda: analysis.star_discrepancy(XY, 0), ValueError, "max_sweeps must be from 1"),
    (lambda: analysis.nearest_distances(XY, "ball"), ValueError, "'cube', 'torus', not 'ball'"),
    (lambda: analysis.pair_correlation(XY, range=0.7), ValueError, "range must be in .*, not 0.7"),
    (lambda: analysis.pair_correlation(XY, range=np.nan), ValueError, "not nan"),
    (lambda: analysis.pair_correlation(XY[:1]), ValueError, "point"),
    (lambda: analysis.pair_correlation(XY, bins=2**40), ValueError, "bins must be from 1"),
    (lambda: analysis.spectrum(np.zeros((4, 3))), ValueError, r"not \(4, 3\)"),
    (lambda: analysis.spectrum(XY, 5000), ValueError, "max_frequency must be from 1 to 1023"),
    (lambda: analysis.spectrum(XY, progress="yes"), TypeError, "progress must be None, True or"),
    (lambda: analysis.picture_spectrum([1.0]), ValueError, r"shape \(height, width\)"),
    (lambda: analysis.picture_spectrum([[np.inf]]), ValueError, "finite, not inf"),
    (lambda: analysis.independence([]), ValueError, "streams"),
    (lambda: analysis.independence([XY]), ValueError, "streams"),
    (lambda: analysis.independence([XY, XY[:3]]), ValueError, "points"),
    (lambda: analysis.independence([XY, XY], grid_side=1), ValueError, "grid_side must be from 2"),
    (lambda: analysis.study("pmi"), ValueError, "functions or of pmj, .*, not 'pmi'"),
    (lambda: analysis.study(3), TypeError, "generators must be"),
    (lambda: analysis.study([]), ValueError, "there are no generators"),
    (lambda: analysis.study("pmj", "disc"), ValueError, "disc"),
    (lambda: analysis.study("pmj", []), ValueError, "there are no integrands"),
    (lambda: analysis.study("pmj", 5), TypeError, "integrands must be names"),
    (lambda: analysis.study("pmj", "disk", 4.0), TypeError, "counts must be an integer"),
    (lambda: analysis.study("pmj", "disk", [4, 2]), ValueError, "increas"),
    (lambda: analysis.study("pmj", "disk", []), ValueError, "there are no counts"),
    (lambda: analysis.study("pmj", "disk", [2**40]), ValueError, "counts must be from 1"),
    (lambda: analysis.study("pmj", "disk", patterns=0), ValueError, "patterns must be from 1"),
    (lambda: analysis.study(lambda p, n: XY, "disk", [8]), ValueError, r"\(8, 2\), not \(4, 2\)"),
    (lambda: analysis.study(lambda p, n: XY + 1, "disk", [4]), ValueError, r"in \[0, 1\), not 1.5"),
]


@pytest.mark.parametrize("call, error, message", WRONG)
def test_what_is_wrong_is_said(call, error, message):
    with pytest.raises(error, match=message) as raised:
        call()
    assert "\n" not in str(raised.value)


def test_errors_of_a_generator_come_through():
    def broken(pattern, count):
        raise ZeroDivisionError(pattern)

    with pytest.raises(ZeroDivisionError):
        analysis.study(broken)
