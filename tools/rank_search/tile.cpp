// SPDX-License-Identifier: Apache-2.0
#include "rank_search/tile.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace wellstrat::ranks {
namespace {

constexpr unsigned kSize = kRankTileSize;
constexpr unsigned kLevels = kRankDigits / 2;
constexpr int kReach = 8; // of the window, whose weights fall to 2 % of the largest there

double uniform(std::mt19937& random) { return std::ldexp(static_cast<double>(random()), -32); }

/// A distance within the window.
struct Offset {
    int x, y;
    float weight;
};

std::vector<Offset> offsets() {
    const std::vector<float> weights = window();
    std::vector<Offset> result;
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            const auto at =
                (static_cast<unsigned>(y) % kSize) * kSize + static_cast<unsigned>(x) % kSize;
            if (x != 0 || y != 0) result.push_back({x, y, weights[at]});
        }
    }
    return result;
}

/// A swap of the ranks of two quadratic blocks of 2^level x 2^level pixels in one of four times the
/// size, which changes a bit or both of a digit pair in all of their ranks.
struct Swap {
    unsigned level;
    unsigned x, y; ///< of the corner of the larger block
    unsigned first,
        second; ///< the blocks, each in [0, 4): bit 0 is right or left, bit 1 up or down
};

Swap randomSwap(unsigned level, std::mt19937& random) {
    const unsigned size = 2u << level;
    Swap swap{level, 0, 0, 0, 0};
    swap.x = static_cast<unsigned>(random()) % (kSize / size) * size;
    swap.y = static_cast<unsigned>(random()) % (kSize / size) * size;
    swap.first = static_cast<unsigned>(random()) % 4;
    swap.second = (swap.first + 1 + static_cast<unsigned>(random()) % 3) % 4;
    return swap;
}

class Annealing {
public:
    Annealing(const Covariance& covariance, Tile tile)
        : tile_(std::move(tile)), covariance_(covariance.begin(), covariance.end()),
          offsets_(offsets()) {}

    /// What the merit grows by with the swap, times the number of pixels.
    double growth(const Swap& swap) const {
        const unsigned mask = maskOf(swap);
        double sum = 0;
        for (const unsigned block : {swap.first, swap.second}) {
            forPixels(swap, block, [&](unsigned x, unsigned y) {
                for (const Offset& offset : offsets_) {
                    const unsigned ox = (x + static_cast<unsigned>(offset.x)) % kSize;
                    const unsigned oy = (y + static_cast<unsigned>(offset.y)) % kSize;
                    if (moves(swap, ox, oy)) continue;
                    const unsigned rho = tile_[y * kSize + x] ^ tile_[oy * kSize + ox];
                    sum += double(offset.weight * (covariance_[rho ^ mask] - covariance_[rho]));
                }
            });
        }
        return 2 * sum;
    }

    void apply(const Swap& swap) {
        const unsigned mask = maskOf(swap);
        for (const unsigned block : {swap.first, swap.second}) {
            forPixels(swap, block, [&](unsigned x, unsigned y) {
                tile_[y * kSize + x] = static_cast<uint16_t>(tile_[y * kSize + x] ^ mask);
            });
        }
    }

    const Tile& tile() const { return tile_; }

private:
    template <typename Visit>
    static void forPixels(const Swap& swap, unsigned block, Visit visit) {
        const unsigned size = 1u << swap.level;
        const unsigned x0 = swap.x + block % 2 * size, y0 = swap.y + block / 2 * size;
        for (unsigned y = y0; y < y0 + size; ++y) {
            for (unsigned x = x0; x < x0 + size; ++x) visit(x, y);
        }
    }

    static bool moves(const Swap& swap, unsigned x, unsigned y) {
        const unsigned bx = (x - swap.x) >> swap.level, by = (y - swap.y) >> swap.level;
        if (bx > 1 || by > 1) return false;
        const unsigned block = 2 * by + bx;
        return block == swap.first || block == swap.second;
    }

