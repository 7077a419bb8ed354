# SPDX-License-Identifier: Apache-2.0
"""Samples of patterns and of contexts."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import WORDS, Int, Output, contexts_of, generator_of, integer, words


def samples(pattern: npt.ArrayLike, count: Int, first: Int = 0, dims: Int = 2,
            generator: str = "pmj", *, dtype: npt.DTypeLike = np.float32,
            out: npt.NDArray[Any] | None = None) -> npt.NDArray[Any]:
    """Consecutive samples of a pattern, or of each of several.

    Parameters
    ----------
    pattern : int or array_like of int
        Which randomized sequence; any integer of 32 bits, unsigned.
    count, first : int
        Samples `first` to ``first + count - 1``. A pattern has ``2**32``.
    dims : {2, 1, 3}
        2 gives x and y of each point, 1 its z, 3 all of them.
    generator : {"pmj", "long", "blue", "random"}
        ``"pmj"`` reads tables: stratified to sample 4096, and by blocks of 4096 to sample 196608;
        the fastest. ``"long"`` is computed, and stratified to ``2**32``. ``"blue"`` is so too, and
        patterns of neighboring pixels (`blue_contexts`) are stratified together. ``"random"`` is
        not stratified.
    dtype : {float32, float64}
        In float64 samples have all their bits, 24 for ``"pmj"`` and 32 for the others. float32 has
        the upper 24 of them.
    out : ndarray, optional
        Filled and returned: of the shape of the result and of `dtype`, in any order.

    Returns
    -------
    ndarray
        Of shape ``(count, dims)``, or ``pattern.shape + (count, dims)`` for an array of patterns;
        each value in [0, 1).

    See Also
    --------
    draw : Samples of any contexts.

    Notes
    -----
    A sample is a pure function of pattern, number and coordinate, the same bits as in C++ on every
    machine, as long as `stream_version` is the same. Other Python threads run meanwhile.

    Examples
    --------
    Each quarter of the unit square has one of the first four samples, and so has each quarter of
    each axis:

    >>> import numpy as np
    >>> import wellstrat
    >>> xy = wellstrat.samples(7, 4)
    >>> sorted(np.floor(xy[:, 0] * 4).astype(int).tolist())
    [0, 1, 2, 3]

    The next four, with all 32 bits:

    >>> wellstrat.samples(7, 4, first=4, generator="long", dtype=np.float64).shape
    (4, 2)
    """
    ids = words(pattern, "pattern")
    start = integer(first, "first", 0, WORDS)
    number = integer(count, "count", 0, WORDS + 1)
    if start + number > WORDS:
        raise ValueError(f"first + count must be at most 2**32, the samples of a pattern, not "
                         f"{start + number}")
    coordinates = integer(dims, "dims", 1, 4)
    kind = generator_of(generator)
    output = Output(ids.shape + (number, coordinates), dtype, out, source=ids)
    fill = _core.samples_float64 if output.is_double else _core.samples_float32
    fill(ids, number, start, kind, coordinates, _core.slots, 0.0, output.buffer)
    return output.filled()


def draw(contexts: npt.NDArray[np.void], dims: Int = 2, generator: str = "pmj",
         slot: Int | None = None, *, splits: Int = 1, dtype: npt.DTypeLike = np.float32,
         out: npt.NDArray[Any] | None = None) -> npt.NDArray[Any]:
    """The sample of each context.

    Parameters
    ----------
    contexts : ndarray of context_dtype
        Of any shape and order; see `contexts`, `camera_contexts` and `new_domain`.
    dims, generator, dtype, out
        As of `samples`.
    slot : int, optional
        The contexts are those of the domain ``joint_scramble(slot)``, 0 to 15: all slots of one
        parent are stratified together. ``"random"`` ignores it.
    splits : int
        The product of all splits between the camera and the slot's domain, 1 to 256.

    Returns
    -------
    ndarray
        Of shape ``contexts.shape + (dims,)``; each value in [0, 1).

    Examples
    --------
    >>> import wellstrat
    >>> pixels = wellstrat.camera_contexts(640, 360, frame=1, sampleid=0)
    >>> wellstrat.draw(pixels).shape
    (360, 640, 2)

    Lens and time, stratified together:

    >>> lens = wellstrat.new_domain(pixels, wellstrat.joint_scramble(0))
    >>> time = wellstrat.new_domain(pixels, wellstrat.joint_scramble(1))
    >>> xy = wellstrat.draw(lens, slot=0)
    >>> t = wellstrat.draw(time, dims=1, slot=1)
    """
    source = contexts_of(contexts)
    coordinates = integer(dims, "dims", 1, 4)
    kind = generator_of(generator)
    place = _core.slots if slot is None else integer(slot, "slot", 0, _core.slots)
    branches = integer(splits, "splits", 1, _core.max_splits + 1)
    output = Output(source.shape + (coordinates,), dtype, out, source=source)
    fill = _core.draw_float64 if output.is_double else _core.draw_float32
    fill(source, kind, coordinates, place, branches, output.buffer)
    return output.filled()
