# SPDX-License-Identifier: Apache-2.0
"""Maps from the unit square to areas and directions, their inverses and densities.

=================================  ==========================  =====================================
map                                density                     on
=================================  ==========================  =====================================
`square_to_disk_polar`             `disk_pdf`                  disk
`square_to_disk_concentric`        `disk_pdf`                  disk, without a seam
`square_to_triangle`               `triangle_pdf`              barycentric coordinates
`square_to_cylinder`               `cylinder_pdf`              side of a cylinder
`square_to_sphere`                 `sphere_pdf`                all directions
`square_to_hemisphere`             `hemisphere_pdf`            directions above a plane
`square_to_cone`                   `cone_pdf`                  directions around an axis
`square_to_hemisphere_cosine`      `hemisphere_cosine_pdf`     directions, by the cosine
`square_to_power_cosine`           `power_cosine_pdf`          directions, by a power of the cosine
`square_to_ggx_visible_normal`     `ggx_visible_normal_pdf`    GGX normals that a viewer sees
=================================  ==========================  =====================================

Each map has an inverse with the words the other way round, such as `disk_to_square_polar`.

Samples `xi` are in [0, 1)^2, of shape (..., 2), and are cut to 24 bits; points and directions are
of shape (..., 2) or (..., 3). Parameters may be arrays; all shapes broadcast. Results are float32.
Shapes have radius 1 and stand around the z axis, directions have length 1. Maps are bijections up
to their seams, so strata of samples become strata of equal probability. Densities are per unit area
or solid angle, of points on the shape. wellstrat/warp.h has the sources and more.

Examples
--------
>>> import numpy as np
>>> import wellstrat
>>> xi = wellstrat.samples(1, 256)
>>> directions = wellstrat.warp.square_to_hemisphere_cosine(xi)
>>> directions.shape
(256, 3)
>>> back = wellstrat.warp.hemisphere_cosine_to_square(directions)
>>> bool(np.allclose(back, xi, atol=1e-5))
True
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._arguments import finite, floats, unit_floats, vectors

Floats = npt.NDArray[np.float32]


def _samples(xi: Any) -> Floats:
    """Samples of the unit square."""
    return vectors(unit_floats(xi, "xi"), 2, "xi")


def _parameter(values: Any, name: str, accepted: str, inside: Any) -> Floats:
    """A parameter for which inside(array) holds, with a last axis of one."""
    array = finite(floats(values, name), name)
    if not inside(array).all():
        raise ValueError(f"{name} must be {accepted}, not {array[~inside(array)].flat[0]}")
    return array[..., np.newaxis]


def _cos_theta_max(values: Any) -> Floats:
    return _parameter(values, "cos_theta_max", "in [-1, 1)", lambda a: (a >= -1) & (a < 1))


def _cosine(values: Any) -> Floats:
    return _parameter(values, "cos_theta", "in [-1, 1]", lambda a: (a >= -1) & (a <= 1))


def _exponent(values: Any) -> Floats:
    return _parameter(values, "exponent", "at least 0", lambda a: a >= 0)


def _alpha(values: Any, name: str) -> Floats:
    return _parameter(values, name, "above 0", lambda a: a > 0)


def _view(values: Any) -> Floats:
    view = vectors(values, 3, "view")
    if not ((view[..., 2] > 0) & (abs(np.linalg.norm(view, axis=-1) - 1) < 1e-3)).all():
        raise ValueError("view must have length 1 and z above 0")
    return view


def _apply(name: str, outputs: int, *parts: Floats) -> Floats:
    """The compiled map of this name over rows of all parts side by side."""
    shape = np.broadcast_shapes(*(part.shape[:-1] for part in parts))
    parts_of_rows = [np.broadcast_to(part, shape + part.shape[-1:]) for part in parts]
    rows = np.ascontiguousarray(np.concatenate(parts_of_rows, axis=-1))
    result = np.empty(shape + (outputs,), np.float32)
    _core.apply_map(name, rows, result)
    return result


def square_to_disk_polar(xi: npt.ArrayLike) -> Floats:
    """Points of the unit disk: radius sqrt(x), azimuth y."""
    return _apply("square_to_disk_polar", 2, _samples(xi))


def disk_to_square_polar(points: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_disk_polar`."""
    return _apply("disk_to_square_polar", 2, vectors(points, 2, "points"))


def square_to_disk_concentric(xi: npt.ArrayLike) -> Floats:
    """Points of the unit disk, by concentric squares: Shirley and Chiu 1997."""
    return _apply("square_to_disk_concentric", 2, _samples(xi))


