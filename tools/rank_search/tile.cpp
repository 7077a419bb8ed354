// SPDX-License-Identifier: Apache-2.0
#include "rank_search/tile.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace wellstrat::ranks {
namespace {

constexpr unsigned kSize = kRankTileSize;
constexpr unsigned kNodeLevels = kRankDigits / 2;
constexpr int kReach = 8; // of the window, whose weights fall to 2 % of the largest there

double uniform(std::mt19937& random) { return std::ldexp(static_cast<double>(random()), -32); }

/// A distance within the window.
struct Offset {
    int x, y;
    float weight;
};

/// All of them but (0, 0), which has the weight 1.
std::vector<Offset> window(double narrow) {
    std::vector<Offset> result;
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            if (x == 0 && y == 0) continue;
            // The autocorrelation of a Gaussian of sigma s is exp(-d^2 / (4 s^2)).
            const double squared = x * x + y * y;
            const double weight =
                (1 - narrow) * std::exp(-squared / 16) + narrow * std::exp(-squared / 4);
            result.push_back({x, y, static_cast<float>(weight)});
        }
    }
    return result;
}

/// On the torus.
unsigned pixelAt(unsigned x, unsigned y) { return y % kSize * kSize + x % kSize; }

unsigned neighbour(unsigned x, unsigned y, const Offset& offset) {
    return pixelAt(x + static_cast<unsigned>(offset.x), y + static_cast<unsigned>(offset.y));
}

/// Calls visit(pixel, other, weight) for all pairs of different pixels in the window, pixels as
/// elements of a tile.
template <typename Visit>
void forPairs(double narrow, Visit visit) {
    const std::vector<Offset> offsets = window(narrow);
    for (unsigned y = 0; y < kSize; ++y) {
        for (unsigned x = 0; x < kSize; ++x) {
            for (const Offset& offset : offsets) {
                visit(pixelAt(x, y), neighbour(x, y, offset), double(offset.weight));
            }
        }
    }
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
          window_(window(kShareOfNarrow)) {}

    /// What the merit grows by with the swap, times the number of pixels.
    double growth(const Swap& swap) const {
        const unsigned mask = maskOf(swap);
        double sum = 0;
        for (const unsigned block : {swap.first, swap.second}) {
            forPixels(swap, block, [&](unsigned x, unsigned y) {
                for (const Offset& offset : window_) {
                    const unsigned other = neighbour(x, y, offset);
                    if (moves(swap, other)) continue;
                    const unsigned rho = tile_[pixelAt(x, y)] ^ tile_[other];
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

    static bool moves(const Swap& swap, unsigned pixel) {
        const unsigned bx = (pixel % kSize - swap.x) >> swap.level;
        const unsigned by = (pixel / kSize - swap.y) >> swap.level;
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
    std::vector<Offset> window_;
};

} // namespace

Weights weightsOf(const Tile& tile, double narrow) {
    Weights weights(kRanks);
    weights[0] = 1;
    forPairs(narrow, [&](unsigned pixel, unsigned other, double weight) {
        weights[tile[pixel] ^ tile[other]] += weight / kRanks;
    });
    return weights;
}

Weights weightsOfRandomTiles(double narrow) {
    // All rho of pixels that part at the same level, [4^level, 4^(level + 1)), are as likely.
    std::array<double, kNodeLevels> ofLevel{};
    forPairs(narrow, [&](unsigned pixel, unsigned other, double weight) {
        const unsigned differing = pixel ^ other;
        unsigned level = kNodeLevels - 1;
        while (((differing | differing / kSize) >> level & 1u) == 0) --level;
        ofLevel[level] += weight / kRanks;
    });
    Weights weights{1};
    for (unsigned level = 0; level < kNodeLevels; ++level) {
        const std::size_t count = std::size_t{3} << (2 * level);
        weights.insert(weights.end(), count, ofLevel[level] / static_cast<double>(count));
    }
    return weights;
}

double merit(const Weights& weights, const Covariance& covariance) {
    return std::inner_product(weights.begin(), weights.end(), covariance.begin(), 0.0);
}

Tile randomTile(std::mt19937& random) {
    Tile tile(kRanks, 0);
    for (unsigned level = 0; level < kNodeLevels; ++level) {
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

Tile annealedTile(const Covariance& covariance, unsigned sweeps, std::mt19937& random,
                  const std::function<void()>& swept) {
    Annealing annealing(covariance, randomTile(random));
    // The largest growth that is accepted, at the start: about what a swap of two pixels costs.
    constexpr double kHottest = 0.5;
    for (unsigned sweep = 0; sweep < sweeps; ++sweep) {
        const double left = 1 - static_cast<double>(sweep) / sweeps;
        for (unsigned level = kNodeLevels; level-- > 0;) {
            const unsigned swaps = 6 * kRanks >> (2 * level + 2);
            for (unsigned i = 0; i < swaps; ++i) {
                const Swap swap = randomSwap(level, random);
                const double limit = kHottest * left * left * uniform(random);
                if (annealing.growth(swap) < limit) annealing.apply(swap);
            }
        }
        swept();
    }
    return annealing.tile();
}

} // namespace wellstrat::ranks
