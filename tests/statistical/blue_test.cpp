// SPDX-License-Identifier: Apache-2.0
//
// What only many tiles show of BlueProgressive: that each sample by itself is uniform, what tiles,
// seeds, domains and visits know of each other, and how often two domains draw the same.
//
// False alarms: statistics.h; under 200 checks.

#include "RixRNG.h"
#include "statistical/statistics.h"
#include "wellstrat/blue.h"
#include "wellstrat/camera.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace statistical;
using namespace wellstrat;

constexpr auto kHit = static_cast<Scramble>(0x03707344u);
constexpr auto kLight = static_cast<Scramble>(0xa4093822u);
constexpr auto kBxdf = static_cast<Scramble>(0x082efa98u);

const BlueProgressive kBlue;

/// Pixel (x, y) of each of n tiles of a picture.
std::vector<SampleCtx> pixelOfTiles(unsigned n, int x, int y, unsigned seed, unsigned sampleid) {
    std::vector<SampleCtx> contexts;
    for (unsigned tile = 0; tile < n; ++tile) {
        contexts.push_back(blueContext(64 * static_cast<int>(tile % 256) + x,
                                       64 * static_cast<int>(tile / 256) + y, seed, sampleid));
    }
    return contexts;
}

void check(double z, const std::string& what) {
    EXPECT_GE(normalTail(z), kAlpha) << what << ": " << z << " standard deviations";
}

/// The correlation of two fields of mean 0 in units of its standard deviation, that of independent
/// ones.
double score(const std::vector<double>& a, const std::vector<double>& b) {
    double product = 0, squareA = 0, squareB = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        product += a[i] * b[i];
        squareA += a[i] * a[i];
        squareB += b[i] * b[i];
    }
    return product / std::sqrt(squareA * squareB) * std::sqrt(static_cast<double>(a.size()));
}

// ---- single samples

TEST(BlueSamples, AreUniformOverTiles) {
    constexpr unsigned kTiles = 1u << 16;
    std::vector<SampleCtx> children(kTiles);
    std::vector<Float3> xis(kTiles);
    for (const unsigned slot : {0u, 1u, 9u, kJointSlots}) {
        for (const unsigned sampleid : {0u, 5u, 4100u}) {
            std::vector<SampleCtx> contexts = pixelOfTiles(kTiles, 3, 60, slot, sampleid);
            RixRNG(RixRNG(contexts, kTiles, &kBlue), jointScramble(slot), children)
                .DrawSamples3D(xis);
            std::vector<uint32_t> xy(256), xz(256), yz(256);
            for (const Float3& xi : xis) {
                const auto cell = [](float u, float v) {
                    return static_cast<unsigned>(u * 16) * 16 + static_cast<unsigned>(v * 16);
                };
                ++xy[cell(xi.x, xi.y)];
                ++xz[cell(xi.x, xi.z)];
                ++yz[cell(xi.y, xi.z)];
            }
            EXPECT_GT(uniformP(xy), kAlpha) << "slot " << slot << ", sample " << sampleid;
            EXPECT_GT(uniformP(xz), kAlpha) << "slot " << slot << ", sample " << sampleid;
            EXPECT_GT(uniformP(yz), kAlpha) << "slot " << slot << ", sample " << sampleid;
        }
    }
}

// ---- sums over blocks of pixels

constexpr unsigned kTiles = 1u << 14;

bool inDisk(Float2 p) { return p.x * p.x + p.y * p.y < 2 / 3.14159265f; }

/// The errors of the means over 8 x 8 pixels of each tile, with samples [first, first + count) of
/// a disk, in the domain that `derive` makes of a RixRNG and an array.
template <typename Derive>
std::vector<double> blockErrors(unsigned seed, unsigned first, unsigned count, Derive derive) {
    std::vector<double> errors(kTiles, 0.0);
    std::vector<SampleCtx> children(kTiles);
    std::vector<Float2> xis(kTiles);
    for (unsigned s = first; s < first + count; ++s) {
        for (int pixel = 0; pixel < 64; ++pixel) {
            std::vector<SampleCtx> camera = pixelOfTiles(kTiles, pixel % 8, pixel / 8, seed, s);
            derive(RixRNG(camera, kTiles, &kBlue), children).DrawSamples2D(xis);
            for (unsigned i = 0; i < kTiles; ++i) errors[i] += (inDisk(xis[i]) ? 0.5 : -0.5) / 64;
        }
    }
    for (double& error : errors) error /= count;
    return errors;
}

double meanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value * value;
    return sum / static_cast<double>(values.size());
}

/// The mean square error of `samples` independent ones.
double whiteSquare(unsigned samples) { return 0.25 / samples; }

RixRNG plain(const RixRNG& camera, std::vector<SampleCtx>& children) {
    return {camera, kLight, children};
}
RixRNG other(const RixRNG& camera, std::vector<SampleCtx>& children) {
    return {camera, kBxdf, children};
}
RixRNG distributed(const RixRNG& camera, std::vector<SampleCtx>& children) {
    return {camera, kLight, children, RixRNG::Distrib{0}};
}

