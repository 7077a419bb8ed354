// SPDX-License-Identifier: Apache-2.0
//
// Every generator renders, in the mean over seeds, the picture that the tables render: in each
// pixel of each built-in scene, and in all together, where a bias adds up that is small in each.
//
// The differences d of n seeds are independent, and as likely to have one sign as the other. So
// |sum of d| > t sqrt(sum of d d) has a probability of at most 2 exp(-t t / 2), whatever their
// sizes are (Hoeffding's inequality for the signs): nothing is too noisy for that. There are 23040
// checks of pixels at statistical::kAlpha, and 40 of whole pictures at 10^-6, so the chance of any
// false alarm is below 7 * 10^-5.

#include "rendering.h"

#include "renderer/builtin_scenes.h"
#include "wellstrat/blue.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"

#include <cmath>
#include <string>
#include <vector>

namespace wellstrat::render {
namespace {

constexpr unsigned kWidth = 16, kHeight = 12, kSeeds = 64;
constexpr unsigned kPixels = kWidth * kHeight, kValues = 3 * kPixels;

/// A picture of each seed, with `samples` samples per pixel.
std::vector<Film> pictures(const Scene& scene, const Generator* generator, unsigned samples) {
    std::vector<Film> films;
    SamplingOptions options;
    options.generator = generator;
    for (options.seed = 0; options.seed < kSeeds; ++options.seed) {
        const Renderer renderer(scene, kWidth, kHeight, options);
        films.emplace_back(kWidth, kHeight);
        renderer.render({0, kHeight, 0, samples}, films.back(), std::atomic<bool>{false},
                        [](uint64_t) {});
    }
    return films;
}

/// The differences of two pictures, channel by channel.
std::vector<double> difference(const Film& a, const Film& b) {
    std::vector<double> result;
    for (int channel = 0; channel < 3; ++channel) {
        const std::vector<double> ofA = meansOf(a, channel), ofB = meansOf(b, channel);
        for (std::size_t i = 0; i < ofA.size(); ++i) result.push_back(ofA[i] - ofB[i]);
    }
    return result;
}

struct Sums {
    double plain = 0, squares = 0;

    void add(double value) {
        plain += value;
        squares += value * value;
    }
    /// The probability that random signs of the values make their sum as far from 0, at most.
    double tail() const { return squares == 0 ? 1 : 2 * std::exp(-plain * plain / squares / 2); }
};

/// The differences from the tables' pictures, seed by seed.
std::vector<std::vector<double>> differences(const Scene& scene, const Generator* generator,
                                             unsigned samples) {
    const std::vector<Film> tables = pictures(scene, nullptr, samples);
    const std::vector<Film> films = pictures(scene, generator, samples);
    std::vector<std::vector<double>> result;
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        result.push_back(difference(films[seed], tables[seed]));
    }
    return result;
}

void expectNoneInAnyPixel(const std::vector<std::vector<double>>& bySeed) {
    for (unsigned i = 0; i < kValues; ++i) {
        Sums sums;
        for (const std::vector<double>& values : bySeed) sums.add(values[i]);
        EXPECT_GE(sums.tail(), statistical::kAlpha)
            << "pixel " << i % kPixels << ", channel " << i / kPixels;
    }
}

/// Some seeds say what the bias would be, and the others how much of it they have.
void expectNoneInTheWhole(const std::vector<std::vector<double>>& bySeed) {
    constexpr unsigned kFirst = kSeeds / 4;
    std::vector<Sums> first(kValues);
    for (unsigned seed = 0; seed < kFirst; ++seed) {
        for (unsigned i = 0; i < kValues; ++i) first[i].add(bySeed[seed][i]);
    }
    Sums sums;
    for (unsigned seed = kFirst; seed < kSeeds; ++seed) {
        double along = 0;
        for (unsigned i = 0; i < kValues; ++i) {
            if (first[i].squares == 0) continue;
            along += bySeed[seed][i] * first[i].plain / first[i].squares;
        }
        sums.add(along);
    }
    EXPECT_GE(sums.tail(), 1e-6);
}

struct Case {
    const char* name;
    const Generator* generator;
};

const RandomGenerator kRandom;
const JointProgressive kJoint;
const LongProgressive kLong;
const BlueProgressive kBlue;

class Bias : public ::testing::TestWithParam<Case> {};

TEST_P(Bias, IsNoneInBuiltinScenes) {
    for (const auto& info : builtinScenes()) {
        const Scene scene = builtinScene(info.name);
        // One sample, whose bias no strata hide, and for the same reason no power of two.
        for (const unsigned samples : {1u, 3u}) {
            SCOPED_TRACE(info.name + (", samples: " + std::to_string(samples)));
            const auto bySeed = differences(scene, GetParam().generator, samples);
            expectNoneInAnyPixel(bySeed);
            expectNoneInTheWhole(bySeed);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Generators, Bias,
                         ::testing::Values(Case{"random", &kRandom}, Case{"joint", &kJoint},
                                           Case{"long", &kLong}, Case{"blue", &kBlue}),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace wellstrat::render
