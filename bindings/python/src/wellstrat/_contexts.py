# SPDX-License-Identifier: Apache-2.0
"""Where contexts begin, and how those of new domains follow from them."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import Int, context_dtype, contexts_of, integer, is_blue, word, words

_SIDE = 2**16


def contexts(patternid: npt.ArrayLike, sampleid: npt.ArrayLike) -> npt.NDArray[np.void]:
    """Contexts of these patterns and samples.

    Parameters
    ----------
    patternid, sampleid : int or array_like of int
        Unsigned integers of 32 bits, of shapes that broadcast together.

    Returns
    -------
    ndarray of context_dtype

    Examples
    --------
    Sample 0 of patterns 1 to 3:

    >>> import wellstrat
    >>> wellstrat.contexts([1, 2, 3], 0)["patternid"].tolist()
    [1, 2, 3]
    """
    patterns, samples = words(patternid, "patternid"), words(sampleid, "sampleid")
    result = np.empty(np.broadcast_shapes(patterns.shape, samples.shape), context_dtype)
    result["patternid"] = patterns
    result["sampleid"] = samples
    return result


def pixel_of(value: Any, name: str) -> tuple[int, int]:
    """`value`, x and y, modulo 65536."""
    try:
        x, y = value
    except (TypeError, ValueError):
        raise TypeError(f"{name} must be a pair of integers, not {value!r}") from None
    everything = 2**63
    return (integer(x, name, -everything, everything) % _SIDE,
            integer(y, name, -everything, everything) % _SIDE)


def _pixels(width: Any, height: Any, origin: Any) -> tuple[int, int, int, int]:
    columns = integer(width, "width", 0, _SIDE + 1)
    rows = integer(height, "height", 0, _SIDE + 1)
    return (columns, rows, *pixel_of(origin, "origin"))


def camera_contexts(width: Int, height: Int, frame: Int = 0, sampleid: Int = 0, *, seed: Int = 0,
                    origin: tuple[Int, Int] = (0, 0)) -> npt.NDArray[np.void]:
    """The context of one sample of every pixel of a picture.

    Parameters
    ----------
    width, height : int
        Of the picture, at most 65536 each.
    frame : int
        Frames have independent samples.
    sampleid : int
        The samples of a pixel count up from 0.
    seed : int
        Pictures of one frame with other seeds have independent samples as well.
    origin : pair of int
        x and y of the first pixel, for crops and overscan. They count modulo 65536.

    Returns
    -------
    ndarray of context_dtype
        Of shape ``(height, width)``. All patterns differ.

    Examples
    --------
    >>> import wellstrat
    >>> picture = wellstrat.camera_contexts(64, 48, frame=3)
    >>> crop = wellstrat.camera_contexts(8, 8, frame=3, origin=(16, 24))
    >>> bool((picture[24:32, 16:24] == crop).all())
    True
    """
    columns, rows, x, y = _pixels(width, height, origin)
    result = np.empty((rows, columns), context_dtype)
    _core.camera_contexts(columns, rows, x, y, word(frame, "frame"), word(sampleid, "sampleid"),
                          word(seed, "seed"), result)
    return result


def blue_contexts(width: Int, height: Int, seed: Int = 0, sampleid: Int = 0, *,
                  origin: tuple[Int, Int] = (0, 0)) -> npt.NDArray[np.void]:
    """The same for the generator ``"blue"``, whose pixels know of each other.

    Parameters
    ----------
    width, height, origin
        As of `camera_contexts`.
    seed : int
        Pictures of different seeds are independent. The frames of a sequence share a seed and go on
        in `sampleid`.
    sampleid : int
        The samples of a pixel count up from 0.

    Returns
    -------
    ndarray of context_dtype
        Of shape ``(height, width)``. Derive domains of them with ``generator="blue"``.

    Examples
    --------
    >>> import wellstrat
    >>> pixels = wellstrat.blue_contexts(128, 128)
    >>> wellstrat.draw(pixels, generator="blue").shape
    (128, 128, 2)
    """
    columns, rows, x, y = _pixels(width, height, origin)
    result = np.empty((rows, columns), context_dtype)
    _core.blue_contexts(columns, rows, x, y, word(seed, "seed"), word(sampleid, "sampleid"), result)
    return result


def new_domain(parents: npt.NDArray[np.void], scramble: Int, *,
               generator: str = "pmj") -> npt.NDArray[np.void]:
    """The contexts of a new domain, such as a lens or a light, that has samples of its own.

    Parameters
    ----------
    parents : ndarray of context_dtype
        Of any shape and order.
    scramble : int
        Tells the domain from others of the same parents: any integer of 32 bits, unsigned.
    generator : str
        Domains of ``"blue"`` are derived in another way than all others.

    Returns
    -------
    ndarray of context_dtype
        Other patterns, the same sampleids.

    See Also
    --------
    new_domain_split : Several samples at each visit.
    joint_scramble : Domains that are stratified together.

    Examples
    --------
    >>> import wellstrat
    >>> pixels = wellstrat.camera_contexts(4, 4)
    >>> light = wellstrat.new_domain(pixels, 0x91e4c05a)
    """
    return new_domain_split(parents, scramble, 1, generator=generator)


def new_domain_split(parents: npt.NDArray[np.void], scramble: Int, newnumsamples: Int, *,
                     generator: str = "pmj") -> npt.NDArray[np.void]:
    """The contexts of a new domain of which each visit takes the same number of samples.

    Parameters
    ----------
    parents, scramble, generator
        As of `new_domain`.
    newnumsamples : int
        How many samples each visit takes; all visits together use up one sequence.

    Returns
    -------
    ndarray of context_dtype
        Of the first sample of each visit: ``sampleid * newnumsamples``, modulo ``2**32``.

    Examples
    --------
    >>> import wellstrat
    >>> visit = wellstrat.contexts(1, 5)
    >>> int(wellstrat.new_domain_split(visit, 0x2f07d6c8, 4)["sampleid"])
    20
    """
    source = contexts_of(parents, "parents")
    result = np.empty(source.shape, context_dtype)
    _core.new_domain_split(source, word(scramble, "scramble"),
                           word(newnumsamples, "newnumsamples"), is_blue(generator), result)
    return result


def new_domain_distrib(parents: npt.NDArray[np.void], scramble: Int, newsampleid: Int = 0, *,
                       generator: str = "pmj") -> npt.NDArray[np.void]:
    """The contexts of a new domain of each single sample, for any number of samples.

    Parameters
    ----------
    parents, scramble, generator
        As of `new_domain`.
    newsampleid : int
        Where the samples of each visit begin.

    Returns
    -------
    ndarray of context_dtype
        Each visit has a pattern of its own: its samples are stratified among themselves only.

    Examples
    --------
    >>> import wellstrat
    >>> visits = wellstrat.contexts(1, [0, 1, 2])
    >>> wellstrat.new_domain_distrib(visits, 0x2f07d6c8)["sampleid"].tolist()
    [0, 0, 0]
    """
    source = contexts_of(parents, "parents")
    result = np.empty(source.shape, context_dtype)
    _core.new_domain_distrib(source, word(scramble, "scramble"), word(newsampleid, "newsampleid"),
                             is_blue(generator), result)
    return result


def joint_scramble(slot: Int) -> int:
    """The scramble of a domain that is stratified together with those of the other slots.

    Parameters
    ----------
    slot : int
        0 to 15.

    Returns
    -------
    int
        For `new_domain` and `new_domain_split`. Draw from it with ``slot=slot``.

    Examples
    --------
    >>> import wellstrat
    >>> hex(wellstrat.joint_scramble(0))
    '0x6a6f696e'
    """
    return _core.joint_scramble(integer(slot, "slot", 0, _core.slots))
