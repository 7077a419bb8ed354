# SPDX-License-Identifier: Apache-2.0
"""hash_to_random and choose_and_remap."""

import numpy as np
import pytest

import wellstrat


def test_random_numbers_are_uniform_and_repeatable():
    numbers = wellstrat.hash_to_random([[1], [2]], range(10000))
    assert numbers.shape == (2, 10000) and numbers.dtype == np.float32
    assert np.array_equal(numbers[1], wellstrat.hash_to_random(2, range(10000)))
    assert abs(numbers.mean() - 0.5) < 4 / np.sqrt(12 * numbers.size)
    with pytest.raises(ValueError, match="a must be from 0"):
        wellstrat.hash_to_random(-1, 0)
    with pytest.raises(TypeError, match="b must be an integer, not 0.5"):
        wellstrat.hash_to_random(0, 0.5)


def test_choices_follow_weights():
    xi = wellstrat.samples(5, 4096, dims=1)[:, 0]
    weights = np.array([1, 0, 2, 5])
    choice = wellstrat.choose_and_remap(xi, weights)
    counts = np.bincount(choice.chosen, minlength=4)
    assert counts.tolist() == [512, 0, 1024, 2560]  # stratified: exact
    assert np.allclose(choice.probability, weights[choice.chosen] / 8)
    for index in (0, 2, 3):  # what is left is stratified as well
        rest = choice.xi[choice.chosen == index]
        strata = np.floor(rest * 512).astype(int)
        assert np.bincount(strata, minlength=512).max() <= len(rest) / 512 + 1
    assert xi[0] == wellstrat.samples(5, 1, dims=1)[0, 0]  # the argument is not written to


def test_weights_of_each_sample():
    xi = np.full((3, 2), 0.5, np.float32)
    weights = np.zeros((3, 2, 6))
    for place in np.ndindex(3, 2):
        weights[place + (place[0] * 2 + place[1],)] = 1
    choice = wellstrat.choose_and_remap(xi, weights)
    assert choice.chosen.tolist() == [[0, 1], [2, 3], [4, 5]]
    assert np.array_equal(wellstrat.choose_and_remap(xi, weights[:, :1]).chosen, [[0, 0], [2, 2], [4, 4]])
    assert wellstrat.choose_and_remap(0.5, [1, 1]).chosen == 1


def test_double_samples_never_become_one():
    choice = wellstrat.choose_and_remap(np.nextafter(1.0, 0.0), [1.0, 1.0])
    assert choice.chosen == 1 and choice.xi < 1


@pytest.mark.parametrize("xi, weights, text", [
    ([0.5, np.nan], [1], r"xi must be in \[0, 1\), not nan"),
    ([1.0], [1], r"xi must be in \[0, 1\), not 1.0"),
    ([0.5], [1, np.nan], "weights must be finite"),
    ([0.5], [1, 1e300], "weights must be finite in float32, not 1e[+]300"),
    ([0.5], [1, -1], "weights must be at least 0, and not all 0"),
    ([0.5], [0, 0], "weights must be at least 0, and not all 0"),
    ([0.5], [], "weights must be at least 0, and not all 0"),
    ([0.5], 1.0, "at least one dimension"),
    ([0.5], [[1, 1], [1, 1]], r"weights must broadcast to shape \(1, 2\), not \(2, 2\)"),
])
def test_refused(xi, weights, text):
    with pytest.raises(ValueError, match=text):
        wellstrat.choose_and_remap(xi, weights)


def test_texts_are_refused():
    with pytest.raises(TypeError, match="xi must be real numbers"):
        wellstrat.choose_and_remap("0.5", [1])
