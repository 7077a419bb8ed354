# SPDX-License-Identifier: Apache-2.0
"""Contexts and domains."""

import numpy as np
import pytest

import wellstrat


def test_patterns_and_samples_broadcast():
    contexts = wellstrat.contexts([[1], [2]], range(3))
    assert contexts.shape == (2, 3) and contexts.dtype == wellstrat.context_dtype
    assert contexts["patternid"].tolist() == [[1] * 3, [2] * 3]
    assert contexts["sampleid"].tolist() == [[0, 1, 2]] * 2
    assert wellstrat.contexts(1, 2).shape == ()


@pytest.mark.parametrize("make", (wellstrat.camera_contexts, wellstrat.blue_contexts))
def test_pictures(make):
    picture = make(70, 40, 2, 5)
    assert picture.shape == (40, 70)
    assert len(np.unique(picture["patternid"])) == 70 * 40
    assert (picture["sampleid"] == 5).all()
    assert np.array_equal(make(9, 8, 2, 5, origin=(60, 30)), picture[30:38, 60:69])
    assert np.array_equal(make(9, 8, 2, 5, origin=(60 + 2**16, 30 - 2**20)), picture[30:38, 60:69])
    assert not np.array_equal(make(70, 40, 3, 5), picture)
    assert make(0, 3).shape == (3, 0)


def test_a_seed_is_another_picture():
    assert not np.array_equal(wellstrat.camera_contexts(4, 4, seed=1), wellstrat.camera_contexts(4, 4))


@pytest.mark.parametrize("generator", ("pmj", "long", "blue", "random"))
def test_domains_keep_shapes(generator):
    parents = wellstrat.camera_contexts(6, 4, sampleid=3)
    for parent in (parents, parents.T, parents[1], parents[2, 2]):
        child = wellstrat.new_domain(parent, 7, generator=generator)
        assert child.shape == parent.shape
        assert (child["sampleid"] == 3).all() and (child["patternid"] != parent["patternid"]).all()
        split = wellstrat.new_domain_split(parent, 7, 4, generator=generator)
        assert (split["sampleid"] == 12).all()
        assert np.array_equal(split["patternid"], child["patternid"])
        distributed = wellstrat.new_domain_distrib(parent, 7, 2, generator=generator)
        assert (distributed["sampleid"] == 2).all()
        assert (distributed["patternid"] != child["patternid"]).all()


def test_domains_of_blue_noise_stay_in_their_tile():
    parents = wellstrat.blue_contexts(64, 64)
    child = wellstrat.new_domain(parents, 7, generator="blue")
    assert np.array_equal(child["patternid"] % 4096, parents["patternid"] % 4096)
    assert not np.array_equal(wellstrat.new_domain(parents, 7), child)


def test_scrambles_of_slots():
    scrambles = [wellstrat.joint_scramble(slot) for slot in range(16)]
    assert len(set(scrambles)) == 16


@pytest.mark.parametrize("call, error, text", [
    (lambda: wellstrat.contexts(-1, 0), ValueError, "patternid must be from 0"),
    (lambda: wellstrat.contexts(0, [0.5]), TypeError, "sampleid must be an integer, not 0.5"),
    (lambda: wellstrat.contexts([1, 2], [1, 2, 3]), ValueError, "shape mismatch"),
    (lambda: wellstrat.camera_contexts(2**20, 2**20), ValueError, "width must be from 0 to 65536"),
    (lambda: wellstrat.camera_contexts(4, -1), ValueError, "height must be from 0"),
    (lambda: wellstrat.camera_contexts(4, 4, -1), ValueError, "frame must be from 0"),
    (lambda: wellstrat.camera_contexts(4, 4, origin=3), TypeError, "origin must be a pair"),
    (lambda: wellstrat.blue_contexts(4, 4, 2**32), ValueError, "seed must be from 0"),
    (lambda: wellstrat.blue_contexts(4.0, 4), TypeError, "width must be an integer, not 4.0"),
    (lambda: wellstrat.new_domain([1, 2], 3), TypeError, "parents must be an array of"),
    (lambda: wellstrat.new_domain(wellstrat.contexts(1, 1), None), TypeError, "scramble must be"),
    (lambda: wellstrat.new_domain(wellstrat.contexts(1, 1), 1, generator="x"), ValueError,
     "generator must be one of"),
    (lambda: wellstrat.new_domain_split(wellstrat.contexts(1, 1), 1, -1), ValueError,
     "newnumsamples must be from 0"),
    (lambda: wellstrat.joint_scramble(16), ValueError, "slot must be from 0 to 15, not 16"),
])
def test_refused(call, error, text):
    with pytest.raises(error, match=text):
        call()
