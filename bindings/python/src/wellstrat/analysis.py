# SPDX-License-Identifier: Apache-2.0
"""How good points are: nets, discrepancies, distances, spectra, independence, errors of integrals.

Points are arrays of shape (count, dims) with values in [0, 1), computed in float64; results are plain
numbers, dicts and arrays. `study` measures generators, your own ones as well.

All functions let other threads run while they compute, and Ctrl-C ends them at once. What they were
computing then goes on in a thread of its own until it is done, and is lost.
"""

from __future__ import annotations

import itertools
from typing import Any, Iterable, Sequence

import numpy as np
import numpy.typing as npt

try:
    from . import _analysis
except ImportError as error:
    raise ImportError("wellstrat.analysis needs FFTW 3: install libfftw3-double3 of "
                      f"Debian ({error})") from error
from ._arguments import Int, floats, integer
from ._progress import Progress, steps
from ._study import integrands, study

__all__ = [
    "independence", "integrands", "l2_discrepancies", "nearest_distances", "pair_correlation",
    "picture_spectrum", "projected_t_values", "spectrum", "star_discrepancy", "study", "t_value",
]

_KINDS = {
    "star": _analysis.L2Kind.star,
    "centered": _analysis.L2Kind.centered,
    "wrap-around": _analysis.L2Kind.wrap_around,
    "mixture": _analysis.L2Kind.mixture,
    "modified": _analysis.L2Kind.modified,
}
_TOPOLOGIES = {"cube": _analysis.Topology.cube, "torus": _analysis.Topology.torus}


def _points(values: Any, name: str = "points") -> tuple[npt.NDArray[np.float64], int]:
    """`values` as points in float64 in C order, and their dimensions."""
    array = np.ascontiguousarray(floats(values, name), np.float64)
    if np.ndim(values) != 2:
        raise ValueError(f"{name} must be of shape (count, dims), not {np.shape(values)}")
    integer(array.shape[1], f"the dimensions of {name}", 1, _analysis.max_dims + 1)
    return array, array.shape[1]


def _one_of(table: dict[str, Any], value: Any, name: str) -> Any:
    if not isinstance(value, str) or value not in table:
        raise ValueError(f"{name} must be one of {', '.join(map(repr, table))}, not {value!r}")
    return table[value]


def t_value(points: npt.ArrayLike, *, sequence: bool = False) -> int:
    """The quality t of a (t,m,s)-net in base 2: the smaller, the better stratified.

    Each box of ``2**(t - m)`` of the cube's volume, as binary digits cut it, has ``2**t`` of the
    ``2**m`` points. 0 is best, and m what any points have.

    Parameters
    ----------
    points : array_like, shape (count, dims)
        A power of two of them, in 1 to 6 dimensions, rounded down to multiples of ``2**-32``.
    sequence : bool
        Whether all aligned blocks of ``2**k`` points shall be (t,k,s)-nets, for all k, as in the
        start of a (t,s)-sequence.

    Examples
    --------
    >>> import wellstrat
    >>> wellstrat.analysis.t_value(wellstrat.samples(7, 1024), sequence=True)
    0
    """
    return _analysis.t_value(*_points(points), bool(sequence))


def projected_t_values(points: npt.ArrayLike, max_dims: Int = 2) -> dict[tuple[int, ...], int]:
    """`t_value` of all projections on up to `max_dims` coordinates, by the coordinates.

    Examples
    --------
    >>> import wellstrat
    >>> wellstrat.analysis.projected_t_values(wellstrat.samples(7, 256, dims=3), 3)
    {(0,): 0, (1,): 0, (2,): 0, (0, 1): 0, (0, 2): 1, (1, 2): 1, (0, 1, 2): 1}
    """
    array, dims = _points(points)
    most = integer(max_dims, "max_dims", 1, _analysis.max_net_dims + 1)
    return {chosen: _analysis.t_value(np.ascontiguousarray(array[:, chosen]), size, False)
            for size in range(1, min(most, dims) + 1)
            for chosen in itertools.combinations(range(dims), size)}


