// SPDX-License-Identifier: Apache-2.0
//
// The search for a tile of pixels whose errors differ between neighbors.
// Heitz, Belcour, Ostromoukhov, Coeurjolly and Iehl 2019, "A Low-Discrepancy Sampler that
// Distributes Monte Carlo Errors as a Blue Noise in Screen Space".
//
// All pixels take one Owen-scrambled Sobol' sequence in two dimensions. A pixel of the tile has a
// word for each coordinate (its scrambling) and a number (its ranking), all of which act by
// exclusive or: sample i is point i ^ rank of the sequence, with its coordinates ^ the words. The
// error of a pixel is a vector: of the integrals of random half-planes, with 1, 2, 4, ... samples.
// Neighbors are to have errors that cancel: the energy of error_field.h falls by annealing, where
// pixels exchange what they have, or one gets another rank.
//
// The paper optimizes scramblings at one number of samples, then ranks for half as many again and
// again. All at once came out better here. So did weights that reach further: after a Gaussian of 2
// pixels, the error at 1 sample is about 0.42 of white, with the paper's weights 0.57.

#pragma once

#include "error_field.h"

#include <array>
#include <cstdint>
#include <vector>

namespace wellstrat::rivals {

/// Up to which number of samples the errors of a pixel are optimized.
constexpr unsigned kTileSamples = 1u << (kTileLevels - 1);

struct TilePixel {
    std::array<uint32_t, 2> scrambling;
    uint32_t rank; ///< in [0, kTileSamples)
};

/// Coordinate `c` in [0, 3) of point `index` of the sequence `seed`, as a fraction of 2^32.
uint32_t tileCoordinate(uint32_t seed, uint32_t index, unsigned c);

/// The tile for the sequence `seed`, row after row, which takes some seconds. The same on every
/// machine.
std::vector<TilePixel> optimizeTile(uint32_t seed);

} // namespace wellstrat::rivals
