// SPDX-License-Identifier: Apache-2.0
//
// Bxdfs: values against textbook formulas, directions against their density, and no bad numbers.

#include "renderer/bxdf.h"

#include "bxdf_reference.h"
#include "statistical/statistics.h"

#include <RixRNG.h>
#include <RixShadingUtils.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace wellstrat::render {
namespace {

const Float3 kNormal(0, 0, 1);

Material material(float metallic, float roughness, float specularF0 = 0.04f) {
    Material result;
    result.baseColor = {0.9f, 0.6f, 0.3f};
    result.metallic = metallic;
    result.roughness = roughness;
    result.specularF0 = specularF0;
    return result;
}

std::vector<Material> materials() {
    return {material(0, 1, 0),    material(0, 0.5f), material(0, 1),
            material(0.5f, 0.4f), material(1, 0.3f), material(1, 1)};
}

Float3 directionAt(float angle, float turn = 0) {
    return {std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn), std::cos(angle)};
}

Bxdf flatBxdf(const Material& m, Float3 view) {
    return {bxdfParameters(m, {}), kNormal, kNormal, view};
}

/// The value must be the lobes' sum times the cosine, and the same the other way round.
TEST(Bxdf, IsTheSumOfItsLobesAndReciprocal) {
    for (const Material& m : materials()) {
        for (const float outAngle : {0.0f, 0.7f, 1.4f}) {
            for (const float inAngle : {0.1f, 0.7f, 1.3f}) {
                for (const float turn : {0.0f, 1.0f, 3.0f}) {
                    const Float3 out = directionAt(outAngle);
                    const Float3 in = directionAt(inAngle, turn);
                    const Float3 there = flatBxdf(m, out).evaluate(in).value / in.z;
                    const Float3 back = flatBxdf(m, in).evaluate(out).value / out.z;
                    for (int c = 0; c < 3; ++c) {
                        const reference::Direction o{out.x, out.y, out.z}, i{in.x, in.y, in.z};
                        const double expected =
                            reference::diffuse(m, c, i, o) + reference::specular(m, c, i, o);
                        EXPECT_NEAR(there[c], expected, 1e-4 * expected);
                        EXPECT_NEAR(there[c], back[c], 1e-4 * expected);
                    }
                }
            }
        }
    }
}

/// A cell of the sphere: 16 bands of equal height, 16 azimuths.
unsigned cellOf(Float3 d) {
    const Float2 square = sphereToSquare(d);
    return static_cast<unsigned>(square.x * 16) * 16 + static_cast<unsigned>(square.y * 16);
}

/// Those that let light pass, too.
std::vector<Material> allMaterials() {
    std::vector<Material> all = materials();
    for (Material m : {material(0, 0.7f), material(0.3f, 0.6f), material(0, 0.5f)}) {
        m.transmission = 0.75f;
        m.isSolid = m.metallic == 0;
        m.ior = m.roughness == 0.5f ? 1.33f : 1.5f;
        all.push_back(m);
    }
    return all;
}

/// Guards against a density that is not that of the directions: chi-square of independent
/// directions over 256 cells of the sphere and one for those that were refused, against the pdf,
/// summed over a grid in each cell.
TEST(Bxdf, ChoosesDirectionsWithItsPdf) {
    constexpr unsigned kSamples = 200000;
    constexpr int kGrid = 48;
    for (const Material& m : allMaterials()) {
        for (const float angle : {0.2f, 1.2f, 2.1f}) {
            const Bxdf bxdf = flatBxdf(m, directionAt(angle, 2.0f));
            std::vector<double> expected(257, 0.0);
            double total = 0;
            for (int i = 0; i < 16 * kGrid; ++i) {
                for (int j = 0; j < 16 * kGrid; ++j) {
                    const Float3 d =
                        squareToSphere({(static_cast<float>(i) + 0.5f) / (16 * kGrid),
                                        (static_cast<float>(j) + 0.5f) / (16 * kGrid)});
                    const double mass = 4.0 * double{F_PI} * bxdf.evaluate(d).pdf /
                                        (256 * kGrid * kGrid) * kSamples;
                    expected[cellOf(d)] += mass;
                    total += mass;
                }
            }
            // What GGX reflects below the surface or does not refract is refused.
            EXPECT_LE(total, kSamples * 1.002);
            expected[256] = std::max(0.0, kSamples - total);
            std::vector<uint32_t> counts(257, 0);
            for (unsigned i = 0; i < kSamples; ++i) {
                const Float3 xi = randomSample3D(7, i);
                BxdfSample sample;
                const bool found = bxdf.sample({xi.x, xi.y}, sample);
                ++counts[found ? cellOf(sample.direction) : 256];
                if (!found) continue;
                const BxdfValue value = bxdf.evaluate(sample.direction);
                // Microfacets that refract are known less precisely from where they refract to.
                const double tolerance = bxdf.passes(sample.direction) ? 2e-2 : 2e-3;
                EXPECT_NEAR(value.pdf / sample.pdf, 1, tolerance);
                EXPECT_NEAR(value.value.x / (sample.weight.x * sample.pdf), 1, tolerance);
            }
            // Cells of few expected counts together, by Cochran's rule of at least 5.
            std::vector<double> expectedMerged{0};
            std::vector<uint32_t> countsMerged{0};
            for (std::size_t i = 0; i < 257; ++i) {
                const bool few = expected[i] < 5;
                if (few) {
                    expectedMerged[0] += expected[i];
                    countsMerged[0] += counts[i];
                } else {
                    expectedMerged.push_back(expected[i]);
                    countsMerged.push_back(counts[i]);
                }
            }
            expectedMerged[0] += 1e-9;
            if (expectedMerged[0] < 5) {
                EXPECT_LT(countsMerged[0], 40u);
                countsMerged[0] = 0;
            }
            EXPECT_GE(statistical::chiSquareTail(countsMerged, expectedMerged), statistical::kAlpha)
                << m.metallic << " " << m.roughness << " " << angle;
        }
    }
}

