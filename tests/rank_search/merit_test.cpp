// SPDX-License-Identifier: Apache-2.0
//
// What is computed about neighbouring pixels without a sample, against samples: pixels of a whole
// tile with exact Owen scrambling, filtered.

#include "rank_search/merit.h"

#include "rank_search/rank_banks.h"
#include "rank_search/tile.h"

#include "wellstrat/bits.h"
#include "wellstrat/owen.h"
#include "wellstrat/sobol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace rank_tests {
namespace {

/// A function of one coordinate with the spectrum of step1D: the sum of 2^(-k/2) times the
/// sign of binary digit k, and 1.
double stepLike(uint32_t coordinate) {
    double sum = 1;
    for (unsigned k = 1; k <= kLevels; ++k) {
        const double sign = (coordinate >> (32 - k) & 1u) != 0 ? 1 : -1;
        sum += sign * std::exp2(-0.5 * k);
    }
    return sum;
}

struct Point {
    uint32_t x, y;
};

/// Place `place` of the pixel of rank `rank`, scrambled and swapped by a domain's seed.
Point pointOf(uint32_t seed, uint32_t place, uint32_t rank) {
    static const SobolMatrix places[] = {sobolMatrix(0), sobolMatrix(1)};
    static const RankMatrix ranks[] = {rankMatrix(0), rankMatrix(1)};
    uint32_t xy[2];
    for (unsigned d = 0; d < 2; ++d) {
        xy[d] = sobolSample(places[d], place) ^ reverseBits(rankTimes(ranks[d], rank));
    }
    if ((hashPair(seed, 3) & 1u) != 0) std::swap(xy[0], xy[1]);
    return {owenScramble(xy[0], hashPair(seed, 1), kLevels),
            owenScramble(xy[1], hashPair(seed, 2), kLevels)};
}

double boxLike(const Point& point) { return stepLike(point.x) * stepLike(point.y); }

const Model& modelNamed(const std::vector<Model>& models, const std::string& name) {
    return *std::find_if(models.begin(), models.end(),
                         [&](const Model& model) { return model.name == name; });
}

/// The mean over the tile of the squares of `errors` after a Gaussian of sigma 2 pixels on the
/// torus, in units of what it leaves of white noise of variance 1.
double filteredSquare(const std::vector<double>& errors) {
    constexpr int kReach = 8;
    constexpr int kSize = kRankTileSize;
    std::vector<double> kernel;
    double sum = 0, squares = 0;
    for (int d = -kReach; d <= kReach; ++d) {
        kernel.push_back(std::exp(-d * d / 8.0));
        squares += kernel.back() * kernel.back();
    }
    std::vector<double> values = errors, filtered(values.size());
    for (unsigned pass = 0; pass < 2; ++pass) { // transposes twice
        for (int y = 0; y < kSize; ++y) {
            for (int x = 0; x < kSize; ++x) {
                double& value = filtered[static_cast<std::size_t>(x * kSize + y)];
                value = 0;
                for (int d = -kReach; d <= kReach; ++d) {
                    const int other = (x + d + kSize) % kSize;
                    value += kernel[static_cast<std::size_t>(d + kReach)] *
                             values[static_cast<std::size_t>(y * kSize + other)];
                }
            }
        }
        values.swap(filtered);
    }
    for (const double value : values) sum += value * value;
    return sum / static_cast<double>(values.size()) / (squares * squares);
}

/// The mean of 2^k values in each pixel of the tile, less 1.
std::vector<double> errorsOf(unsigned k, const std::function<double(uint32_t, uint32_t)>& value) {
    std::vector<double> errors;
    for (uint32_t pixel = 0; pixel < kRanks; ++pixel) {
        double sum = 0;
        for (uint32_t i = 0; i < 1u << k; ++i) sum += value(pixel, i);
        errors.push_back(std::ldexp(sum, -static_cast<int>(k)) - 1);
    }
    return errors;
}

// Some 100 independent areas in each of 200 tiles leave the ratios of variances standard errors of
// 1 %; that the formula's window ends at 8 pixels counts 1 %.
constexpr unsigned kTiles = 200;
constexpr double kTolerance = 0.06;

TEST(RankMerit, OfOneDomainAgreesWithSamples) {
    std::mt19937 random(1);
    const Tile tile = randomTile(random);
    const Visits visits = visitsOf(0, identityColumns());
    for (const unsigned k : {0u, 2u}) {
        double filtered = 0, plain = 0;
        for (uint32_t seed = 0; seed < kTiles; ++seed) {
            const auto errors = errorsOf(k, [&](uint32_t pixel, uint32_t i) {
                return boxLike(pointOf(hashPair(seed, 7), i, tile[pixel]));
            });
            filtered += filteredSquare(errors);
            for (const double error : errors) plain += error * error / kRanks;
        }
        const Sums sums = sumsOf(modelNamed(modelsOfOne(), "box"), k);
        const double computed = merit(weightsOf(tile, 0), covarianceOf(sums, visits, visits));
        EXPECT_NEAR(filtered / plain / computed, 1, kTolerance) << k;
    }
}

TEST(RankMerit, OfPairsAgreesWithSamples) {
    std::mt19937 random(2);
    const Tile tile = randomTile(random);
    const RankBank bank = randomBank(6, 3);
    const Visits a = visitsOf(2, bank[2]), b = visitsOf(5, bank[5]);
    const unsigned k = 3;
    double joint = 0;
    for (uint32_t seed = 0; seed < kTiles; ++seed) {
        const uint32_t first = hashPair(seed, 11), second = hashPair(seed, 12);
        joint += filteredSquare(errorsOf(k, [&](uint32_t pixel, uint32_t i) {
            const uint32_t rank = tile[pixel];
            return boxLike(pointOf(first, a.places[i], a.images[rank])) *
                   boxLike(pointOf(second, b.places[i], b.images[rank]));
        }));
    }
    double padded = 0;
    for (uint32_t seed = 0; seed < kTiles / 5; ++seed) { // whose pixels are all independent
        const auto errors = errorsOf(k, [&](uint32_t pixel, uint32_t i) {
            const uint32_t key = hashPair(hashPair(seed, 13), pixel);
            const auto shuffled = [&](uint32_t shuffle) {
                return owenScramble(i << (32 - k), hashPair(key, shuffle), k) >> (32 - k);
            };
            return boxLike(pointOf(hashPair(key, 7), shuffled(5), 0)) *
                   boxLike(pointOf(hashPair(key, 8), shuffled(6), 0));
        });
        for (const double error : errors) padded += 5 * error * error / kRanks;
    }
    const Sums sums = sumsOf(modelNamed(modelsOfPairs(), "box x box"), k);
    const double computed = merit(weightsOf(tile, 0), covarianceOf(sums, a, b));
    EXPECT_NEAR(joint / padded / computed, 1, kTolerance);
}

TEST(RankMerit, OfIndependentPixelsIsOne) {
    const Visits visits = visitsOf(0, identityColumns());
    EXPECT_NEAR(covarianceOf(sumsOfOne(), visits, visits)[0], 1, 1e-9);
    for (const Model& model : modelsOfOne()) {
        for (unsigned k = 0; k <= kRunDigits; ++k) {
            EXPECT_NEAR(covarianceOf(sumsOf(model, k), visits, visits)[0], 1, 1e-6) << model.name;
        }
    }
    // Two slots with one sample have nothing to be stratified in but their neighbours.
    for (const Model& model : modelsOfPairs()) {
        EXPECT_NEAR(covarianceOf(sumsOf(model, 0), visits, visits)[0], 1, 1e-9) << model.name;
    }
}

TEST(RankMerit, AllModelsAndNumbersOfSamplesTakePart) {
    const Visits a = visitsOf(1, randomBank(2, 1)[1]), b = visitsOf(2, identityColumns());
    for (const auto* models : {&modelsOfOne(), &modelsOfPairs()}) {
        double sum = 0, total = 0;
        for (const Model& model : *models) {
            for (unsigned k = 0; k <= kRunDigits; ++k) {
                sum += model.weight * covarianceOf(sumsOf(model, k), a, b)[5];
                total += model.weight;
            }
        }
        const Sums& sums = models == &modelsOfOne() ? sumsOfOne() : sumsOfPairs();
        EXPECT_NEAR(covarianceOf(sums, a, b)[5], sum / total, 1e-9);
    }
}

TEST(RankMerit, LockstepOfSlotsIsDear) {
    const Visits a = visitsOf(0, identityColumns()), b = visitsOf(1, identityColumns());
    const Visits c = visitsOf(1, randomBank(2, 1)[1]);
    const Weights weights = weightsOfRandomTiles();
    EXPECT_GT(merit(weights, covarianceOf(sumsOfPairs(), a, b)),
              1.5 * merit(weights, covarianceOf(sumsOfPairs(), a, c)));
}

} // namespace
} // namespace rank_tests