    /// The ranks of the two blocks differ in the digit pair of the level, and there alone if one
    /// looks at where each of them begins.
    unsigned maskOf(const Swap& swap) const {
        const auto digits = [&](unsigned block) {
            const unsigned x = swap.x + ((block % 2) << swap.level);
            const unsigned y = swap.y + ((block / 2) << swap.level);
            return tile_[y * kSize + x] & (3u << (2 * swap.level));
        };
        return digits(swap.first) ^ digits(swap.second);
    }

    Tile tile_;
    std::vector<float> covariance_;
    std::vector<Offset> offsets_;
};

} // namespace

std::vector<float> window() {
    constexpr double kShareOfNarrow = 0.2;
    std::vector<float> weights(kRanks);
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            const auto at =
                (static_cast<unsigned>(y) % kSize) * kSize + static_cast<unsigned>(x) % kSize;
            const double squared = x * x + y * y;
            weights[at] = static_cast<float>((1 - kShareOfNarrow) * std::exp(-squared / 16) +
                                             kShareOfNarrow * std::exp(-squared / 4));
        }
    }
    return weights;
}

double tileMerit(const Tile& tile, const Covariance& covariance) {
    double sum = covariance[0] * kRanks;
    for (unsigned y = 0; y < kSize; ++y) {
        for (unsigned x = 0; x < kSize; ++x) {
            for (const Offset& offset : offsets()) {
                const unsigned ox = (x + static_cast<unsigned>(offset.x)) % kSize;
                const unsigned oy = (y + static_cast<unsigned>(offset.y)) % kSize;
                sum +=
                    double(offset.weight) * covariance[tile[y * kSize + x] ^ tile[oy * kSize + ox]];
            }
        }
    }
    return sum / kRanks;
}

std::array<double, kLevels> levelShares() {
    std::array<double, kLevels> shares{};
    for (const Offset& offset : offsets()) {
        for (unsigned y = 0; y < kSize; ++y) {
            for (unsigned x = 0; x < kSize; ++x) {
                const unsigned ox = (x + static_cast<unsigned>(offset.x)) % kSize;
                const unsigned oy = (y + static_cast<unsigned>(offset.y)) % kSize;
                unsigned level = 0;
                while (((x ^ ox) | (y ^ oy)) >> (level + 1) != 0) ++level;
                shares[level] += double(offset.weight) / kRanks;
            }
        }
    }
    return shares;
}

Tile randomTile(std::mt19937& random) {
    Tile tile(kRanks, 0);
    for (unsigned level = 0; level < kLevels; ++level) {
        const unsigned size = 1u << level;
        for (unsigned y = 0; y < kSize; y += 2 * size) {
            for (unsigned x = 0; x < kSize; x += 2 * size) {
                std::array<unsigned, 4> digits{0, 1, 2, 3};
                for (unsigned i = 4; i > 1; --i) {
                    std::swap(digits[i - 1], digits[static_cast<unsigned>(random()) % i]);
                }
                for (unsigned py = 0; py < 2 * size; ++py) {
                    for (unsigned px = 0; px < 2 * size; ++px) {
                        uint16_t& rank = tile[(y + py) * kSize + x + px];
                        rank = static_cast<uint16_t>(
                            rank | digits[2 * (py >> level) + (px >> level)] << (2 * level));
                    }
                }
            }
        }
    }
    return tile;
}

Tile annealedTile(const Covariance& covariance, unsigned sweeps, std::mt19937& random) {
    Annealing annealing(covariance, randomTile(random));
    // The largest growth that is accepted, at the start: about what a swap of two pixels costs.
    constexpr double kHottest = 1;
    for (unsigned sweep = 0; sweep < sweeps; ++sweep) {
        const double left = 1 - static_cast<double>(sweep) / sweeps;
        for (unsigned level = kLevels; level-- > 0;) {
            const unsigned swaps = 6 * kRanks >> (2 * level + 2);
            for (unsigned i = 0; i < swaps; ++i) {
                const Swap swap = randomSwap(level, random);
                const double limit = kHottest * left * left * uniform(random);
                if (annealing.growth(swap) < limit) annealing.apply(swap);
            }
        }
    }
    return annealing.tile();
}

} // namespace wellstrat::ranks
