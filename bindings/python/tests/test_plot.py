# SPDX-License-Identifier: Apache-2.0
"""wellstrat.plot: the data are in the picture, and what is refused."""

import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("agg")
from matplotlib import pyplot  # noqa: E402

import wellstrat  # noqa: E402
from wellstrat import plot  # noqa: E402


@pytest.fixture(autouse=True)
def close_figures():
    yield
    pyplot.close("all")


def saved(ax, folder):
    ax.figure.savefig(folder / "picture.png")
    return pyplot.imread(folder / "picture.png")


def test_points(tmp_path):
    xy = wellstrat.samples(1, 64)
    ax = plot.points(xy, strata=(4, 16), color="red")
    *grid, drawn = ax.lines
    assert np.array_equal(drawn.get_xydata(), xy)
    assert drawn.get_color() == "red" and drawn.get_linestyle() == "None"
    assert [line.get_xdata()[0] for line in grid[:3]] == [0.25, 0.5, 0.75]
    assert [line.get_ydata()[0] for line in grid[3:]] == [k / 16 for k in range(1, 16)]
    picture = saved(ax, tmp_path)
    assert ((picture[..., 0] > 0.9) & (picture[..., 1] < 0.1)).sum() > 64  # red


def test_given_axes_are_drawn_in():
    figure, axes = pyplot.subplots(1, 5)
    assert plot.points([[0.5, 0.5]], ax=axes[0]) is axes[0]
    spectrum = wellstrat.analysis.spectrum(wellstrat.samples([1, 2], 16))
    assert plot.spectrum(spectrum, ax=axes[1]) is axes[1]
    assert plot.radial_spectrum(spectrum, ax=axes[2]) is axes[2]
    errors = wellstrat.analysis.study("pmj", counts=[1, 2], patterns=3)
    assert plot.errors(errors, ax=axes[3]) is axes[3]
    assert pyplot.get_fignums() == [figure.number]


def test_projections():
    xyz = wellstrat.samples(1, 64, dims=3)
    axes = plot.projections(xyz, strata=(8, 8))
    assert axes.shape == (2, 2) and not axes[0, 1].axison
    for up, right in ((1, 0), (2, 0), (2, 1)):
        drawn = axes[up - 1, right].lines[-1]
        assert np.array_equal(drawn.get_xydata(), xyz[:, [right, up]])
    assert (axes[1, 1].get_xlabel(), axes[1, 0].get_ylabel()) == ("coordinate 1", "coordinate 2")


def test_spectrum():
    sets = wellstrat.samples(range(3), 64)
    found = wellstrat.analysis.spectrum(sets)
    for given in (found, sets):
        image, = plot.spectrum(given).images
        shown = image.get_array()
        most = found["frequency"][-1]
        assert shown[most, most] == 0  # not the number of points
        assert np.array_equal(shown[0], found["power"][0])
        assert list(image.get_extent()) == [-most - 0.5, most + 0.5, -most - 0.5, most + 0.5]
    assert found["power"][most, most] == pytest.approx(64)  # as it was


def test_radial_spectrum():
    found = wellstrat.analysis.spectrum(wellstrat.samples(range(3), 64))
    ax = plot.radial_spectrum(found, label="a")
    plot.radial_spectrum(found, ax=ax, label="b")
    assert np.array_equal(ax.lines[1].get_ydata(), found["radial"][1:])
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["a", "b"]
    picture = wellstrat.analysis.picture_spectrum(np.random.default_rng(1).random((16, 16)))
    assert np.array_equal(plot.radial_spectrum(picture).lines[1].get_ydata(), picture["power"])


def test_errors():
    found = wellstrat.analysis.study(["random", "pmj"], ["disk", "step"], [4, 64], 20)
    ax = plot.errors(found, "step")
    assert ax.get_xscale() == ax.get_yscale() == "log"
    assert [line.get_label() for line in ax.lines] == ["random", "pmj"]
    assert np.array_equal(ax.lines[1].get_ydata(), found["pmj"]["step"]["rmse"])
    assert ax.get_title() == "step" and plot.errors(found).get_title() == "disk"


@pytest.mark.parametrize("call, error, message", [
    (lambda: plot.points(np.zeros((3, 3))), ValueError, r"shape \(count, 2\), not \(3, 3\)"),
    (lambda: plot.points("abc"), TypeError, "xy must be real numbers"),
    (lambda: plot.points(np.zeros((3, 2)), strata=4), ValueError, "strata must be .*, not 4"),
    (lambda: plot.points(np.zeros((3, 2)), strata=(0, 4)), ValueError, "strata must be from 1"),
    (lambda: plot.points(np.zeros((3, 2)), ax=3), TypeError, "an Axes of matplotlib, not int"),
    (lambda: plot.projections(np.zeros((3, 1))), ValueError, "from 2 to 8, not 1"),
    (lambda: plot.radial_spectrum({}), TypeError, "what analysis.spectrum returned, or points"),
    (lambda: plot.spectrum(wellstrat.analysis.picture_spectrum(np.eye(8))), TypeError, "pictures"),
    (lambda: plot.spectrum(np.zeros((3, 3))), ValueError, r"not \(3, 3\)"),
    (lambda: plot.errors({"pmj": 3}), TypeError, "what analysis.study returned"),
    (lambda: plot.errors({"pmj": {"disk": {"rmse": [1]}}}), TypeError, "what analysis.study returned"),
    (lambda: plot.errors({"pmj": wellstrat.analysis.study("pmj", "disk", 4, 2)["pmj"],
                          "long": wellstrat.analysis.study("long", "step", 4, 2)["long"]}), ValueError,
     "in common"),
    (lambda: plot.errors({}), TypeError, "what analysis.study returned"),
    (lambda: plot.errors(wellstrat.analysis.study("pmj", "disk", 4, 2), "step"), ValueError,
     "one of 'disk', not 'step'"),
])
def test_what_is_wrong_is_said(call, error, message):
    with pytest.raises(error, match=message):
        call()