/// Guards against a lobe choice that tears strata apart: of 2^16 stratified samples of a Lambertian
/// surface each of 256 cells of equal probability gets its share.
TEST(Bxdf, KeepsStrata) {
    const Bxdf bxdf = flatBxdf(material(0, 1, 0), kNormal);
    std::vector<unsigned> counts(256, 0);
    for (unsigned i = 0; i < 4096; ++i) {
        BxdfSample sample;
        ASSERT_TRUE(bxdf.sample(sample2D(3, i), sample));
        const Float2 square = hemisphereCosineToSquare(sample.direction);
        ++counts[static_cast<unsigned>(square.x * 16) * 16 + static_cast<unsigned>(square.y * 16)];
    }
    for (const unsigned count : counts) EXPECT_NEAR(count, 16, 2);
}

/// Fuzz of all that a scene may hold: colors above 1, NaN, normals that disagree, grazing views.
/// And no light passes through a surface that lets none pass.
TEST(Bxdf, NeverGivesBadNumbers) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    const float odd[] = {0, 1, 0.5f, -1, 2, 1e30f, 1e-30f, kNan};
    unsigned found = 0;
    for (unsigned i = 0; i < 200000; ++i) {
        const auto pick = [i](unsigned k) { return HashToUnsigned(i, k); };
        const auto oddOr = [&](unsigned k) {
            return pick(k) % 4 == 0 ? odd[pick(k + 100) % 8] : HashToRandom(i, k);
        };
        Material m;
        m.baseColor = {oddOr(0), oddOr(1), oddOr(2)};
        m.metallic = oddOr(3);
        m.roughness = oddOr(4);
        m.specularF0 = oddOr(5);
        const bool letsPass = pick(18) % 2 == 0;
        if (letsPass) {
            m.transmission = oddOr(19);
            m.ior = pick(20) % 2 == 0 ? 1 + HashToRandom(i, 21) : oddOr(21);
            m.isSolid = pick(22) % 2 == 0;
        }
        const Float3 geometric = squareToSphere({HashToRandom(i, 6), HashToRandom(i, 7)});
        Float3 shading = squareToSphere({HashToRandom(i, 8), HashToRandom(i, 9)});
        if (pick(10) % 2) shading = geometric;
        Float3 view = squareToSphere({HashToRandom(i, 11), HashToRandom(i, 12)});
        if (pick(13) % 4 == 0) { // at a right angle, about
            view = view - geometric * Dot(view, geometric);
            view.Normalize();
        }
        const Bxdf bxdf(bxdfParameters(m, {}), geometric, shading, view);
        const Float3 in = squareToSphere({HashToRandom(i, 14), HashToRandom(i, 15)});
        const BxdfValue value = bxdf.evaluate(in);
        const float sum = value.value.x + value.value.y + value.value.z;
        EXPECT_TRUE(std::isfinite(value.pdf) && value.pdf >= 0) << i;
        EXPECT_TRUE(std::isfinite(sum) && sum >= 0) << i;
        const Float3 facing = Dot(geometric, view) < 0 ? -geometric : geometric;
        if (Dot(facing, in) < 0 && !letsPass) {
            EXPECT_EQ(sum, 0) << i;
        }
        BxdfSample sample;
        if (!bxdf.sample({HashToRandom(i, 16), HashToRandom(i, 17)}, sample)) continue;
        ++found;
        EXPECT_TRUE(std::isfinite(sample.pdf) && sample.pdf > 0) << i;
        EXPECT_NEAR(sample.direction.Length(), 1, 1e-5) << i;
        if (!letsPass) {
            EXPECT_GT(Dot(facing, sample.direction), 0) << i;
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_TRUE(sample.weight[c] >= 0 && sample.weight[c] < (letsPass ? 64 : 8)) << i;
        }
    }
    EXPECT_GT(found, 50000u);
}

} // namespace
} // namespace wellstrat::render
