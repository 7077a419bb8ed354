// SPDX-License-Identifier: Apache-2.0

#include "tile.h"

#include "tile_search.h"
#include "wellstrat/hash.h"

#include <array>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

namespace wellstrat::rivals {
namespace {

constexpr uint32_t kPlaces = kTilePixels;

/// The sequence and the tile of a domain.
struct DomainTile {
    std::vector<TilePixel> pixels;
    std::vector<std::array<uint32_t, 3>> points; ///< the first kTileSamples of the sequence
};

uint32_t sequenceOf(uint32_t domain) { return hashPair(0x74696c65u, domain); } // "tile"

const DomainTile& tileOf(uint32_t domain) {
    static std::array<std::once_flag, kMaxIntegrandDomains> once;
    static std::array<DomainTile, kMaxIntegrandDomains> tiles;
    std::call_once(once[domain], [domain] {
        const uint32_t sequence = sequenceOf(domain);
        tiles[domain].pixels = optimizeTile(sequence);
        for (uint32_t i = 0; i < kTileSamples; ++i) {
            tiles[domain].points.push_back({tileCoordinate(sequence, i, 0),
                                            tileCoordinate(sequence, i, 1),
                                            tileCoordinate(sequence, i, 2)});
        }
    });
    return tiles[domain];
}

class TileSource final : public PointSource {
public:
    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        const unsigned stride = totalDims(domains);
        const uint32_t x = pattern % kTileSize, y = pattern / kTileSize % kTileSize;
        for (uint32_t d = 0; d < domains.size(); points += domains[d++]) {
            const DomainTile& tile = tileOf(d);
            const uint32_t shift = hashPair(hashPair(pattern / kPlaces, d), 0);
            const TilePixel& pixel = tile.pixels[(y + shift / kTileSize) % kTileSize * kTileSize +
                                                 (x + shift) % kTileSize];
            const std::array<uint32_t, 3> scrambling{pixel.scrambling[0], pixel.scrambling[1],
                                                     hashPair(hashPair(pattern, d), 1)};
            for (std::size_t i = 0; i < count; ++i) {
                const uint32_t index = static_cast<uint32_t>(i) ^ pixel.rank;
                for (unsigned c = 0; c < domains[d]; ++c) {
                    const uint32_t coordinate = index < kTileSamples
                                                    ? tile.points[index][c]
                                                    : tileCoordinate(sequenceOf(d), index, c);
                    points[i * stride + c] = (coordinate ^ scrambling[c]) * 0x1p-32;
                }
            }
        }
    }

    void check(const DomainDims& domains, std::size_t /*count*/,
               uint64_t /*patterns*/) const override {
        if (domains.size() <= kMaxIntegrandDomains) return;
        throw std::invalid_argument("it has at most " + std::to_string(kMaxIntegrandDomains) +
                                    " domains, not " + std::to_string(domains.size()));
    }
};

} // namespace

PointSourcePtr tileSource() { return std::make_unique<TileSource>(); }

uint32_t tilePattern(int x, int y, uint32_t seed) {
    const uint32_t column = static_cast<uint32_t>(x) % kTileSize;
    const uint32_t row = static_cast<uint32_t>(y) % kTileSize;
    return seed * kPlaces + row * kTileSize + column;
}

} // namespace wellstrat::rivals