// Tiles, seeds and domains know nothing of each other, and no block is biased.
TEST(BlueBlocks, OfTilesSeedsAndDomainsAreIndependent) {
    const std::vector<double> here = blockErrors(1, 0, 1, plain);
    EXPECT_LT(meanSquare(here), 0.35 * whiteSquare(64));
    check(score(here, blockErrors(2, 0, 1, plain)), "seeds");
    check(score(here, blockErrors(1, 0, 1, other)), "domains");
    const std::vector<double> left(here.begin(), here.end() - 1),
        right(here.begin() + 1, here.end());
    check(score(left, right), "tiles");
    double sum = 0;
    for (const double error : here) sum += error;
    check(sum / std::sqrt(meanSquare(here) * kTiles), "bias");
}

// A distribution makes the visits of a pixel white: independent of each other. Those of neighbors
// still know of each other in each visit, so that all visits together are as blue as each one is.
TEST(BlueBlocks, AreWhiteBetweenVisitsOfADistributionAndBlueInEach) {
    const std::vector<double> first = blockErrors(1, 0, 1, distributed);
    const std::vector<double> second = blockErrors(1, 1, 1, distributed);
    check(score(first, second), "visits");
    EXPECT_LT(meanSquare(first), 0.35 * whiteSquare(64));
    EXPECT_LT(meanSquare(second), 0.35 * whiteSquare(64));
    EXPECT_LT(meanSquare(blockErrors(1, 0, 4, distributed)), 0.35 * whiteSquare(4 * 64));
}

// ... where those of a plain domain are made for each other: four visits are better than four
// independent ones.
TEST(BlueBlocks, SamplesOfADomainAreMadeForEachOther) {
    EXPECT_LT(meanSquare(blockErrors(1, 0, 4, plain)),
              0.7 * meanSquare(blockErrors(1, 0, 4, distributed)));
}

/// The errors of the means over 8 x 8 pixels of a product of signs, of disks in both domains, with
/// the first `count` samples.
std::vector<double> productErrors(Scramble a, Scramble b, unsigned count) {
    std::vector<double> errors(kTiles, 0.0);
    std::vector<SampleCtx> ofA(kTiles), ofB(kTiles);
    std::vector<Float2> xiA(kTiles), xiB(kTiles);
    for (unsigned s = 0; s < count; ++s) {
        for (int pixel = 0; pixel < 64; ++pixel) {
            std::vector<SampleCtx> camera = pixelOfTiles(kTiles, pixel % 8, pixel / 8, 4, s);
            const RixRNG rng(camera, kTiles, &kBlue);
            RixRNG(rng, a, ofA).DrawSamples2D(xiA);
            RixRNG(rng, b, ofB).DrawSamples2D(xiB);
            for (unsigned i = 0; i < kTiles; ++i) {
                errors[i] += (inDisk(xiA[i]) == inDisk(xiB[i]) ? 1.0 : -1.0) / 64 / count;
            }
        }
    }
    return errors;
}

// All slots of a path have one index and one rank, each in an order of its own: orders that were
// the same would be a lockstep, in which blocks are 3 to 60 times worse than independent pixels.
TEST(BlueBlocks, SlotsAreNotInLockstep) {
    for (const auto& [a, b] : {std::pair(0u, 1u), std::pair(2u, 7u), std::pair(9u, 15u)}) {
        for (const unsigned count : {1u, 4u}) {
            const double square =
                meanSquare(productErrors(jointScramble(a), jointScramble(b), count));
            EXPECT_LT(square, 2.0 / (64 * count)) << a << " " << b << ", " << count << " samples";
        }
    }
}

// ---- equal states

/// The states, the upper 20 bits, of 50 domains of a path: ten hits, and four domains of each.
template <typename Derive>
void pathStates(unsigned camera, Derive derive, std::vector<unsigned>& states) {
    states.clear();
    for (unsigned hit = 0, pattern = camera; hit < 10; ++hit) {
        pattern = derive(pattern, kHit);
        states.push_back(pattern >> 12);
        for (unsigned use = 0; use < 4; ++use) {
            states.push_back(derive(pattern, jointScramble(4 * hit + use)) >> 12);
        }
    }
}

/// In how many of 2^20 pixels or tiles two of 50 domains have one state.
template <typename Camera, typename Derive>
unsigned countRepeated(Camera camera, Derive derive) {
    unsigned repeated = 0;
    std::vector<unsigned> states;
    for (unsigned i = 0; i < 1u << 20; ++i) {
        pathStates(camera(i), derive, states);
        std::sort(states.begin(), states.end());
        repeated += std::adjacent_find(states.begin(), states.end()) != states.end();
    }
    return repeated;
}

