# SPDX-License-Identifier: Apache-2.0
"""Pictures of points, spectra and errors by matplotlib, each by one call that returns its Axes.

`ax` is where to draw; without it, in a new figure. Nothing is shown or saved:
``wellstrat.plot.points(xy).figure.savefig("points.png")``.
"""

from __future__ import annotations

import itertools
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from ._arguments import Int, floats, integer

try:
    from matplotlib import pyplot
    from matplotlib.axes import Axes
except ImportError as error:
    raise ImportError("wellstrat.plot needs matplotlib: install python3-matplotlib of Debian, or "
                      "matplotlib by pip") from error

__all__ = ["errors", "points", "projections", "radial_spectrum", "spectrum"]

_GRID = {"color": "0.8", "linewidth": 0.6, "zorder": 0}


def points(xy: npt.ArrayLike, strata: tuple[Int, Int] | None = None, *, ax: Axes | None = None,
           **options: Any) -> Axes:
    """Points in the unit square, over strata.

    Parameters
    ----------
    xy : array_like, shape (count, 2)
    strata : (columns, rows), optional
        Lines that cut the square in so many of each.
    ax : Axes, optional
    options
        Of `Axes.plot`, such as ``color="red"``.

    Examples
    --------
    >>> import wellstrat
    >>> ax = wellstrat.plot.points(wellstrat.samples(7, 64), strata=(8, 8))
    >>> ax.get_xlim()
    (0.0, 1.0)
    """
    array = _columns(xy, "xy")
    if array.shape[1] != 2:
        raise ValueError(f"xy must be of shape (count, 2), not {array.shape}")
    axes = _axes(ax)
    if strata is not None:
        try:
            columns, rows = strata
        except (TypeError, ValueError):
            raise ValueError(f"strata must be (columns, rows), not {strata!r}") from None
        for line in np.linspace(0, 1, integer(columns, "strata", 1, 4097) + 1)[1:-1]:
            axes.axvline(line, **_GRID)
        for line in np.linspace(0, 1, integer(rows, "strata", 1, 4097) + 1)[1:-1]:
            axes.axhline(line, **_GRID)
    size = min(5.0, 60 / max(len(array), 1) ** 0.5)
    axes.plot(*array.T, **{"linestyle": "none", "marker": "o", "markersize": size,
                           "markeredgewidth": 0, **options})
    axes.set(xlim=(0, 1), ylim=(0, 1), aspect="equal", xticks=[0, 1], yticks=[0, 1])
    return axes


def projections(values: npt.ArrayLike, strata: tuple[Int, Int] | None = None,
                **options: Any) -> Any:
    """All projections of points on two coordinates, in a new figure.

    Parameters
    ----------
    values : array_like, shape (count, dims)
        Two to eight dimensions.
    strata, options
        As of `points`.

    Returns
    -------
    ndarray of Axes, shape (dims - 1, dims - 1)
        ``[j - 1, i]`` has coordinate i to the right and j upwards; those above the diagonal are off.

    Examples
    --------
    >>> import wellstrat
    >>> wellstrat.plot.projections(wellstrat.samples(7, 64, dims=3)).shape
    (2, 2)
    """
    array = _columns(values, "values")
    dims = integer(array.shape[1], "the dimensions of values", 2, 9)
    figure, axes = pyplot.subplots(dims - 1, dims - 1, squeeze=False, layout="constrained",
                                   figsize=(2.2 * (dims - 1), 2.2 * (dims - 1)))
    for right, up in itertools.product(range(dims - 1), range(1, dims)):
        one = axes[up - 1, right]
        if right >= up:
            one.set_axis_off()
            continue
        points(array[:, [right, up]], strata, ax=one, **options)
        one.set_xlabel(f"coordinate {right}" if up == dims - 1 else "")
        one.set_ylabel(f"coordinate {up}" if right == 0 else "")
    return axes


def spectrum(found: Mapping[str, Any] | npt.ArrayLike, *, ax: Axes | None = None,
             **options: Any) -> Axes:
    """The power spectrum of points: black is no power, white twice that of random points or more.

    Parameters
    ----------
    found : dict or array_like
        What `analysis.spectrum` returned, or the points that it takes.
    ax : Axes, optional
    options
        Of `Axes.imshow`, such as ``vmax=4``.

    Examples
    --------
    >>> import wellstrat
    >>> ax = wellstrat.plot.spectrum(wellstrat.samples(range(20), 256))
    >>> ax.get_xlabel()
    'frequency in x'
    """
    known = _spectrum(found)
    if "radial" not in known:
        raise TypeError("found must be a spectrum of points; radial_spectrum shows those of pictures")
    most = known["frequency"][-1] + 0.5
    power = known["power"].copy()
    middle = len(power) // 2
    power[middle, middle] = 0  # the number of points
    axes = _axes(ax)
    axes.imshow(power, **{"cmap": "gray", "vmin": 0, "vmax": 2, "origin": "lower",
                          "extent": (-most, most, -most, most), **options})
    axes.set(xlabel="frequency in x", ylabel="frequency in y")
    return axes


