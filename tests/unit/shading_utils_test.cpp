// SPDX-License-Identifier: Apache-2.0
//
// RixShadingUtils.h: choosing with remapping, directions around normals, the small helpers.

#include "RixRNG.h"
#include "RixShadingUtils.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

constexpr float kLargest = 1.0f - 0x1p-24f;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr unsigned kAllSamples = 1u << 24;

bool inUnitInterval(float xi) { return xi >= 0.0f && xi < 1.0f; }

// Every float that a sample can be, for probabilities at which rounding is worst. Guards against a
// remapped 1.0f, an outcome of probability 0, and a biased choice: the number of samples that
// choose 0 is exactly the number below prob0.
TEST(ChooseAndRemapTest, TwoWayIsRightForEverySample) {
    for (const float prob0 :
         {0.0f, 1e-30f, 0x1p-24f, 0.1f, 1.0f / 3.0f, 0.5f, 0.8f, 0.99999f, kLargest, 1.0f}) {
        unsigned zeros = 0;
        bool inside = true, ordered = true;
        float last[] = {0.0f, 0.0f};
        for (unsigned k = 0; k < kAllSamples; ++k) {
            float xi = static_cast<float>(k) * 0x1p-24f;
            const unsigned choice = RixChooseAndRemap(xi, prob0);
            zeros += choice == 0 ? 1 : 0;
            inside &= inUnitInterval(xi);
            ordered &= xi >= last[choice];
            last[choice] = xi;
        }
        EXPECT_TRUE(inside) << prob0;
        EXPECT_TRUE(ordered) << prob0;
        EXPECT_EQ(zeros, std::ceil(double(prob0) * kAllSamples)) << prob0;
    }
}

// The same for weights, among which are zeros at the beginning, in the middle and at the end.
TEST(ChooseAndRemapTest, ManyWayIsRightForEverySample) {
    const std::vector<float> weights = {0.0f, 3.0f, 0.0f, 1e-3f, 2.0f, 0.7f, 0.0f};
    const auto n = static_cast<unsigned>(weights.size());
    double total = 0.0;
    for (const float weight : weights) total += double(weight);

    std::vector<unsigned> counts(n + 1);
    bool inside = true, ordered = true;
    unsigned lastChoice = 0;
    float lastXi = 0.0f;
    for (unsigned k = 0; k < kAllSamples; ++k) {
        float xi = static_cast<float>(k) * 0x1p-24f;
        const unsigned choice = RixChooseAndRemap(xi, weights.data(), n);
        ++counts[choice];
        inside &= inUnitInterval(xi);
        ordered &= choice > lastChoice || (choice == lastChoice && xi >= lastXi);
        lastChoice = choice;
        lastXi = xi;
    }
    EXPECT_TRUE(inside);
    EXPECT_TRUE(ordered);
    for (unsigned i = 0; i < n; ++i) {
        const double expected = double(weights[i]) / total * kAllSamples;
        EXPECT_NEAR(counts[i], expected, expected > 0.0 ? 1.0 : 0.0) << i;
    }
    EXPECT_EQ(counts[n], 0u);
}

// The remapped sample runs through all of [0, 1): linear, from 0 at the lower end of the part.
TEST(ChooseAndRemapTest, StretchesThePart) {
    const float weights[] = {1.0f, 0.0f, 4.0f, 5.0f};
    for (const float within : {0.0f, 0.25f, 0.5f, 0.9375f}) {
        float xi = 0.1f + 0.4f * within;
        float prob = 0.0f;
        EXPECT_EQ(RixChooseAndRemap(xi, weights, 4, &prob), 2u);
        EXPECT_NEAR(xi, within, 1e-6f);
        EXPECT_FLOAT_EQ(prob, 0.4f);

        xi = 0.8f * within;
        EXPECT_EQ(RixChooseAndRemap(xi, 0.8f), 0u);
        EXPECT_NEAR(xi, within, 1e-6f);
        xi = 0.8f + 0.2f * within;
        EXPECT_EQ(RixChooseAndRemap(xi, 0.8f), 1u);
        EXPECT_NEAR(xi, within, 1e-6f);
    }
}

