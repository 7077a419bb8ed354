// SPDX-License-Identifier: Apache-2.0
//
// Maps from the unit square to what renderers sample: areas and directions.
//
//     map                        density               on
//     squareToDiskPolar          diskPdf               disk
//     squareToDiskConcentric     diskPdf               disk
//     squareToTriangle           trianglePdf           triangle
//     squareToCylinder           cylinderPdf           side of a cylinder
//     squareToSphere             spherePdf             all directions
//     squareToHemisphere         hemispherePdf         directions above a plane
//     squareToCone               conePdf               directions around an axis
//     squareToHemisphereCosine   hemisphereCosinePdf   directions, by the cosine
//     squareToPowerCosine        powerCosinePdf        directions, by a power of the cosine
//     squareToGgxVisibleNormal   ggxVisibleNormalPdf   GGX microfacet normals that a viewer sees
//
// Each map has an inverse with the words the other way round, such as diskToSquarePolar. All of
// these hold:
// - Samples are in [0, 1)^2, with steps of 2^-24 or coarser, as the library makes them. No such
//   sample gives a NaN or an infinity.
// - Shapes have radius 1 and stand around the z axis. Directions have length 1 to float precision.
// - Round maps take the distance from the axis (cylinder: the height) from x, and the azimuth from
//   y, as the fraction of a full turn from the x axis towards the y axis. The concentric disk has
//   no such seam, nor have the cosine-weighted hemisphere and the GGX normals, which build on it.
// - Each map is a bijection of the square up to its seams, so strata of samples become strata of
//   equal probability. The first seven have a constant density: strata keep their relative area.
// - Inverses return values in [0, 1)^2, exact up to rounding.
// - Densities are per unit area or solid angle as said there, and assume a point on the shape.
//
// The functions are pure; they check nothing, allocate nothing and may run in any thread.

#pragma once

#include "wellstrat/warp/cap.h"
#include "wellstrat/warp/cylinder.h"
#include "wellstrat/warp/disk.h"
#include "wellstrat/warp/lobe.h"
#include "wellstrat/warp/triangle.h"