def l2_discrepancies(points: npt.ArrayLike,
                     kinds: Sequence[str] = tuple(_KINDS)) -> dict[str, float]:
    """L2 discrepancies, by their kinds: how unevenly points fill boxes, in the root mean square.

    Parameters
    ----------
    points : array_like, shape (count, dims)
        In 1 to 64 dimensions; up to three take n log(n)^(dims - 1) steps, more n^2.
    kinds : sequence of {"star", "centered", "wrap-around", "mixture", "modified"}
        Which boxes. Several together take less time.

    Returns
    -------
    dict of str to float
        Of all kinds the root. SciPy's `discrepancy` is the square of it for "CD", "WD" and "MD".

    Examples
    --------
    >>> import wellstrat
    >>> found = wellstrat.analysis.l2_discrepancies(wellstrat.samples(7, 256), ["star", "centered"])
    >>> {kind: f"{value:.4f}" for kind, value in found.items()}
    {'star': '0.0026', 'centered': '0.0033'}
    """
    if isinstance(kinds, str) or not isinstance(kinds, Iterable):
        raise TypeError(f"kinds must be a list of names, not {kinds!r}")
    names = list(kinds)
    chosen = [_one_of(_KINDS, kind, "kinds") for kind in names]
    return dict(zip(names, _analysis.l2_discrepancies(*_points(points), chosen)))


def star_discrepancy(points: npt.ArrayLike, max_sweeps: Int = 1024) -> dict[str, float]:
    """Bounds of the star discrepancy: the largest error of any box ``[0, z)``.

    Parameters
    ----------
    points : array_like, shape (count, dims)
        In 1 to 3 dimensions. In 1 and 2 both bounds are the exact value.
    max_sweeps : int
        In 3 dimensions more give narrower bounds, until they meet.

    Returns
    -------
    dict
        ``lower`` and ``upper``.

    Examples
    --------
    >>> import wellstrat
    >>> wellstrat.analysis.star_discrepancy([[0.25], [0.75]])
    {'lower': 0.25, 'upper': 0.25}
    """
    sweeps = integer(max_sweeps, "max_sweeps", 1, 2**31)
    lower, upper = _analysis.star_discrepancy(*_points(points), sweeps)
    return {"lower": lower, "upper": upper}


def nearest_distances(points: npt.ArrayLike, topology: str = "torus") -> dict[str, float]:
    """Distances of points to their nearest neighbors, in units of the cube's side.

    Parameters
    ----------
    points : array_like, shape (count, dims)
    topology : {"torus", "cube"}
        Whether the opposite side, or nothing, lies beyond the border of the cube.

    Returns
    -------
    dict
        ``minimum`` and ``mean``; up to three dimensions ``relative``, the minimum over the largest
        one that so many points on the torus can have.

    Examples
    --------
    >>> import wellstrat
    >>> distances = wellstrat.analysis.nearest_distances([[0.25, 0.5], [0.75, 0.5]])
    >>> distances["minimum"], distances["mean"]
    (0.5, 0.5)
    """
    array, dims = _points(points)
    minimum, mean = _analysis.nearest_distances(array, dims, _one_of(_TOPOLOGIES, topology, "topology"))
    distances = {"minimum": minimum, "mean": mean}
    if dims <= 3:
        distances["relative"] = minimum / _analysis.largest_minimum_distance(len(array), dims)
    return distances


def pair_correlation(points: npt.ArrayLike, range: float | None = None,  # noqa: A002
                     bins: Int = 64) -> dict[str, npt.NDArray[np.float64]]:
    """How many pairs of points lie a distance apart on the torus, relative to random points.

    Parameters
    ----------
    points : array_like, shape (count, dims)
        Two or more, in 1 to 3 dimensions.
    range : float, optional
        The largest distance, in (0, 1/2]; six mean spacings if not given.
    bins : int

    Returns
    -------
    dict
        ``distance``, the middle of each bin, and ``density``, which is 1 for random points.

    Examples
    --------
    >>> import wellstrat
    >>> found = wellstrat.analysis.pair_correlation(wellstrat.samples(7, 1024), bins=16)
    >>> found["density"].shape
    (16,)
    """
    array, dims = _points(points)
    number = integer(bins, "bins", 1, 2**20 + 1)
    farthest = _analysis.usual_pair_range(len(array), dims) if range is None else float(range)
    if not 0 < farthest <= 0.5:
        raise ValueError(f"range must be in (0, 1/2], not {farthest}")
    density = np.array(_analysis.pair_correlation(array, dims, farthest, number))
    return {"distance": (np.arange(number) + 0.5) * farthest / number, "density": density}