// 50 * 49 / 2 pairs of 2^20 states: 0.117 %, 1225 of 2^20 tiles. Of all tiles there are, so this is
// no matter of chance; and of pixels whose domains were derived without the generator.
TEST(BlueStates, TwoOf50DomainsShareOneInAtMost15Of10000Tiles) {
    constexpr unsigned kMost = 1573; // 0.15 %
    EXPECT_LE(countRepeated([](unsigned tile) { return tile << 12; },
                            [](unsigned p, Scramble s) { return deriveBluePattern(p, s); }),
              kMost);
    EXPECT_LE(countRepeated(
                  [](unsigned i) {
                      return cameraContext(static_cast<int>(i % 1024), static_cast<int>(i / 1024),
                                           0, 0)
                          .patternid;
                  },
                  [](unsigned p, Scramble s) { return derivePattern(p, s); }),
              kMost);
}

/// The standard deviation over single pairs of scrambles must be that of chance as well: pairs that
/// never share a state, and others that often do, would have the mean of above.
TEST(BlueStates, PairsOfDomainsShareThemAsRandomOnesDo) {
    constexpr unsigned kPairs = 60;
    double sum = 0, squares = 0;
    for (unsigned i = 0; i < kPairs; ++i) {
        const auto a = static_cast<Scramble>(3 * i), b = static_cast<Scramble>(3 * i + 1);
        double shared[2] = {0, 0};
        for (unsigned state = 0; state < 1u << 20; ++state) {
            const unsigned ofA = deriveBluePattern(state << 12, a);
            const unsigned ofB = deriveBluePattern(state << 12, b);
            shared[0] += ofA == ofB;
            shared[1] += deriveBluePattern(ofA, b) == deriveBluePattern(ofB, a);
        }
        for (const double count : shared) {
            sum += count;
            squares += (count - 1) * (count - 1);
        }
    }
    // Poisson: mean and variance 1, the fourth central moment 4.
    check((sum - 2 * kPairs) / std::sqrt(2.0 * kPairs), "mean");
    check((squares - 2 * kPairs) / std::sqrt(3 * 2.0 * kPairs), "variance");
}

// ---- every generator, from every kind of context

using Contexts = std::vector<SampleCtx>;

/// What an integrator may have made of a camera's contexts, with a generator or without.
struct Kind {
    const char* name;
    bool isBlue, isRaw;
};

class EveryGenerator : public testing::TestWithParam<unsigned> {};

// No generator draws two domains of a pixel in lockstep, whatever its contexts, and all samples are
// in the unit cube. From pixels of different tiles, which are independent; the first samples, the
// last one there is, and those of splits that exceed 2^32.
TEST_P(EveryGenerator, DrawsFromEveryKindOfContext) {
    constexpr unsigned n = 1u << 14;
    const unsigned sampleid = GetParam();
    const unsigned split = sampleid == 3 ? 1 : 4;
    const RandomGenerator random;
    const JointProgressive joint;
    const LongProgressive longer;
    const std::pair<const char*, const Generator*> generators[] = {{"tables", nullptr},
                                                                   {"random", &random},
                                                                   {"joint", &joint},
                                                                   {"long", &longer},
                                                                   {"blue", &kBlue}};
    for (const auto& [name, generator] : generators) {
        for (const Kind kind : {Kind{"camera", false, false}, Kind{"camera, by hand", false, true},
                                Kind{"blue", true, false}, Kind{"blue, by hand", true, true}}) {
            Contexts camera = pixelOfTiles(n, 5, 6, 0, sampleid), domains[2] = {camera, camera};
            for (unsigned i = 0; i < n && !kind.isBlue; ++i) {
                camera[i] = cameraContext(static_cast<int>(i % 128), static_cast<int>(i / 128), 0,
                                          sampleid);
            }
            const RixRNG rng(camera, n, generator);
            std::vector<double> errors[2];
            for (unsigned d = 0; d < 2; ++d) {
                for (unsigned i = 0; i < n && kind.isRaw; ++i) {
                    domains[d][i] = camera[i].NewDomainSplit(jointScramble(d), split);
                }
                const RixRNG domain =
                    kind.isRaw ? RixRNG(rng, domains[d], n)
                               : RixRNG(rng, jointScramble(d), domains[d], RixRNG::Split{split});
                std::vector<Float3> xis(n);
                domain.DrawSamples3D(xis);
                for (const Float3& xi : xis) {
                    for (const float value : {xi.x, xi.y, xi.z}) {
                        ASSERT_TRUE(value >= 0 && value < 1) << name << ", " << kind.name;
                    }
                    errors[d].push_back(double{xi.x} - 0.5);
                }
            }
            check(score(errors[0], errors[1]), std::string(name) + ", " + kind.name);
            unsigned same = 0;
            for (unsigned i = 0; i < n; ++i) same += errors[0][i] == errors[1][i];
            EXPECT_LE(same, 6u) << name << ", " << kind.name; // of chance 0.02
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sampleids, EveryGenerator, testing::Values(3u, 0x7fffffffu, 0xffffffffu));

} // namespace