TEST(ChooseAndRemapTest, TwoWayTakesProbabilitiesOutOfRange) {
    for (const float prob0 : {-1.0f, -0.0f, 0.0f, kNaN}) {
        for (const float sample : {0.0f, 0.5f, kLargest}) {
            float xi = sample;
            EXPECT_EQ(RixChooseAndRemap(xi, prob0), 1u);
            EXPECT_EQ(xi, sample);
        }
    }
    for (const float prob0 : {1.0f, 1.5f, std::numeric_limits<float>::infinity()}) {
        for (const float sample : {0.0f, 0.5f, kLargest}) {
            float xi = sample;
            EXPECT_EQ(RixChooseAndRemap(xi, prob0), 0u);
            EXPECT_EQ(xi, sample);
        }
    }
}

TEST(ChooseAndRemapTest, ManyWayWithoutAnyWeightChoosesNone) {
    const float none[] = {0.0f, -2.0f, kNaN};
    for (const unsigned n : {0u, 1u, 3u}) {
        float xi = 0.3f, prob = 7.0f;
        EXPECT_EQ(RixChooseAndRemap(xi, none, n, &prob), n);
        EXPECT_EQ(prob, 0.0f);
        EXPECT_EQ(xi, 0.3f);
    }
}

TEST(ChooseAndRemapTest, ManyWaySkipsNegativeAndNaNWeights) {
    const float weights[] = {kNaN, -5.0f, 2.0f, kNaN, 6.0f, -1.0f};
    for (unsigned k = 0; k < 1024; ++k) {
        const float sample = static_cast<float>(k) / 1024.0f;
        float xi = sample, prob = 0.0f;
        const unsigned choice = RixChooseAndRemap(xi, weights, 6, &prob);
        EXPECT_EQ(choice, sample < 0.25f ? 2u : 4u);
        EXPECT_FLOAT_EQ(prob, sample < 0.25f ? 0.25f : 0.75f);
    }
}

// Weights as large and as small as floats get: sums in float would overflow or lose the small ones.
TEST(ChooseAndRemapTest, ManyWayTakesExtremeWeights) {
    const float large = std::numeric_limits<float>::max();
    const float small = std::numeric_limits<float>::denorm_min();
    const float larges[] = {large, large, large, large};
    const float smalls[] = {small, small, small, small};
    for (const float* weights : {larges, smalls}) {
        for (unsigned k = 0; k < 4; ++k) {
            float xi = static_cast<float>(k) * 0.25f + 0.125f, prob = 0.0f;
            EXPECT_EQ(RixChooseAndRemap(xi, weights, 4, &prob), k);
            EXPECT_EQ(xi, 0.5f);
            EXPECT_EQ(prob, 0.25f);
        }
    }
    const float mixed[] = {1.0f, small, large};
    float xi = 0.0f;
    EXPECT_EQ(RixChooseAndRemap(xi, mixed, 3), 0u);
    xi = kLargest;
    EXPECT_EQ(RixChooseAndRemap(xi, mixed, 3), 2u);
    EXPECT_LT(xi, 1.0f);
}

// Just below the end of the first part: (0.5 * total) / 1 is 1 - 2^-25, which rounds to 1.0f.
TEST(ChooseAndRemapTest, ManyWayNeverRoundsToOne) {
    const float weights[] = {1.0f, kLargest};
    float xi = 0.5f;
    EXPECT_EQ(RixChooseAndRemap(xi, weights, 2), 0u);
    EXPECT_EQ(xi, kLargest);
}

TEST(ChooseAndRemapTest, OneEntryKeepsTheSample) {
    const float weight = 0.37f;
    for (const float sample : {0.0f, 0x1p-24f, 0.3f, kLargest}) {
        float xi = sample, prob = 0.0f;
        EXPECT_EQ(RixChooseAndRemap(xi, &weight, 1, &prob), 0u);
        EXPECT_EQ(xi, sample);
        EXPECT_EQ(prob, 1.0f);
    }
}

/// The two subsets into which 1024 samples of a pattern fall when one of two lights is chosen.
struct TwoLights {
    std::vector<RtFloat2> subset[2];