def disk_to_square_concentric(points: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_disk_concentric`."""
    return _apply("disk_to_square_concentric", 2, vectors(points, 2, "points"))


def disk_pdf() -> float:
    """Per unit area."""
    return 1 / math.pi


def square_to_triangle(xi: npt.ArrayLike) -> Floats:
    """Weights of the first two corners of a triangle; the third has 1 - x - y. Heitz 2019."""
    return _apply("square_to_triangle", 2, _samples(xi))


def triangle_to_square(points: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_triangle`."""
    return _apply("triangle_to_square", 2, vectors(points, 2, "points"))


def triangle_pdf() -> float:
    """Per unit of the barycentric coordinates, whose triangle has the area 1/2."""
    return 2.0


def square_to_cylinder(xi: npt.ArrayLike) -> Floats:
    """Points with x^2 + y^2 = 1 and z in [0, 1): height x, azimuth y."""
    return _apply("square_to_cylinder", 3, _samples(xi))


def cylinder_to_square(points: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_cylinder`."""
    return _apply("cylinder_to_square", 2, vectors(points, 3, "points"))


def cylinder_pdf() -> float:
    """Per unit area."""
    return 1 / (2 * math.pi)


def square_to_sphere(xi: npt.ArrayLike) -> Floats:
    """All directions: z = 1 - 2 x, azimuth y."""
    return _apply("square_to_sphere", 3, _samples(xi))


def sphere_to_square(directions: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_sphere`."""
    return _apply("sphere_to_square", 2, vectors(directions, 3, "directions"))


def sphere_pdf() -> float:
    """Per unit solid angle."""
    return 1 / (4 * math.pi)


def square_to_hemisphere(xi: npt.ArrayLike) -> Floats:
    """Directions with z in (0, 1]: z = 1 - x, azimuth y."""
    return _apply("square_to_hemisphere", 3, _samples(xi))


def hemisphere_to_square(directions: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_hemisphere`."""
    return _apply("hemisphere_to_square", 2, vectors(directions, 3, "directions"))


def hemisphere_pdf() -> float:
    """Per unit solid angle."""
    return 1 / (2 * math.pi)


def square_to_cone(xi: npt.ArrayLike, cos_theta_max: npt.ArrayLike) -> Floats:
    """Directions around the z axis.

    Parameters
    ----------
    xi : array_like
        Samples, of shape (..., 2).
    cos_theta_max : array_like
        The cosine of half the angle of the cone, in [-1, 1).

    Returns
    -------
    ndarray of float32
        Of shape (..., 3), with z in (cos_theta_max, 1].
    """
    return _apply("square_to_cone", 3, _samples(xi), _cos_theta_max(cos_theta_max))


def cone_to_square(directions: npt.ArrayLike, cos_theta_max: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_cone`."""
    return _apply("cone_to_square", 2, vectors(directions, 3, "directions"),
                  _cos_theta_max(cos_theta_max))


def cone_pdf(cos_theta_max: npt.ArrayLike) -> npt.NDArray[np.float64]:
    """Per unit solid angle."""
    return 1 / (2 * math.pi * (1 - _cos_theta_max(cos_theta_max)[..., 0].astype(np.float64)))


def square_to_hemisphere_cosine(xi: npt.ArrayLike) -> Floats:
    """Directions with z above 0, with probability proportional to z."""
    return _apply("square_to_hemisphere_cosine", 3, _samples(xi))


def hemisphere_cosine_to_square(directions: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_hemisphere_cosine`."""
    return _apply("hemisphere_cosine_to_square", 2, vectors(directions, 3, "directions"))


def hemisphere_cosine_pdf(cos_theta: npt.ArrayLike) -> Floats:
    """Per unit solid angle; 0 below the plane."""
    return _apply("hemisphere_cosine_pdf", 1, _cosine(cos_theta))[..., 0]


def square_to_power_cosine(xi: npt.ArrayLike, exponent: npt.ArrayLike) -> Floats:
    """Directions with probability proportional to a power of their cosine.

    Parameters
    ----------
    xi : array_like
        Samples, of shape (..., 2).
    exponent : array_like
        Of z, at least 0: 0 gives the hemisphere, 1 the cosine.

    Returns
    -------
    ndarray of float32
        Of shape (..., 3), with z above 0.
    """
    return _apply("square_to_power_cosine", 3, _samples(xi), _exponent(exponent))


def power_cosine_to_square(directions: npt.ArrayLike, exponent: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_power_cosine`, of directions with z above 0."""
    return _apply("power_cosine_to_square", 2, vectors(directions, 3, "directions"),
                  _exponent(exponent))


def power_cosine_pdf(cos_theta: npt.ArrayLike, exponent: npt.ArrayLike) -> Floats:
    """Per unit solid angle; 0 below the plane."""
    return _apply("power_cosine_pdf", 1, _cosine(cos_theta), _exponent(exponent))[..., 0]


def square_to_ggx_visible_normal(xi: npt.ArrayLike, view: npt.ArrayLike, alpha_x: npt.ArrayLike,
                                 alpha_y: npt.ArrayLike) -> Floats:
    """Microfacet normals, distributed as the GGX normals that a viewer sees: Heitz 2018.

    Parameters
    ----------
    xi : array_like
        Samples, of shape (..., 2).
    view : array_like
        Directions to the viewer, of shape (..., 3): of length 1, with z above 0.
    alpha_x, alpha_y : array_like
        The roughness of the distribution along x and y, above 0.

    Returns
    -------
    ndarray of float32
        Of shape (..., 3), with z above 0. Reflecting `view` at a normal m gives a direction of the
        density ``ggx_visible_normal_pdf(m, ...) / (4 m . view)``, which may lie below the surface.
    """
    return _apply("square_to_ggx_visible_normal", 3, _samples(xi), _view(view),
                  _alpha(alpha_x, "alpha_x"), _alpha(alpha_y, "alpha_y"))


def ggx_visible_normal_to_square(normals: npt.ArrayLike, view: npt.ArrayLike,
                                 alpha_x: npt.ArrayLike, alpha_y: npt.ArrayLike) -> Floats:
    """The inverse of `square_to_ggx_visible_normal`, of normals that `view` sees."""
    return _apply("ggx_visible_normal_to_square", 2, vectors(normals, 3, "normals"), _view(view),
                  _alpha(alpha_x, "alpha_x"), _alpha(alpha_y, "alpha_y"))


def ggx_visible_normal_pdf(normals: npt.ArrayLike, view: npt.ArrayLike, alpha_x: npt.ArrayLike,
                           alpha_y: npt.ArrayLike) -> Floats:
    """The density of the normals, per unit solid angle; 0 of those that `view` does not see."""
    return _apply("ggx_visible_normal_pdf", 1, vectors(normals, 3, "normals"), _view(view),
                  _alpha(alpha_x, "alpha_x"), _alpha(alpha_y, "alpha_y"))[..., 0]
