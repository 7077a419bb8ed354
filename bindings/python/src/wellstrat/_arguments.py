# SPDX-License-Identifier: Apache-2.0
"""Checks of arguments, and the arrays that the compiled module fills."""

from __future__ import annotations

import operator
from typing import Any, SupportsIndex

import numpy as np
import numpy.typing as npt

from . import _core

#: Integers of Python and of NumPy.
Int = SupportsIndex

WORDS = 2**32

#: A sample context: which pattern, and which of its samples.
context_dtype: np.dtype[np.void] = np.dtype([("patternid", np.uint32), ("sampleid", np.uint32)])

_GENERATORS = {
    "pmj": _core.Generator.pmj,
    "long": _core.Generator.long,
    "blue": _core.Generator.blue,
    "random": _core.Generator.random,
}


def integer(value: Any, name: str, low: int, high: int) -> int:
    """`value` as an int in [low, high)."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} must be an integer, not {value!r}") from None
    if not low <= number < high:
        raise ValueError(f"{name} must be from {low} to {high - 1}, not {number}")
    return number


def word(value: Any, name: str) -> int:
    """`value` as an unsigned integer of 32 bits."""
    return integer(value, name, 0, WORDS)


def words(values: Any, name: str) -> npt.NDArray[np.uint32]:
    """`values`, integers of any shape, as unsigned integers of 32 bits in C order."""
    array = np.asarray(values, order="C")
    if array.ndim == 0:
        return np.array(word(array.item(), name), np.uint32)
    if array.dtype == np.uint32:
        return array
    if array.dtype.kind not in "iu":
        if isinstance(values, np.ndarray) and array.dtype != object:
            raise TypeError(f"{name} must be integers, not {array.dtype}")
        each = np.asarray(values, object)  # integers of Python may be of no type of NumPy's
        return np.array([word(value, name) for value in each.flat], np.uint32).reshape(each.shape)
    if int(np.bitwise_or.reduce(array, axis=None)) >> 32:
        for value in (array.min(), array.max()):
            word(value, name)  # one of them is none
    return array.astype(np.uint32)


def floats(values: Any, name: str) -> npt.NDArray[Any]:
    """`values`, numbers of any shape, as float32 or float64."""
    array = np.asarray(values)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"{name} must be real numbers, not {array.dtype}")
    return array if array.dtype in (np.float32, np.float64) else array.astype(np.float64)


def finite(array: npt.NDArray[Any], name: str) -> npt.NDArray[np.float32]:
    """`array` as float32, if all of it is finite there."""
    with np.errstate(over="ignore"):
        single = array.astype(np.float32, copy=False)
    good = np.isfinite(single)
    if not good.all():
        raise ValueError(f"{name} must be finite in float32, not {array[~good].flat[0]}")
    return single


def vectors(values: Any, width: int, name: str) -> npt.NDArray[np.float32]:
    """Finite vectors of `width` coordinates."""
    array = floats(values, name)
    if array.ndim == 0 or array.shape[-1] != width:
        raise ValueError(f"{name} must be of shape (..., {width}), not {array.shape}")
    return finite(array, name)


def unit_floats(values: Any, name: str) -> npt.NDArray[np.float32]:
    """`values` in [0, 1) as float32 in C order, cut to 24 bits as samples of this type are, so that
    none becomes 1."""
    array = floats(values, name)
    inside = (array >= 0) & (array < 1)
    if not inside.all():
        raise ValueError(f"{name} must be in [0, 1), not {array[~inside].flat[0]}")
    if array.dtype == np.float64:
        array = np.floor(array * 2**24) * 2.0**-24
    return np.asarray(array, np.float32, order="C")


def contexts_of(values: Any, name: str = "contexts") -> npt.NDArray[np.void]:
    """`values` as an array of contexts in C order."""
    array = np.asarray(values, order="C")
    if array.dtype != context_dtype:
        raise TypeError(f"{name} must be an array of wellstrat.context_dtype, not of {array.dtype}")
    return array


def generator_of(name: Any) -> _core.Generator:
    """The generator of this name."""
    if not isinstance(name, str) or name not in _GENERATORS:
        known = ", ".join(map(repr, _GENERATORS))
        raise ValueError(f"generator must be one of {known}, not {name!r}")
    return _GENERATORS[name]


def is_blue(generator: Any) -> bool:
    """Whether domains are derived as those of blue noise are."""
    return generator_of(generator) == _core.Generator.blue


class Output:
    """The array that a function returns: `out`, or a new one of this shape and type.

    `buffer` is what to fill, of the same shape and in C order. It is another array where `out` is
    in another order or shares memory with `source`; `filled` then copies.
    """

    def __init__(self, shape: tuple[int, ...], dtype: Any, out: Any = None,
                 source: npt.NDArray[Any] | None = None) -> None:
        wanted = np.dtype(dtype)
        if wanted not in (np.float32, np.float64):
            raise TypeError(f"dtype must be float32 or float64, not {wanted}")
        if out is None:
            self.buffer = self._result = np.empty(shape, wanted)
            return
        if not isinstance(out, np.ndarray):
            raise TypeError(f"out must be a NumPy array, not {type(out).__name__}")
        if out.dtype != wanted:
            raise TypeError(f"out must be of dtype {wanted}, not {out.dtype}; dtype= sets which")
        if out.shape != shape:
            raise ValueError(f"out must be of shape {shape}, not {out.shape}")
        if not out.flags.writeable:
            raise ValueError("out is read-only")
        apart = source is None or not np.may_share_memory(out, source)
        self._result = out
        self.buffer = out if apart and out.flags.c_contiguous else np.empty(shape, wanted)

    @property
    def is_double(self) -> bool:
        """Whether it is float64, not float32."""
        return self.buffer.dtype == np.float64

    def filled(self) -> npt.NDArray[Any]:
        """The array to return, once `buffer` is filled."""
        if self.buffer is not self._result:
            self._result[...] = self.buffer
        return self._result