def radial_spectrum(found: Mapping[str, Any] | npt.ArrayLike, *, ax: Axes | None = None,
                    **options: Any) -> Axes:
    """The power by the length of the frequency; several calls with one `ax` compare.

    Parameters
    ----------
    found : dict or array_like
        What `analysis.spectrum` or `analysis.picture_spectrum` returned, or points.
    ax : Axes, optional
    options
        Of `Axes.plot`, such as ``label="pmj"``.

    Examples
    --------
    >>> import wellstrat
    >>> ax = wellstrat.plot.radial_spectrum(wellstrat.samples(range(20), 256), label="pmj")
    >>> ax = wellstrat.plot.radial_spectrum(
    ...     wellstrat.samples(range(20), 256, generator="random"), ax=ax, label="random")
    >>> len(ax.lines)
    3
    """
    known = _spectrum(found)
    is_picture = "radial" not in known
    axes = _axes(ax)
    if not axes.lines:
        axes.axhline(1, **_GRID)
    if is_picture:
        axes.plot(known["frequency"], known["power"], **options)
    else:
        axes.plot(np.arange(1, len(known["radial"])), known["radial"][1:], **options)
    axes.set(xlabel="frequency, cycles a pixel" if is_picture else "frequency",
             ylabel="power; random is 1", xlim=(0, None), ylim=(0, None))
    if "label" in options:
        axes.legend()
    return axes


def errors(found: Mapping[str, Mapping[str, Any]], integrand: str | None = None, *,
           ax: Axes | None = None, **options: Any) -> Axes:
    """The errors that `analysis.study` found, by the number of points, with their 95 % bands.

    Parameters
    ----------
    found : dict
        By generator and integrand.
    integrand : str, optional
        Which one; the first if not given.
    ax : Axes, optional
    options
        Of `Axes.plot`.

    Examples
    --------
    >>> import wellstrat
    >>> found = wellstrat.analysis.study(["random", "pmj"], "disk", patterns=20)
    >>> ax = wellstrat.plot.errors(found)
    >>> ax.get_title(), len(ax.lines)
    ('disk', 2)
    """
    if not isinstance(found, Mapping) or not found or not all(
            isinstance(by_integrand, Mapping) and all(map(_is_study, by_integrand.values()))
            for by_integrand in found.values()):
        raise TypeError("found must be what analysis.study returned")
    names = [name for name in next(iter(found.values()))
             if all(name in by_integrand for by_integrand in found.values())]
    if not names:
        raise ValueError("the generators in found have no integrand in common")
    name = names[0] if integrand is None else integrand
    if name not in names:
        raise ValueError(f"integrand must be one of {', '.join(map(repr, names))}, not {name!r}")
    axes = _axes(ax)
    for generator, by_integrand in found.items():
        known = by_integrand[name]
        line, = axes.loglog(known["count"], known["rmse"],
                            **{"label": generator, "marker": ".", "base": 2, **options})
        axes.fill_between(known["count"], known["low"], known["high"], color=line.get_color(),
                          alpha=0.2, linewidth=0)
    axes.set_yscale("log", base=10)
    axes.set(title=name, xlabel="points", ylabel="root mean squared error")
    axes.grid(color="0.9")
    axes.legend()
    return axes


def _is_study(known: Any) -> bool:
    """Whether these are errors by number of points."""
    return isinstance(known, Mapping) and {"count", "rmse", "low", "high"} <= set(known)


def _axes(ax: Axes | None) -> Axes:
    """`ax`, or that of a new figure."""
    if ax is None:
        return pyplot.subplots(layout="constrained")[1]
    if not isinstance(ax, Axes):
        raise TypeError(f"ax must be an Axes of matplotlib, not {type(ax).__name__}")
    return ax


def _columns(values: npt.ArrayLike, name: str) -> npt.NDArray[Any]:
    array = floats(values, name)
    if array.ndim != 2:
        raise ValueError(f"{name} must be of shape (count, dims), not {array.shape}")
    return array


def _spectrum(found: Any) -> Mapping[str, Any]:
    """A spectrum, or that of points."""
    if isinstance(found, Mapping):
        if not {"frequency", "power"} <= set(found):
            raise TypeError("found must be what analysis.spectrum returned, or points")
        return found
    from .analysis import spectrum as measured
    return measured(found)
