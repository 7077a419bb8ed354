# SPDX-License-Identifier: Apache-2.0
"""samples and draw: shapes, types, arrays to fill, stratification, and what is refused."""

import numpy as np
import pytest

import wellstrat

GENERATORS = ("pmj", "long", "blue", "random")
DTYPES = (np.float32, np.float64)


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("dtype", DTYPES)
@pytest.mark.parametrize("dims", (1, 2, 3))
def test_samples_are_draws(generator, dtype, dims):
    run = wellstrat.samples(9, 1500, 4000, dims, generator, dtype=dtype)
    contexts = wellstrat.contexts(9, np.arange(4000, 5500))
    drawn = wellstrat.draw(contexts, dims, generator, dtype=dtype)
    assert run.shape == (1500, dims) and run.dtype == dtype
    assert np.array_equal(run, drawn)
    assert ((run >= 0) & (run < 1)).all()


def test_several_patterns():
    patterns = np.array([[5, 2**32 - 1, 7], [8, 9, 10]])
    all_at_once = wellstrat.samples(patterns, 33, 2, generator="long")
    assert all_at_once.shape == (2, 3, 33, 2)
    for place, pattern in np.ndenumerate(patterns):
        assert np.array_equal(all_at_once[place], wellstrat.samples(pattern, 33, 2, generator="long"))
    assert wellstrat.samples(np.empty(0, np.uint32), 5).shape == (0, 5, 2)
    assert wellstrat.samples(5, 0).shape == (0, 2)


def test_integers_of_all_kinds_are_patterns():
    expected = wellstrat.samples(np.array([1, 0, 2], np.uint32), 4)
    for same in ([1, 0, 2], (True, False, 2), range(3), np.array([1, 0, 2], np.int8),
                 np.array([1, 0, 2], ">i8"), np.array([1, 0, 2], object)):
        order = [1, 0, 2] if isinstance(same, range) else slice(None)
        assert np.array_equal(wellstrat.samples(same, 4), expected[order])
    assert wellstrat.samples([], 4).shape == (0, 4, 2)
    assert np.array_equal(wellstrat.samples(True, 4), wellstrat.samples(1, 4))


@pytest.mark.parametrize("generator", GENERATORS)
@pytest.mark.parametrize("dtype", DTYPES)
def test_runs_are_of_any_length(generator, dtype):
    patterns = np.arange(2000, 2070)
    for count, first in ((1, 2**32 - 1), (7, 4090), (300, 5)):  # 512 are computed at a time
        contexts = wellstrat.contexts(patterns[:, np.newaxis], first + np.arange(count))
        assert np.array_equal(wellstrat.samples(patterns, count, first, 3, generator, dtype=dtype),
                              wellstrat.draw(contexts, 3, generator, dtype=dtype))


def test_long_runs_are_computed_in_parts():
    count = 2**22 + 5  # more than one part, and no whole number of blocks
    run = wellstrat.samples([1, 2], count, 3, dims=1, generator="long")
    for pattern in (1, 2):
        ends = [0, 1, 2**22 - 1, 2**22, count - 1]
        contexts = wellstrat.contexts(pattern, np.array(ends) + 3)
        assert np.array_equal(run[pattern - 1, ends], wellstrat.draw(contexts, 1, "long"))


@pytest.mark.parametrize("generator", ("pmj", "long"))
def test_aligned_runs_are_nets(generator):
    xy = wellstrat.samples(77, 256, 512, generator=generator)
    for log_columns in range(9):
        columns, rows = 2**log_columns, 2 ** (8 - log_columns)
        cells = np.floor(xy[:, 0] * columns) * rows + np.floor(xy[:, 1] * rows)
        assert sorted(cells) == list(range(256))


def test_bits_of_float64():
    for generator, bits in (("pmj", 24), ("long", 32), ("blue", 32), ("random", 32)):
        scaled = wellstrat.samples(3, 1000, generator=generator, dtype=np.float64) * 2.0**bits
        assert np.array_equal(scaled, np.floor(scaled))
        assert (scaled % 2 == 1).any()  # the last bit is used


def test_slots_are_other_samples():
    parents = wellstrat.contexts(4, np.arange(64))
    lens = wellstrat.new_domain(parents, wellstrat.joint_scramble(3))
    assert not np.array_equal(wellstrat.draw(lens, slot=3), wellstrat.draw(lens))
    assert np.array_equal(wellstrat.draw(lens, slot=3), wellstrat.draw(lens, slot=np.int8(3)))
    assert not np.array_equal(wellstrat.draw(lens, slot=3, splits=4), wellstrat.draw(lens, slot=3))
    assert np.array_equal(wellstrat.draw(lens, 2, "random", 3), wellstrat.draw(lens, 2, "random"))


def fill_all_ways(function, shape):
    """Calls function(out=...) for arrays of all kinds, which must come back with the same values."""
    expected = function(out=None)
    spaced = np.full(tuple(2 * n for n in shape), np.nan, np.float32)
    outs = {
        "contiguous": np.empty(shape, np.float32),
        "Fortran": np.empty(shape, np.float32, order="F"),
        "spaced": spaced[tuple(slice(None, None, 2) for _ in shape)],
        "backwards": np.empty(shape, np.float32)[::-1],
        "unaligned": np.ndarray(shape, np.float32, bytearray(4 * expected.size + 1), 1),
        "subclass": np.empty(shape, np.float32).view(np.memmap),
    }
    for name, out in outs.items():
        assert function(out=out) is out, name
        assert np.array_equal(out, expected), name
    assert np.isnan(spaced[1::2]).all()  # nothing beside it was written