    TwoLights(unsigned patternid, float prob0) {
        std::vector<RixRNG::SampleCtx> contexts;
        for (unsigned k = 0; k < 1024; ++k) contexts.push_back({patternid, k});
        std::vector<RtFloat2> xi(1024);
        RixRNG(contexts.data(), 1024).DrawSamples2D(xi.data());
        for (RtFloat2 sample : xi) {
            const unsigned light = RixChooseAndRemap(sample.x, prob0);
            subset[light].push_back(sample);
        }
    }
};

unsigned countIn(const std::vector<RtFloat2>& points, RtFloat2 low, RtFloat2 high) {
    return static_cast<unsigned>(std::count_if(points.begin(), points.end(), [&](RtFloat2 p) {
        return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y;
    }));
}

/// Every one of columns x rows cells of the unit square holds `expected` points, give or take at
/// most `slack`.
void expectStratified(const std::vector<RtFloat2>& points, unsigned columns, unsigned rows,
                      double expected, double slack) {
    const auto part = [](unsigned i, unsigned n) {
        return static_cast<float>(i) / static_cast<float>(n);
    };
    for (unsigned i = 0; i < columns; ++i) {
        for (unsigned j = 0; j < rows; ++j) {
            const RtFloat2 low(part(i, columns), part(j, rows));
            const RtFloat2 high(part(i + 1, columns), part(j + 1, rows));
            EXPECT_LT(std::fabs(countIn(points, low, high) - expected), slack)
                << "cell " << i << ' ' << j << " of " << columns << " x " << rows;
        }
    }
}

// The classic picture of two lights, one of which is chosen with a chance of 80%. The bounds follow
// from the net: of 1024 samples, any rows of height 2^-m hold one sample in each 2^(m-10) of the
// x axis, so an interval that begins at a multiple of that misses its share by less than 1, and any
// other by less than 2. Independent samples miss it by 10 and more. Guards against a remapping that
// folds, shuffles or draws again.
TEST(ChooseAndRemapTest, SubsetsOfStratifiedSamplesAreStratified) {
    for (unsigned patternid = 0; patternid < 50; ++patternid) {
        const TwoLights lights(patternid * 2654435761u, 0.8f);
        const double shares[] = {0.8 * 1024, 0.2 * 1024};
        for (unsigned light = 0; light < 2; ++light) {
            const auto& points = lights.subset[light];
            expectStratified(points, 1, 1, shares[light], 1.0);
            for (const unsigned k : {2u, 4u, 8u, 16u, 32u, 64u}) {
                expectStratified(points, 1, k, shares[light] / k, 1.0);
                expectStratified(points, k, 1, shares[light] / k, 2.0);
            }
            for (const unsigned k : {2u, 4u, 8u}) {
                expectStratified(points, k, k, shares[light] / (k * k), 2.0);
            }
        }
    }
}

// A chain of choices, as a light tree makes them, against one choice among all leaves.
TEST(ChooseAndRemapTest, ChoicesCanBeChained) {
    const float leaves[] = {0.28f, 0.12f, 0.15f, 0.45f};
    unsigned counts[4] = {};
    const unsigned samples = 1u << 16;
    for (unsigned k = 0; k < samples; ++k) {
        float xi = (static_cast<float>(k) + 0.5f) / samples;
        const unsigned branch = RixChooseAndRemap(xi, 0.4f);
        const unsigned leaf = RixChooseAndRemap(xi, branch == 0 ? 0.7f : 0.25f);
        ASSERT_TRUE(inUnitInterval(xi));
        ++counts[2 * branch + leaf];
    }
    for (unsigned i = 0; i < 4; ++i) EXPECT_NEAR(counts[i], leaves[i] * samples, 2.0f);
}

std::vector<RtNormal3> testNormals() {
    std::vector<RtNormal3> normals = {{0.0f, 0.0f, 1.0f},
                                      {0.0f, 0.0f, -1.0f},
                                      {1.0f, 0.0f, 0.0f},
                                      {0.0f, -1.0f, 0.0f},
                                      {1e-5f, -1e-5f, -1.0f},
                                      {0.6f, -0.48f, 0.64f},
                                      {-0.57735f, -0.57735f, -0.57735f}};
    for (RtNormal3& normal : normals) normal.Normalize();
    return normals;
}

