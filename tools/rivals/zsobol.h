// SPDX-License-Identifier: Apache-2.0
//
// One sequence over all pixels, in the order of a quadtree.
// Ahmed and Wonka 2020, "Screen-Space Blue-Noise Diffusion of Monte Carlo Sampling Error via
// Hierarchical Ordering of Pixels".
//
// Sample i of pixel (x, y) is point
//
//     [digits of the pixel in Morton order] [digits of i]
//
// of an Owen-scrambled Sobol' sequence, base-4 digits from the highest on, each under one of the 24
// permutations of {0, 1, 2, 3}, chosen by a hash of the digits above it and of the pair of
// dimensions. So an aligned block of 2^a x 2^a pixels takes an aligned run of the sequence: a net,
// if all samples are taken. How many there are, a power of two, must be known before; other numbers
// are rounded up, and then a part of the samples is never taken. All pairs of dimensions share the
// sequence, in 2D, with permutations and scrambling of their own.

#pragma once

#include "wellstrat/analysis/point_source.h"

#include <cstdint>

namespace wellstrat::rivals {

/// The points of the pixel that zsobolPattern names: new ones for each number of points, up to
/// 65536 = 2^16. A domain takes a pair, and one in 3D the first dimension of another for z.
PointSourcePtr zsobolSource();

/// Pixels (x, y) modulo 256 of the picture `seed` modulo 65536. Pictures are independent.
uint32_t zsobolPattern(int x, int y, uint32_t seed);

} // namespace wellstrat::rivals
