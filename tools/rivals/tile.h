// SPDX-License-Identifier: Apache-2.0
//
// Points whose errors differ between neighboring pixels, from an optimized tile (tile_search.h).
//
// Each domain has a sequence and a tile of its own. A picture moves the tile of each domain by a
// hash. The tile repeats, at most kTileSamples samples are optimized, and a third coordinate is
// not: its scrambling is random. The tile is smaller than those of the paper's authors (128 x 128),
// and optimized at 64 samples for two dimensions at a time.

#pragma once

#include "wellstrat/analysis/point_source.h"

#include <cstdint>

namespace wellstrat::rivals {

/// The points of the pixel that tilePattern names, for up to kMaxIntegrandDomains domains. The
/// first draw from a domain in the process takes some seconds, in which its tile is optimized.
PointSourcePtr tileSource();

/// Pixels (x, y) modulo kTileSize of the picture `seed` modulo 2^20.
uint32_t tilePattern(int x, int y, uint32_t seed);

} // namespace wellstrat::rivals