const std::vector<float> kEdges = {0.0f, 0x1p-24f, 0.25f, 0.5f, 0.75f, kLargest};

using Distribution = void (*)(RtFloat2 const&, RtNormal3 const&, RtVector3&, RtFloat&);

// Guards against directions below the surface, and a cosine that is not that of the direction.
TEST(DirectionalDistributionTest, DirectionsAreAboveTheNormal) {
    for (const Distribution distribution : {Distribution(RixCosDirectionalDistribution),
                                            Distribution(RixUniformDirectionalDistribution)}) {
        for (const RtNormal3& normal : testNormals()) {
            for (const float x : kEdges) {
                for (const float y : kEdges) {
                    RtVector3 direction;
                    RtFloat cosTheta = -1.0f;
                    distribution({x, y}, normal, direction, cosTheta);
                    EXPECT_NEAR(direction.Length(), 1.0f, 1e-6f);
                    EXPECT_GT(cosTheta, 0.0f);
                    EXPECT_LE(cosTheta, 1.0f);
                    EXPECT_NEAR(cosTheta, direction.Dot(normal), 1e-6f);
                }
            }
        }
    }
}

// Moments of the cosine: 2/3 and 1/2 where it is the weight, 1/2 and 1/3 where nothing is. Both
// azimuths average out. 4096 stratified samples are within 1e-3.
TEST(DirectionalDistributionTest, MomentsAreRight) {
    struct Case {
        Distribution distribution;
        double mean, meanSquare;
    };
    const RtNormal3 normal(0.6f, -0.48f, 0.64f);
    for (const Case& c : {Case{RixCosDirectionalDistribution, 2.0 / 3.0, 0.5},
                          Case{RixUniformDirectionalDistribution, 0.5, 1.0 / 3.0}}) {
        const unsigned samples = 4096;
        double sum = 0.0, sumSquares = 0.0;
        RtVector3 sideways(0.0f);
        for (unsigned k = 0; k < samples; ++k) {
            RixRNG::SampleCtx context{17, k};
            RtVector3 direction;
            RtFloat cosTheta;
            c.distribution(RixRNG(&context, 1).DrawSample2D(0), normal, direction, cosTheta);
            sum += double(cosTheta);
            sumSquares += double(cosTheta) * double(cosTheta);
            sideways += direction - normal * cosTheta;
        }
        EXPECT_NEAR(sum / samples, c.mean, 1e-3);
        EXPECT_NEAR(sumSquares / samples, c.meanSquare, 1e-3);
        EXPECT_LT(sideways.Length() / samples, 1e-3f);
    }
}

// A caller that squares xi.y to favor the horizon relies on which coordinate is the cosine.
TEST(DirectionalDistributionTest, UniformTakesTheCosineFromY) {
    for (const float y : {0x1p-20f, 0.125f, 0.5f, kLargest}) {
        RtVector3 direction;
        RtFloat cosTheta;
        RixUniformDirectionalDistribution({0.3f, y}, {0.0f, 0.0f, 1.0f}, direction, cosTheta);
        EXPECT_EQ(cosTheta, y);
    }
}

TEST(DirectionalDistributionTest, TangentsSetTheFrame) {
    const RtNormal3 normal(0.0f, 0.0f, 1.0f);
    const RtVector3 tangent(0.0f, 1.0f, 0.0f), bitangent(-1.0f, 0.0f, 0.0f);
    RtVector3 direction;
    RtFloat cosTheta;
    RixUniformDirectionalDistribution({0.0f, 0.6f}, normal, tangent, bitangent, direction,
                                      cosTheta);
    EXPECT_LT((direction - RtVector3(0.0f, 0.8f, 0.6f)).Length(), 1e-6f);
    RixCosDirectionalDistribution({0.9f, 0.5f}, normal, tangent, bitangent, direction, cosTheta);
    EXPECT_LT((direction - RtVector3(0.0f, 0.8f, 0.6f)).Length(), 1e-6f);
}

