# SPDX-License-Identifier: Apache-2.0
"""Engines for SciPy: what takes a `scipy.stats.qmc.QMCEngine` takes these.

`OwenSobol` has any number of samples and is the one to begin with. `PMJ` reads tables of 4096
samples. `Blue` has a sequence for each pixel of a picture, whose errors cancel between neighbors.
"""

from __future__ import annotations

import inspect
from typing import Any, ClassVar, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import WORDS, generator_of, integer
from ._contexts import blue_contexts, contexts, joint_scramble, new_domain, pixel_of

try:
    from scipy.stats.qmc import QMCEngine
except ImportError as error:
    raise ImportError("wellstrat.qmc needs SciPy 1.10 or newer: install python3-scipy of Debian, "
                      "or scipy by pip") from error

__all__ = ["Blue", "OwenSobol", "PMJ"]

# SciPy 1.15 calls the argument `rng`, and 1.10 to 1.14 know only `seed`.
_SEED = "rng" if "rng" in inspect.signature(QMCEngine.__init__).parameters else "seed"

_MOST_DIMS = 2**16
_COLUMNS = 2  # of a slot
_PADDING = 0x4528_21E6  # tells groups of slots apart; digits of the fraction of pi


class _Domain(NamedTuple):
    """Some columns of the samples."""

    pattern: npt.NDArray[np.uint32]
    slot: int
    dims: int


def _random_word(seed: Any) -> int:
    """Of a seed, the same with any SciPy: versions differ in what they draw from one."""
    if isinstance(seed, np.random.RandomState):
        return int(seed.randint(WORDS, dtype=np.int64))
    try:
        return int(np.random.default_rng(seed).integers(WORDS))
    except TypeError:
        raise TypeError(f"seed must be None, an integer or a Generator, not {seed!r}") from None