def spectrum(points: Any, max_frequency: Int | None = None, *,
             progress: Progress = None) -> dict[str, Any]:
    """The power spectrum of points in the plane, or its mean over several sets.

    Parameters
    ----------
    points : array_like, shape (count, 2) or (sets, count, 2)
        Such as ``samples(range(100), 256)``: the more patterns, the clearer.
    max_frequency : int, optional
        Of each component, up to 1023; about twice the root of the count if not given.
    progress : callable or True, optional
        Called with (sets done, sets in all); True is a bar of tqdm's.

    Returns
    -------
    dict
        ``power`` by ``[fy, fx]``, whose components are ``frequency``; random points have 1 in
        expectation. ``radial`` and ``anisotropy_db`` by the length of the frequency, rounded.
        ``peak``: the ``frequency`` (fx, fy) with the most ``power``.

    Examples
    --------
    >>> import wellstrat
    >>> found = wellstrat.analysis.spectrum(wellstrat.samples(range(20), 256))
    >>> found["power"].shape, bool(found["radial"][1:4].max() < 0.1)
    ((65, 65), True)
    """
    array = np.asarray(floats(points, "points"), np.float64, order="C")
    if array.ndim not in (2, 3) or array.shape[-1] != 2 or array.size == 0:
        raise ValueError(f"points must be of shape (count, 2) or (sets, count, 2), with points, not "
                         f"{array.shape}")
    sets = array.reshape(-1, *array.shape[-2:])
    usual = _analysis.usual_max_frequency(sets.shape[1])
    most = usual if max_frequency is None else integer(max_frequency, "max_frequency", 1,
                                                       _analysis.max_frequency + 1)
    periodogram = _analysis.Periodogram(most)
    for begin, _ in steps(len(sets), 1, progress):
        periodogram.add(sets[begin], 2)
    power = np.empty((2 * most + 1, 2 * most + 1))
    periodogram.copy_power(power)
    radial, anisotropy = periodogram.radial()
    fx, fy, highest = periodogram.peak()
    return {"power": power, "frequency": np.arange(-most, most + 1), "radial": np.array(radial),
            "anisotropy_db": np.array(anisotropy), "peak": {"frequency": (fx, fy), "power": highest}}


def picture_spectrum(pictures: npt.ArrayLike) -> dict[str, npt.NDArray[np.float64]]:
    """The radial power spectrum of a picture, such as its errors: white noise has 1 everywhere.

    Parameters
    ----------
    pictures : array_like, shape (height, width) or (pictures, height, width)
        Finite values; of several, the spectrum of all together.

    Returns
    -------
    dict
        ``frequency`` in cycles a pixel, to 0.5, and ``power``.

    Examples
    --------
    Errors of blue noise have little power at low frequencies:

    >>> import wellstrat
    >>> xi = wellstrat.draw(wellstrat.blue_contexts(64, 64), generator="blue")
    >>> power = wellstrat.analysis.picture_spectrum(xi[..., 0] - 0.5)["power"]
    >>> bool(power[0] < 0.1), bool(power[-1] > 1)
    (True, True)
    """
    array = np.asarray(floats(pictures, "pictures"), np.float64, order="C")
    if array.ndim not in (2, 3) or array.size == 0:
        raise ValueError(f"pictures must be of shape (height, width) or (pictures, height, width), "
                         f"with pixels, not {array.shape}")
    good = np.isfinite(array)
    if not good.all():
        raise ValueError(f"pictures must be finite, not {array[~good][0]}")
    height, width = array.shape[-2:]
    frequency, power = _analysis.picture_spectrum(array, width, height)
    return {"frequency": np.array(frequency), "power": np.array(power)}


def independence(streams: Sequence[npt.ArrayLike], *, grid_side: Int | None = None,
                 worst: Int = 5) -> dict[str, Any]:
    """Whether streams of samples know of each other: each coordinate against those of the others.

    Parameters
    ----------
    streams : sequence of array_like, shape (count, dims)
        Two or more, of the same count: sample i of one is used together with sample i of another.
    grid_side : int, optional
        Of the grid of cells for chi-square, 2 to 1024.
    worst : int
        How many pairs of coordinates to name, the most unlikely first.

    Returns
    -------
    dict
        ``probability`` of the worst pair, if all are independent: small means dependence; ``pairs``
        that were tested; ``correlation_spread`` and ``mean_chi_square``, about 1; ``worst``, a list of
        dicts.

    Examples
    --------
    >>> import wellstrat
    >>> streams = wellstrat.samples([1, 2, 3], 1024)
    >>> wellstrat.analysis.independence(streams)["probability"] > 0.01
    True
    >>> wellstrat.analysis.independence([streams[0], streams[0]])["probability"] < 1e-9
    True
    """
    if not isinstance(streams, Iterable):
        raise TypeError(f"streams must be a list of arrays, not {streams!r}")
    arrays = [_points(stream, f"streams[{i}]") for i, stream in enumerate(streams)]
    count = len(arrays[0][0]) if arrays else 0
    side = _analysis.usual_grid_side(count) if grid_side is None else integer(
        grid_side, "grid_side", 2, 1025)
    return _analysis.independence([array for array, _ in arrays], [dims for _, dims in arrays], side,
                                  integer(worst, "worst", 0, 2**31))
