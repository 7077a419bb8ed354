# SPDX-License-Identifier: Apache-2.0
"""Random numbers without state, and choices by them."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import finite, floats, unit_floats, words
from ._contexts import contexts


def hash_to_random(a: npt.ArrayLike, b: npt.ArrayLike) -> npt.NDArray[np.float32]:
    """A random number of two integers: the same for the same integers, and without state.

    Parameters
    ----------
    a, b : int or array_like of int
        Unsigned integers of 32 bits, of shapes that broadcast together. For a fixed `a` the values
        for ``b = 0, 1, 2, ...`` are as good as those of a sound generator.

    Returns
    -------
    ndarray of float32
        In [0, 1), of the broadcast shape.

    Examples
    --------
    >>> import wellstrat
    >>> round(float(wellstrat.hash_to_random(1, range(1000)).mean()), 1)
    0.5
    """
    source = contexts(words(a, "a"), words(b, "b"))
    result = np.empty(source.shape, np.float32)
    _core.hash_to_random(source, result)
    return result


class Choice(NamedTuple):
    """What `choose_and_remap` returns; each field has the shape of the samples."""

    chosen: npt.NDArray[np.int64]
    xi: npt.NDArray[np.float32]
    probability: npt.NDArray[np.float32]


def choose_and_remap(xi: npt.ArrayLike, weights: npt.ArrayLike) -> Choice:
    """Chooses one of several things by a sample, and leaves the sample as good as new.

    Parameters
    ----------
    xi : array_like of float
        Samples in [0, 1), of any shape; taken to 24 bits.
    weights : array_like of float
        Of shape ``(n,)`` for all samples, or of a shape that broadcasts to ``xi.shape + (n,)``. At
        least 0, and not all 0; they need not add up to 1.

    Returns
    -------
    chosen : ndarray of int64
        Which was chosen, in [0, n).
    xi : ndarray of float32
        The sample within what was chosen, stretched to [0, 1). Stratified samples give stratified
        subsets.
    probability : ndarray of float32
        Of the choice: its weight over the sum of all.

    Notes
    -----
    A choice of probability p takes log2(1 / p) of the sample's 24 bits. Shirley et al. 1996, "Monte
    Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1).

    Examples
    --------
    >>> import wellstrat
    >>> choice = wellstrat.choose_and_remap([0.125, 0.5, 0.75], [1, 3])
    >>> choice.chosen.tolist(), choice.probability.tolist()
    ([0, 1, 1], [0.25, 0.75, 0.75])
    >>> choice.xi.tolist()
    [0.5, 0.3333333432674408, 0.6666666865348816]
    """
    remapped = unit_floats(xi, "xi").copy()
    rows = _weights(weights)
    choices = rows.shape[-1]
    if rows.ndim > 1:
        shape = remapped.shape + (choices,)
        try:
            rows = np.broadcast_to(rows, shape)
        except ValueError:
            raise ValueError(f"weights must broadcast to shape {shape}, not {rows.shape}") from None
    chosen = np.empty(remapped.shape, np.int64)
    probability = np.empty(remapped.shape, np.float32)
    _core.choose_and_remap(remapped, np.ascontiguousarray(rows), choices, chosen, probability)
    return Choice(chosen, remapped, probability)


def _weights(values: Any) -> npt.NDArray[np.float32]:
    rows = finite(floats(values, "weights"), "weights")
    if rows.ndim == 0:
        raise ValueError("weights must have at least one dimension")
    if not ((rows >= 0).all() and (rows > 0).any(axis=-1).all()):
        raise ValueError("weights must be at least 0, and not all 0")
    return rows
