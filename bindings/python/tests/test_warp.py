# SPDX-License-Identifier: Apache-2.0
"""The warps: inverses, shapes, densities, broadcasting, and what is refused."""

import math

import numpy as np
import pytest

import wellstrat
from wellstrat import warp

XI = wellstrat.samples(3, 4096)
VIEW = np.array([0.6, 0, 0.8])

PAIRS = [
    (warp.square_to_disk_polar, warp.disk_to_square_polar, ()),
    (warp.square_to_disk_concentric, warp.disk_to_square_concentric, ()),
    (warp.square_to_triangle, warp.triangle_to_square, ()),
    (warp.square_to_cylinder, warp.cylinder_to_square, ()),
    (warp.square_to_sphere, warp.sphere_to_square, ()),
    (warp.square_to_hemisphere, warp.hemisphere_to_square, ()),
    (warp.square_to_cone, warp.cone_to_square, (0.9,)),
    (warp.square_to_hemisphere_cosine, warp.hemisphere_cosine_to_square, ()),
    (warp.square_to_power_cosine, warp.power_cosine_to_square, (20.0,)),
    (warp.square_to_ggx_visible_normal, warp.ggx_visible_normal_to_square, (VIEW, 0.3, 0.4)),
]


@pytest.mark.parametrize("there, back, parameters", PAIRS, ids=lambda value: getattr(value, "__name__", ""))
def test_inverses(there, back, parameters):
    points = there(XI, *parameters)
    difference = np.abs(back(points, *parameters) - XI)
    assert np.minimum(difference, 1 - difference).max() < 2e-3  # azimuths are modulo 1
    if points.shape[1] == 3 and there is not warp.square_to_cylinder:
        assert np.allclose(np.linalg.norm(points, axis=1), 1, atol=1e-5)


def test_densities_integrate_to_one():
    directions = warp.square_to_sphere(XI)
    cosine = directions[:, 2]
    for density in (warp.hemisphere_cosine_pdf(cosine), warp.power_cosine_pdf(cosine, 3.0),
                    warp.ggx_visible_normal_pdf(directions, VIEW, 0.6, 0.5)):
        assert abs((density / warp.sphere_pdf()).mean() - 1) < 0.01
    assert math.isclose(warp.cone_pdf(0.0), warp.hemisphere_pdf(), rel_tol=1e-6)
    assert math.isclose(warp.disk_pdf() * math.pi, 1)
    assert warp.triangle_pdf() == 2 and math.isclose(warp.cylinder_pdf() * 2 * math.pi, 1)


def test_parameters_broadcast():
    cosines = np.array([0.0, 0.5, 0.9])
    cones = warp.square_to_cone(XI[:, np.newaxis], cosines)
    assert cones.shape == (4096, 3, 3)
    for k, cosine in enumerate(cosines):
        assert np.array_equal(cones[:, k], warp.square_to_cone(XI, cosine))
    assert warp.square_to_sphere([0.5, 0.5]).shape == (3,)
    assert warp.hemisphere_cosine_pdf(0.5).shape == ()


def test_double_samples_give_the_same():
    double = wellstrat.samples(3, 4096, dtype=np.float64)
    assert np.array_equal(warp.square_to_sphere(double), warp.square_to_sphere(XI))
    assert np.isfinite(warp.square_to_power_cosine([np.nextafter(1, 0)] * 2, 1e6)).all()


@pytest.mark.parametrize("call, error, text", [
    (lambda: warp.square_to_sphere([0.5, np.nan]), ValueError, r"xi must be in \[0, 1\), not nan"),
    (lambda: warp.square_to_sphere([0.5, 1.0]), ValueError, "not 1.0"),
    (lambda: warp.square_to_sphere([0.5]), ValueError, r"xi must be of shape \(..., 2\), not \(1,\)"),
    (lambda: warp.square_to_sphere(0.5), ValueError, r"of shape \(..., 2\), not \(\)"),
    (lambda: warp.square_to_sphere("ab"), TypeError, "xi must be real numbers"),
    (lambda: warp.sphere_to_square([0, 0, np.inf]), ValueError, "directions must be finite"),
    (lambda: warp.square_to_cone(XI, 1.0), ValueError, r"cos_theta_max must be in \[-1, 1\), not 1.0"),
    (lambda: warp.square_to_power_cosine(XI, -1), ValueError, "exponent must be at least 0"),
    (lambda: warp.square_to_ggx_visible_normal(XI, VIEW, 0, 1), ValueError, "alpha_x must be above 0"),
    (lambda: warp.square_to_ggx_visible_normal(XI, -VIEW, 1, 1), ValueError, "view must have length 1"),
    (lambda: warp.square_to_ggx_visible_normal(XI, VIEW, np.nan, 1), ValueError, "must be finite"),
    (lambda: warp.hemisphere_cosine_pdf(2.0), ValueError, r"cos_theta must be in \[-1, 1\]"),
])
def test_refused(call, error, text):
    with pytest.raises(error, match=text):
        call()