def test_arrays_to_fill():
    contexts = wellstrat.camera_contexts(5, 7)
    fill_all_ways(lambda out: wellstrat.samples(3, 12, out=out), (12, 2))
    fill_all_ways(lambda out: wellstrat.draw(contexts, 3, out=out), (7, 5, 3))


def test_contexts_in_any_order():
    contexts = wellstrat.camera_contexts(9, 6)
    expected = wellstrat.draw(contexts)
    for same in (np.asfortranarray(contexts), contexts[::-1][::-1], contexts.repeat(2, 0)[::2]):
        assert np.array_equal(wellstrat.draw(same), expected)
    assert np.array_equal(wellstrat.draw(contexts.T), expected.swapaxes(0, 1))
    assert np.array_equal(wellstrat.draw(contexts[2, 3]), expected[2, 3])
    broadcast = np.broadcast_to(contexts[2, 3], (4, 4))
    assert (wellstrat.draw(broadcast) == expected[2, 3]).all()


def test_filling_the_memory_of_the_contexts():
    contexts = wellstrat.contexts(1, np.arange(100))
    expected = wellstrat.draw(contexts)
    out = contexts.view(np.float32).reshape(100, 2)
    assert np.array_equal(wellstrat.draw(contexts, out=out), expected)


CONTEXTS = wellstrat.contexts(1, np.arange(4))
READ_ONLY = np.empty((4, 2), np.float32)
READ_ONLY.flags.writeable = False


@pytest.mark.parametrize("arguments, error, text", [
    ({"count": 2**40}, ValueError, "count must be from 0 to 4294967296, not 1099511627776"),
    ({"count": -1}, ValueError, "count must be from 0"),
    ({"count": 1.5}, TypeError, "count must be an integer, not 1.5"),
    ({"count": 2, "first": 2**32 - 1}, ValueError, r"first \+ count must be at most 2\*\*32"),
    ({"first": -1}, ValueError, "first must be from 0"),
    ({"dims": 4}, ValueError, "dims must be from 1 to 3, not 4"),
    ({"dims": 0}, ValueError, "dims must be from 1 to 3, not 0"),
    ({"pattern": 2**32}, ValueError, "pattern must be from 0 to 4294967295, not 4294967296"),
    ({"pattern": [1, -1]}, ValueError, "pattern must be from 0 to 4294967295, not -1"),
    ({"pattern": 0.5}, TypeError, "pattern must be an integer, not 0.5"),
    ({"pattern": [0.5]}, TypeError, "pattern must be an integer, not 0.5"),
    ({"pattern": np.array([0.5])}, TypeError, "pattern must be integers, not float64"),
    ({"pattern": np.array([False])}, TypeError, "pattern must be integers, not bool"),
    ({"pattern": [1, 2**64]}, ValueError, "pattern must be from 0 to 4294967295, not 184467"),
    ({"pattern": [2**63, -1]}, ValueError, "pattern must be from 0 to 4294967295, not 922337"),
    ({"pattern": np.array([-(2**31)], np.int32)}, ValueError, "not -2147483648"),
    ({"pattern": np.array([1, 2**63], np.uint64)}, ValueError, "not 9223372036854775808"),
    ({"pattern": "7"}, TypeError, "pattern must be an integer, not '7'"),
    ({"pattern": 2**70}, ValueError, "pattern must be from 0 to 4294967295"),
    ({"pattern": float("nan")}, TypeError, "pattern must be an integer, not nan"),
    ({"generator": "joint"}, ValueError, "generator must be one of 'pmj', 'long', 'blue', 'random'"),
    ({"generator": None}, ValueError, "not None"),
    ({"dtype": np.float16}, TypeError, "dtype must be float32 or float64, not float16"),
    ({"dtype": ">f4"}, TypeError, "dtype must be float32 or float64, not >f4"),
    ({"out": [[0.0] * 2] * 4}, TypeError, "out must be a NumPy array, not list"),
    ({"out": np.empty((4, 2))}, TypeError, "out must be of dtype float32, not float64"),
    ({"out": np.empty((4, 3), np.float32)}, ValueError, r"of shape \(4, 2\), not \(4, 3\)"),
    ({"out": READ_ONLY}, ValueError, "out is read-only"),
])
def test_samples_refuse(arguments, error, text):
    with pytest.raises(error, match=text):
        wellstrat.samples(**{"pattern": 1, "count": 4, **arguments})


@pytest.mark.parametrize("arguments, error, text", [
    ({"contexts": np.zeros(4)}, TypeError, "an array of wellstrat.context_dtype, not of float64"),
    ({"contexts": np.zeros(4, ">u4,>u4")}, TypeError, "contexts must be an array of"),
    ({"contexts": None}, TypeError, "contexts must be an array of"),
    ({"contexts": CONTEXTS.astype([("patternid", ">u4"), ("sampleid", ">u4")])}, TypeError, ">u4"),
    ({"slot": 16}, ValueError, "slot must be from 0 to 15, not 16"),
    ({"slot": -1}, ValueError, "slot must be from 0 to 15, not -1"),
    ({"slot": 0, "splits": 257}, ValueError, "splits must be from 1 to 256, not 257"),
    ({"slot": 0, "splits": 0}, ValueError, "splits must be from 1 to 256, not 0"),
    ({"out": READ_ONLY}, ValueError, "out is read-only"),
])
def test_draws_refuse(arguments, error, text):
    with pytest.raises(error, match=text):
        wellstrat.draw(**{"contexts": CONTEXTS, **arguments})


def test_what_no_memory_holds_is_refused():
    contexts = np.broadcast_to(CONTEXTS[0], (2**20, 2**20))
    with pytest.raises((MemoryError, ValueError)):
        wellstrat.draw(contexts)
    with pytest.raises((MemoryError, ValueError)):
        wellstrat.samples(np.zeros(2**16, np.uint32), 2**32)
