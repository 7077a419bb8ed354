# SPDX-License-Identifier: Apache-2.0
"""Errors of integrals by number of points, of generators by name and of functions."""

from __future__ import annotations

from typing import Any, Callable, Mapping, Sequence, Union

import numpy as np

from . import _analysis
from ._arguments import WORDS, Int, floats, integer
from ._progress import Progress, steps

#: A name, or a function of (pattern, count) that returns points of shape (count, dims).
Generator = Union[str, Callable[[int, int], Any]]

_MOST_POINTS = 2**24  # all of a pattern are in memory
_PART = 2**20  # points that are measured between two looks for Ctrl-C


def integrands() -> dict[str, str]:
    """The integrands that `study` knows, and their formulas.

    Products of them have names too, such as ``"disk*linear"`` over two domains. A name that ends in
    ``-A``, as ``"edge-A"``, takes a number there: ``"edge-30"``.

    Examples
    --------
    >>> import wellstrat
    >>> wellstrat.analysis.integrands()["bilinear"]
    'x y'
    """
    return {name: formula for name, _, formula in _analysis.families()}


def study(generators: Generator | Sequence[str] | Mapping[str, Generator],
          integrands: str | Sequence[str] = ("disk", "gaussian", "bilinear"),  # noqa: A002
          counts: Int | Sequence[Int] = (4, 16, 64, 256, 1024), patterns: Int = 100, *,
          progressive: bool = True, progress: Progress = None) -> dict[str, dict[str, Any]]:
    """Root mean squared errors of integrals, by the number of points, over many patterns.

    Parameters
    ----------
    generators : str, callable, sequence of str, or dict of str to either
        ``"pmj"``, ``"joint"``, ``"long"``, ``"blue"``, ``"random"``, and for comparison ``"sobol"``,
        ``"sobol-shift"``, ``"sobol-owen"``, ``"halton"``, ``"jitter"``; ``"long-words"`` is
        ``"long"`` with all 32 bits. A function of your own is called with a pattern, 0 to
        ``patterns - 1``, and a count, and returns points of shape ``(count, dims)``, with `dims` of
        the integrand or more.
    integrands : str or sequence of str
        See `integrands`.
    counts : int or sequence of int
        Numbers of points, increasing, 1 to ``2**24``.
    patterns : int
        Of how many patterns to take the mean.
    progressive : bool
        Whether functions return the same points first for a larger count. If not, they are called
        for each.
    progress : callable or True, optional
        Called with (patterns done, patterns in all); True is a bar of tqdm's.

    Returns
    -------
    dict
        By generator and integrand: ``count``; ``rmse``, and ``low`` and ``high``, its 95 % band;
        ``bias``, the mean error, all by count; ``slope``, of the error in the logarithms over the upper
        half of the counts. `plot.errors` shows it.

    Examples
    --------
    >>> import numpy as np
    >>> import wellstrat
    >>> def own(pattern, count):
    ...     return np.random.default_rng(pattern).random((count, 2))
    >>> errors = wellstrat.analysis.study({"own": own, "pmj": "pmj"}, "gaussian", patterns=50)
    >>> bool(errors["pmj"]["gaussian"]["rmse"][-1] < 0.05 * errors["own"]["gaussian"]["rmse"][-1])
    True
    """
    subjects = _named(generators)
    names = _listed(integrands)
    sizes = [integer(count, "counts", 1, _MOST_POINTS + 1) for count in _listed(counts)]
    number = integer(patterns, "patterns", 1, WORDS + 1)
    for what, given in (("generators", subjects), ("integrands", names), ("counts", sizes)):
        if not given:
            raise ValueError(f"there are no {what}")
    groups: dict[tuple[int, ...], list[str]] = {}
    for name in names:
        if not isinstance(name, str):
            raise TypeError(f"integrands must be names, not {name!r}")
        groups.setdefault(tuple(_analysis.domains(name)), []).append(name)
    runs = [(label, generator, group, _analysis.Study(group, sizes))
            for label, generator in subjects.items() for group in groups.values()]

    part = max(1, _PART // (sizes[-1] * len(names)))
    for begin, end in steps(number, part, progress):
        for _, generator, _, run in runs:
            if isinstance(generator, str):
                run.add_patterns(generator, begin, end)
                continue
            for pattern in range(begin, end):
                _add(run, generator, pattern, sizes, progressive)

    found: dict[str, dict[str, Any]] = {label: {} for label in subjects}
    for label, _, group, run in runs:
        columns = run.results(sizes[len(sizes) // 2])
        for name, (rmse, low, high, bias, slope) in zip(group, columns):
            found[label][name] = {"count": np.array(sizes), "rmse": np.array(rmse),
                                  "low": np.array(low), "high": np.array(high),
                                  "bias": np.array(bias), "slope": slope}
    return found


def _listed(values: Any) -> list[Any]:
    """`values`, or a single one, as a list."""
    if isinstance(values, (Sequence, np.ndarray)) and not isinstance(values, str):
        return list(values)
    return [values]


def _named(generators: Any) -> dict[str, Generator]:
    """Generators by what they are called in the result."""
    if isinstance(generators, str):
        named: dict[str, Any] = {generators: generators}
    elif isinstance(generators, Mapping):
        named = dict(generators)
    elif callable(generators):
        named = {getattr(generators, "__name__", "own"): generators}
    elif isinstance(generators, Sequence):
        named = {name: name for name in generators}
    else:
        raise TypeError(f"generators must be names, a function or a dict of them, not {generators!r}")
    known = _analysis.source_names()
    for generator in named.values():
        if not callable(generator) and generator not in known:
            raise ValueError(f"generators must be functions or of {', '.join(known)}, not "
                             f"{generator!r}")
    return named


def _add(run: _analysis.Study, generator: Callable[[int, int], Any], pattern: int,
         counts: list[int], progressive: bool) -> None:
    """The errors of one pattern of a function."""
    last = len(counts)
    parts = [(0, last)] if progressive else [(c, c + 1) for c in range(last)]
    for first, end in parts:
        count = counts[end - 1]
        points = floats(generator(pattern, count), "points of a generator")
        if points.ndim != 2 or len(points) != count or points.shape[1] < run.dims:
            raise ValueError(f"a generator must return points of shape ({count}, {run.dims}), not "
                             f"{points.shape}")
        values = np.ascontiguousarray(points[:, :run.dims], np.float64)
        outside = ~((values >= 0) & (values < 1))
        if outside.any():
            raise ValueError(f"points of a generator must be in [0, 1), not {values[outside][0]}")
        run.add_points(values, first, end)
