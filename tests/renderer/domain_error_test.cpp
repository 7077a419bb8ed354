// SPDX-License-Identifier: Apache-2.0
//
// What one domain makes of a picture's error, where it is known.

#include "rendering.h"

#include "renderer/domain_error.h"

#include <RixRNGProgressive.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace wellstrat::render {
namespace {

TEST(PathDomains, AreDifferentAndGoOnWithTheBounces) {
    std::set<RixRNG::Scramble> scrambles;
    std::set<std::string> names;
    const std::vector<PathDomain> domains = pathDomains(9);
    for (const PathDomain& domain : domains) {
        scrambles.insert(domain.scramble);
        names.insert(domain.name);
    }
    EXPECT_EQ(domains.size(), 3u + 3 * 10);
    EXPECT_EQ(scrambles.size(), domains.size());
    EXPECT_EQ(names.size(), domains.size());
    EXPECT_EQ(pathDomains(0).size(), 6u);
    EXPECT_EQ(pathDomains(0).back().name, "bxdf 0");
}

TEST(RenewedGenerator, KeepsOneDomainAndDrawsOtherPatternsElsewhere) {
    const RixRNG::Scramble kept{5}, other{6};
    const RenewedGenerator generator(kept), all({});
    const RixRNG::SampleCtx context{7, 3};
    const RtFloat2 anew = generator.Sample2D(context, 0), table = RixProgressiveSample2D(7, 3);
    EXPECT_NE(anew.x, table.x);
    EXPECT_EQ(anew.x, generator.Sample3D(context, 0).x);
    for (const unsigned split : {0u, 1u, 4u}) {
        const Order below = generator.ChildOrder({}, kept, split);
        EXPECT_EQ(generator.OrderedSample2D(context, 0, below), table);
        EXPECT_EQ(generator.OrderedSample2D(context, 0, generator.ChildOrder(below, other, split)),
                  table)
            << "the tables go on";
        EXPECT_EQ(generator.OrderedSample2D(context, 0, generator.ChildOrder({}, other, split)),
                  anew);
        EXPECT_EQ(all.OrderedSample2D(context, 0, all.ChildOrder({}, kept, split)), anew);
    }
}

Colors picture(const Scene& scene, SamplingOptions options, const Generator* generator) {
    options.generator = generator;
    return colorsOf(renderFilm(scene, 8, 16, options));
}

float largestDifference(const Colors& a, const Colors& b) {
    float largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::fabs(a[i] - b[i]));
    return largest;
}

/// The picture has its samples from domain `name`, and next to nothing from others.
void expectMadeBy(const std::string& name, const Scene& scene, const SamplingOptions& options) {
    const RenewedGenerator renewed({});
    const Colors original = picture(scene, options, nullptr);
    const Colors anew = picture(scene, options, &renewed);
    EXPECT_GT(largestDifference(original, anew), 1e-3f);
    for (const PathDomain& domain : pathDomains(options.depth)) {
        const RenewedGenerator generator(domain.scramble);
        EXPECT_LT(largestDifference(picture(scene, options, &generator),
                                    domain.name == name ? original : anew),
                  1e-5f)
            << domain.name;
    }
}

/// The edge of a lamp in view.
TEST(RenewedGenerator, SharesTheDomainThatMakesThePicture) {
    Scene lamp;
    addQuads(lamp, {rectangle({1, 0.1f, -5}, {1, 0.3f, 0}, {0, 1, 0})},
             addMaterial(lamp, emitter(Float3(1.0f))));
    lamp.camera = lookAt({0, 0, 0}, {0, 0, -5}, {0, 1, 0}, 0.3f);
    expectMadeBy("pixel filter", lamp, optionsOfDepth(1));
}

/// One point of a floor, lit by a lamp that takes light samples only.
TEST(RenewedGenerator, SharesTheDomainThatLightsThePicture) {
    Scene floor;
    addQuads(floor, {rectangle(Float3(0.0f), {0, 0, 3}, {3, 0, 0})},
             addMaterial(floor, lambertian(Float3(0.5f))));
    addQuads(floor, {rectangle({0, 1, 0}, {0.5f, 0, 0}, {0, 0, 0.5f})},
             addMaterial(floor, emitter(Float3(1.0f))));
    floor.camera = lookAt({0.2f, 0.5f, 0.9f}, {0.2f, 0, 0.3f}, {0, 1, 0}, 1e-5f);
    SamplingOptions options = optionsOfDepth(0);
    options.strategy = Strategy::lights;
    expectMadeBy("light 0", floor, options);
}

TEST(DomainError, CovarianceOfTwoPicturesByHand) {
    // Deviations from the means: 1 and 2 in the first pixel, 3 and 1 with opposite signs in the
    // second.
    const std::vector<Colors> a{{1, 1, 1, 6, 6, 6}, {3, 3, 3, 0, 0, 0}};
    const std::vector<Colors> b{{0, 0, 0, 4, 4, 4}, {4, 4, 4, 6, 6, 6}};
    EXPECT_EQ(covariance(a, b).value, (2 - 3) * 2 / 2.0);
    EXPECT_EQ(covariance(a, a).value, (1 + 9) * 2 / 2.0);
    EXPECT_EQ(covariance(a, a).standardError, 0);
}

/// Each color of each pixel is p + 2 q, of which pictures share p. Other seeds than this one would
/// fail once in 10^4 runs, as Student's t of 11 degrees of freedom says.
TEST(DomainError, CovarianceFindsThePartThatIsShared) {
    std::mt19937 random(1);
    std::normal_distribution<float> normal;
    constexpr std::size_t kPictures = 12, kPixels = 50;
    double squares = 0, sum = 0;
    constexpr int kRuns = 600;
    for (int run = 0; run < kRuns; ++run) {
        std::vector<Colors> a(kPictures, Colors(3 * kPixels)), b = a;
        for (std::size_t k = 0; k < kPictures; ++k) {
            for (std::size_t i = 0; i < 3 * kPixels; ++i) {
                const float shared = normal(random);
                a[k][i] = shared + 2 * normal(random);
                b[k][i] = shared + 2 * normal(random);
            }
        }
        const Measured part = covariance(a, b);
        const double z = (part.value - 1) / part.standardError;
        EXPECT_LT(std::fabs(z), 12);
        squares += z * z;
        sum += z;
    }
    EXPECT_LT(std::fabs(sum / kRuns), 5 / std::sqrt(double{kRuns}) * 1.2);
    EXPECT_NEAR(squares / kRuns, 11.0 / 9, 0.5); // its variance
}

} // namespace
} // namespace wellstrat::render