class _Engine(QMCEngine):
    """What all engines share. `_bits` is how many bits a sample has."""

    _generator: ClassVar[str]
    _bits: ClassVar[int] = 32

    def __init__(self, d: int, *, seed: Any = None, rng: Any = None,
                 optimization: Any = None) -> None:
        if seed is not None and rng is not None:
            raise TypeError("seed and rng are two names of one argument: give one of them")
        word = _random_word(rng if seed is None else seed)
        super().__init__(d, optimization=optimization, **{_SEED: word})
        integer(d, "d", 0, _MOST_DIMS + 1)
        self._init_quad: dict[str, Any] = {"d": d, "optimization": optimization}
        self._domains = self._split(self._root(word))

    def _root(self, word: int) -> npt.NDArray[np.void]:
        """The context that the samples of a random word begin with."""
        return contexts(word, 0)

    def _split(self, root: npt.NDArray[np.void]) -> list[_Domain]:
        """Up to three dimensions in one domain, or else pairs of them in slots."""
        if self.d <= 3:
            return [_Domain(root["patternid"], _core.slots, self.d)] if self.d > 0 else []
        domains = []
        for column in range(0, self.d, _COLUMNS):
            group, slot = divmod(column // _COLUMNS, _core.slots)
            parent = root
            if group > 0:
                parent = new_domain(root, (_PADDING + group) % WORDS, generator=self._generator)
            child = new_domain(parent, joint_scramble(slot), generator=self._generator)
            domains.append(_Domain(child["patternid"], slot, min(_COLUMNS, self.d - column)))
        return domains

    def _next(self, n: Any) -> int:
        """`n` if that many samples are left."""
        return integer(n, "n", 0, WORDS - self.num_generated + 1)

    def _random(self, n: int = 1, *, workers: int = 1) -> npt.NDArray[np.float64]:
        count = self._next(n)
        generator = generator_of(self._generator)
        middle = 0.5**(self._bits + 1)
        sample = np.empty((count, self.d))
        column = 0
        for domain in self._domains:
            whole = domain.dims == self.d
            part = sample if whole else np.empty((count, domain.dims))
            _core.samples_float64(domain.pattern, count, self.num_generated % WORDS, generator,
                                  domain.dims, domain.slot, middle, part)
            if not whole:
                sample[:, column:column + domain.dims] = part
            column += domain.dims
        return sample

    def fast_forward(self, n: int) -> _Engine:
        """Skips n samples, in no time.

        Parameters
        ----------
        n : int
            How many.

        Returns
        -------
        engine
            This one.
        """
        self.num_generated += self._next(n)
        return self

    def reset(self) -> _Engine:
        """Begins anew with the first sample of the same sequence.

        Returns
        -------
        engine
            This one.
        """
        super().reset()
        return self


class OwenSobol(_Engine):
    """Points of Sobol' with nested uniform scrambling by a hash: up to ``2**32``, without tables.

    Parameters
    ----------
    d : int
        Dimensions, at most 65536. Up to 3 are one domain: any ``2**m`` samples from a multiple of ``2**m`` on are
        a (0, m, 2)-net in the first two dimensions and a (1, m, 3)-net in three. More are pairs of
        dimensions, each a (0, m, 2)-net. 16 pairs are slots, which are stratified together;
        further groups of 16, from dimension 33 on, are combined with them at random.
    seed : {None, int, `numpy.random.Generator`}, optional
        Which of ``2**32`` sequences; None is another one each time. A Generator gives one number.
    rng
        Another name of `seed`, that of newer versions of SciPy.
    optimization : {None, "random-cd", "lloyd"}, optional
        As of `scipy.stats.qmc.QMCEngine`.

    Notes
    -----
    Samples are (v + 1/2) / ``2**32``, those of `wellstrat.samples` moved to the middle of their
    last digit: none is 0 or 1, so that inverses of distributions are finite, and no mean is moved.

    Examples
    --------
    >>> from wellstrat import qmc
    >>> engine = qmc.OwenSobol(2, seed=1)
    >>> engine.random(4).shape
    (4, 2)

    The integral of x y, which is 1/4:

    >>> xy = qmc.OwenSobol(2, seed=1).random(2**16)
    >>> bool(abs(xy.prod(axis=1).mean() - 0.25) < 1e-7)
    True
    """

    _generator = "long"


class PMJ(_Engine):
    """Samples of tables: stratified to 4096, by blocks of 4096 to 196608, and random from there on.

    Parameters
    ----------
    d, seed, rng, optimization
        As of `OwenSobol`.

    Notes
    -----
    Samples have 24 bits: (v + 1/2) / ``2**24``.

    Examples
    --------
    >>> from wellstrat import qmc
    >>> sorted((qmc.PMJ(1, seed=3).random(4)[:, 0] * 4).astype(int).tolist())
    [0, 1, 2, 3]
    """

    _generator = "pmj"
    _bits = 24


class Blue(_Engine):
    """The sequence of one pixel of a picture, of which neighboring pixels know.

    Engines of the same seed for all pixels of a picture give integrals whose errors cancel between
    neighbors: blurred, or seen from a distance, the picture of them has less noise. Each engine is
    as good as `OwenSobol` by itself.

    Parameters
    ----------
    d, seed, rng, optimization
        As of `OwenSobol`.
    pixel : pair of int
        x and y, modulo 65536.

    Notes
    -----
    Whole pictures are faster by `wellstrat.blue_contexts` and `wellstrat.draw`.

    Examples
    --------
    >>> from wellstrat import qmc
    >>> left, right = (qmc.Blue(2, pixel=(x, 0), seed=1) for x in (10, 11))
    >>> means = left.random(4).mean(), right.random(4).mean()
    """

    _generator = "blue"

    def __init__(self, d: int, *, pixel: tuple[int, int] = (0, 0), seed: Any = None,
                 rng: Any = None, optimization: Any = None) -> None:
        self._pixel = pixel_of(pixel, "pixel")
        super().__init__(d, seed=seed, rng=rng, optimization=optimization)
        self._init_quad["pixel"] = pixel

    def _root(self, word: int) -> npt.NDArray[np.void]:
        return blue_contexts(1, 1, seed=word, origin=self._pixel).reshape(())
