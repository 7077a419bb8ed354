# SPDX-License-Identifier: Apache-2.0
"""The golden values of the library, tests/golden/*.txt, from Python. golden.h there explains them."""

import pathlib

import numpy as np
import pytest

import wellstrat

FOLDER = pathlib.Path(__file__).resolve().parents[3] / "tests" / "golden"

# The tables themselves are not reachable from Python; all samples of them are.
LEFT_OUT = {"table"}


def records():
    """The records of each kind: arguments and results, a row each."""
    found = {}
    for name in ("samples", "joint", "long", "blue"):
        for line in (FOLDER / f"{name}.txt").read_text().splitlines():
            if line.startswith("#"):
                continue
            head, results = line.split("=")
            kind, *arguments = head.split()
            found.setdefault(kind, []).append(
                ([int(a, 16) for a in arguments], [int(r, 16) for r in results.split()]))
    return found


RECORDS = records()


def columns(kind):
    """The arguments of all records of a kind, one array each, and their results."""
    arguments, results = zip(*RECORDS[kind])
    return np.array(arguments, np.uint32).T, np.array(results, np.uint32)


def drawn(generator, contexts, **options):
    """x, y and z of samples as integers of 24 bits. Those of all types and dims must agree."""
    single = wellstrat.draw(contexts, 3, generator, **options)
    double = wellstrat.draw(contexts, 3, generator, dtype=np.float64, **options)
    assert np.array_equal(np.floor(double * 2**24) / 2**24, single)
    assert np.array_equal(wellstrat.draw(contexts, 2, generator, **options), single[..., :2])
    assert np.array_equal(wellstrat.draw(contexts, 1, generator, **options), single[..., 2:])
    return (single * 2**24).astype(np.uint32)


def words(contexts):
    return np.stack([contexts["patternid"], contexts["sampleid"]], axis=-1)


@pytest.mark.parametrize("kind, generator", [("sample", "pmj"), ("random", "random"),
                                             ("long", "long"), ("blue", "blue")])
def test_samples(kind, generator):
    (patterns, sampleids), expected = columns(kind)
    assert np.array_equal(drawn(generator, wellstrat.contexts(patterns, sampleids)), expected)


@pytest.mark.parametrize("kind, generator", [("joint", "pmj"), ("longslot", "long"),
                                             ("blueslot", "blue")])
def test_slots(kind, generator):
    for (pattern, sampleid, slot, splits), expected in RECORDS[kind]:
        context = wellstrat.contexts(pattern, sampleid)
        assert drawn(generator, context, slot=slot, splits=splits).tolist() == expected


def test_all_bits_of_the_sequence():
    (patterns, sampleids), expected = columns("sequence")
    contexts = wellstrat.contexts(patterns, sampleids)
    xyz = wellstrat.draw(contexts, 3, "long", dtype=np.float64)
    assert np.array_equal((xyz * 2**32).astype(np.uint32), expected)


def test_runs():
    (patterns, firsts, counts), expected = columns("run")
    runs = [wellstrat.draw(wellstrat.contexts(p, (f + np.arange(n)) % 2**32), 3).ravel()
            for p, f, n in zip(patterns, firsts.astype(np.uint64), counts)]
    bits = (np.array(runs) * 2**24).astype(np.uint32)
    digest = np.full(len(runs), 2166136261, np.uint32)
    for word in bits.T:
        for shift in range(0, 32, 8):
            digest = (digest ^ ((word >> shift) & 0xff)) * np.uint32(16777619)
    assert np.array_equal(digest, expected[:, 0])


def test_hash():
    (a, b), expected = columns("hash")
    assert np.array_equal(wellstrat.hash_to_random(a, b) * 2**24, expected[:, 0] >> 8)


@pytest.mark.parametrize("kind, generator", [("domain", "pmj"), ("split", "pmj"),
                                             ("distrib", "pmj"), ("bluesplit", "blue"),
                                             ("bluedistrib", "blue")])
def test_domains(kind, generator):
    derive = {"domain": wellstrat.new_domain, "split": wellstrat.new_domain_split,
              "distrib": wellstrat.new_domain_distrib}[kind.removeprefix("blue")]
    for (pattern, sampleid, *arguments), expected in RECORDS[kind]:
        child = derive(wellstrat.contexts(pattern, sampleid), *arguments, generator=generator)
        assert words(child).tolist() == expected


def test_cameras():
    for (x, y, frame, sampleid), expected in RECORDS["camera"]:
        pixel = wellstrat.camera_contexts(1, 1, frame, sampleid, origin=(x, y))
        assert words(pixel)[0, 0].tolist() == expected
    for (x, y, frame, sampleid, seed), expected in RECORDS["seeded"]:
        pixel = wellstrat.camera_contexts(1, 1, frame, sampleid, seed=seed, origin=(x, y))
        assert words(pixel)[0, 0].tolist() == expected
    for (x, y, seed, sampleid), expected in RECORDS["bluecamera"]:
        pixel = wellstrat.blue_contexts(1, 1, seed, sampleid, origin=(x, y))
        assert words(pixel)[0, 0].tolist() == expected


def test_the_stream_and_that_no_kind_is_forgotten():
    assert RECORDS["stream"][0][1] == [wellstrat.stream_version]
    checked = {"stream", "sample", "random", "long", "blue", "joint", "longslot", "blueslot",
               "sequence", "run", "hash", "domain", "split", "distrib", "bluesplit", "bluedistrib",
               "camera", "seeded", "bluecamera"}
    assert set(RECORDS) == checked | LEFT_OUT