TEST(ShadingUtilsTest, SinCos) {
    for (const RtFloat angle : {-7.0f, 0.0f, F_PIDIV4, 2.0f, F_TWOPI}) {
        RtFloat sine, cosine;
        RixSinCos(angle, &sine, &cosine);
        EXPECT_FLOAT_EQ(sine, std::sin(angle));
        EXPECT_FLOAT_EQ(cosine, std::cos(angle));
    }
}

TEST(ShadingUtilsTest, Constants) {
    const double pi = std::acos(-1.0);
    EXPECT_EQ(F_PI, static_cast<float>(pi));
    EXPECT_EQ(F_TWOPI, static_cast<float>(2.0 * pi));
    EXPECT_EQ(F_PIDIV2, static_cast<float>(pi / 2.0));
    EXPECT_EQ(F_PIDIV4, static_cast<float>(pi / 4.0));
    EXPECT_EQ(F_INVPI, static_cast<float>(1.0 / pi));
    EXPECT_EQ(F_INVTWOPI, static_cast<float>(0.5 / pi));
    EXPECT_EQ(F_INVFOURPI, static_cast<float>(0.25 / pi));
}

TEST(ShadingUtilsTest, ForwardFacingNormalAndReflection) {
    const RtVector3 view(0.6f, 0.0f, 0.8f);
    const RtNormal3 up(0.0f, 0.0f, 1.0f);
    for (const RtNormal3& normal : {up, -up}) {
        RtFloat cosView = 0.0f;
        EXPECT_EQ(RixGetForwardFacingNormal(view, normal, &cosView), up);
        EXPECT_FLOAT_EQ(cosView, 0.8f);
    }
    EXPECT_LT((RixReflect(view, up) - RtVector3(-0.6f, 0.0f, 0.8f)).Length(), 1e-6f);
}

// The frame must stay orthonormal and right-handed all over the sphere, also near -z, where the
// formula of Frisvad 2012 breaks down.
TEST(VectorTest, BasisIsOrthonormal) {
    std::vector<RtVector3> directions = testNormals();
    std::mt19937 random(5);
    std::normal_distribution<float> gauss;
    for (int k = 0; k < 10000; ++k) {
        const float x = gauss(random), y = gauss(random);
        RtVector3 d(x, y, gauss(random));
        d.Normalize();
        directions.push_back(d);
    }
    for (const RtVector3& d : directions) {
        RtVector3 u, v;
        d.CreateOrthonormalBasis(u, v);
        ASSERT_NEAR(u.Length(), 1.0f, 1e-6f);
        ASSERT_NEAR(v.Length(), 1.0f, 1e-6f);
        ASSERT_LT((Cross(u, v) - d).Length(), 1e-6f);
    }
}

TEST(VectorTest, IndexingAndNormalizing) {
    RtFloat2 p(1.0f, 2.0f);
    p[1] = 5.0f;
    EXPECT_EQ(p, RtFloat2(1.0f, 5.0f));
    EXPECT_EQ(p[0], 1.0f);
    RtVector3 v(3.0f, 0.0f, 0.0f);
    v[2] = 4.0f;
    EXPECT_EQ(v[2], 4.0f);
    EXPECT_EQ(v.Normalize(), 5.0f);
    EXPECT_LT((v - RtVector3(0.6f, 0.0f, 0.8f)).Length(), 1e-6f);
    RtVector3 zero(0.0f);
    EXPECT_EQ(zero.Normalize(), 0.0f);
    EXPECT_EQ(zero, RtVector3(0.0f));
}

TEST(ColorTest, ArithmeticAndChannels) {
    RtColorRGB color = RtColorRGB(0.25f, 0.5f, 1.0f) * 2.0f + RtColorRGB(0.5f);
    EXPECT_EQ(color, RtColorRGB(1.0f, 1.5f, 2.5f));
    EXPECT_EQ(color.ChannelMin(), 1.0f);
    EXPECT_EQ(color.ChannelMax(), 2.5f);
    EXPECT_FLOAT_EQ(color.ChannelAvg(), 5.0f / 3.0f);
    EXPECT_FALSE(color.IsBlack());
    color -= RtColorRGB(1.0f, 1.5f, 2.5f);
    EXPECT_TRUE(color.IsBlack());
    EXPECT_FALSE(RtColorRGB(0.0f, 0.0f, 1e-30f).IsBlack());
}

} // namespace
