// SPDX-License-Identifier: Apache-2.0
//
// Frames of a sequence, as averages over time show them: each has few samples of a function that
// changes slowly, and what is seen is the exponential average of the frames. Sampleids that go on
// from frame to frame without gaps, a running sum, make the last frames together a piece of one
// stratified sequence. Frames with patterns of their own have nothing of that, nor have frames of
// one pattern with gaps between them: with slots, whose order all patterns share, those are worse
// than independent ones.
//
// False alarms: a ratio of errors must be seven of its standard errors, known from the spread over
// the pixels, on its side of the limit. Where the true ratio is further from the limit by another
// six, as those in docs/concepts.md are, a check fails by chance with a probability below 10^-8;
// there are 46.

#include "RixRNG.h"
#include "wellstrat/blue.h"
#include "wellstrat/camera.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <ostream>
#include <string>
#include <vector>

namespace {

using namespace wellstrat;

constexpr unsigned kPixels = 2000;
constexpr unsigned kFrames = 192, kFirstSeen = 64; // by then nothing is left of the first frame
constexpr double kNewest = 0.1;                    // the weight of the newest frame
constexpr double kStandardErrors = 7;

/// Functions on the unit square that change with the time t in [0, 1), and their integrals.
struct Moving {
    double (*value)(Float2 p, double t);
    double (*integral)(double t);
};

double edge(Float2 p, double t) { return p.y < 0.1 + 0.3 * t + 0.4 * double{p.x} ? 1 : 0; }
double edgeIntegral(double t) { return 0.3 + 0.3 * t; }

double bump(Float2 p, double t) {
    return std::exp(-2 * (std::pow(p.x - t, 2) + std::pow(p.y - 0.3, 2)));
}
double bumpSide(double middle) {
    const double root2 = std::sqrt(2.0);
    return std::sqrt(3.14159265358979324 / 8) *
           (std::erf(root2 * (1 - middle)) + std::erf(root2 * middle));
}
double bumpIntegral(double t) { return bumpSide(t) * bumpSide(0.3); }

double ramp(Float2 p, double t) { return p.x * p.y * (1 + t) + p.x * t; }
double rampIntegral(double t) { return 0.25 * (1 + t) + 0.5 * t; }

constexpr Moving kMoving[] = {{edge, edgeIntegral}, {bump, bumpIntegral}, {ramp, rampIntegral}};

/// The place of sample `i` of a frame after `before` samples of others.
struct Place {
    unsigned seed, sampleid;
};
using Rule = std::function<Place(unsigned frame, unsigned before, unsigned i)>;

Place goingOn(unsigned /*frame*/, unsigned before, unsigned i) { return {0, before + i}; }
Place independent(unsigned frame, unsigned /*before*/, unsigned i) { return {frame, i}; }
/// As if each frame had `stride` samples, of which only the first ones are taken.
Rule withGaps(unsigned stride) {
    return [stride](unsigned frame, unsigned /*before*/, unsigned i) {
        return Place{0, frame * stride + i};
    };
}

/// The context of one pixel of many, which are far apart: neighbors may know of each other.
SampleCtx contextOf(const Generator* generator, unsigned pixel, Place place) {
    const int x = 64 * static_cast<int>(pixel % 64), y = 64 * static_cast<int>(pixel / 64);
    return generator != nullptr ? generator->CameraContext(x, y, place.seed, place.sampleid)
                                : cameraContext(x, y, place.seed, place.sampleid);
}

/// How many samples a frame has.
using Counts = unsigned (*)(unsigned frame);

struct Case {
    const char* name;
    const Generator* generator;
    bool twoDomains; ///< the product over two domains, else the value in one
    Counts counts;
    unsigned stride;        ///< of the frames with gaps
    double goingOnAtMost;   ///< of the error of independent frames
    double withGapsAtLeast; ///< likewise
};

std::ostream& operator<<(std::ostream& out, const Case& c) { return out << c.name; }

/// The squared error of the average in each pixel, over the frames that are seen and the functions,
/// each in units of its integral. Frames count by their samples: numerator and denominator of the
/// mean are averaged apart, here for the difference to the right value.
std::vector<double> squaredErrors(const Case& c, const Rule& rule, double newest = kNewest) {
    std::vector<SampleCtx> camera(kPixels), first(kPixels), second(kPixels);
    std::vector<Float2> xiFirst(kPixels), xiSecond(kPixels);
    constexpr std::size_t kFunctions = std::size(kMoving);
    std::vector<std::array<double, kFunctions>> averages(kPixels);
    std::array<double, kFunctions> exact{};
    std::vector<double> errors(kPixels, 0.0);
    unsigned before = 0; // samples of the frames before this one
    for (unsigned frame = 0; frame < kFrames; ++frame) {
        const double t = double(frame) / kFrames;
        const unsigned count = c.counts(frame);
        for (auto& average : averages)
            for (double& a : average) a *= 1 - newest;
        for (unsigned i = 0; i < count; ++i) {
            for (unsigned p = 0; p < kPixels; ++p) {
                camera[p] = contextOf(c.generator, p, rule(frame, before, i));
            }
            const RixRNG rng(camera.data(), kPixels, c.generator);
            RixRNG(rng, jointScramble(0), first).DrawSamples2D(xiFirst);
            RixRNG(rng, jointScramble(1), second).DrawSamples2D(xiSecond);
            for (unsigned p = 0; p < kPixels; ++p) {
                for (std::size_t f = 0; f < kFunctions; ++f) {
                    double value = kMoving[f].value(xiFirst[p], t);
                    if (c.twoDomains) value *= kMoving[f].value(xiSecond[p], t);
                    averages[p][f] += newest * value;
                }
            }
        }
        before += count;
        for (std::size_t f = 0; f < kFunctions; ++f) {
            const double integral = kMoving[f].integral(t);
            const double right = c.twoDomains ? integral * integral : integral;
            exact[f] += newest * (count * right - exact[f]);
        }
        if (frame < kFirstSeen) continue;
        for (unsigned p = 0; p < kPixels; ++p)
            for (std::size_t f = 0; f < kFunctions; ++f)
                errors[p] += std::pow(averages[p][f] / exact[f] - 1, 2);
    }
    return errors;
}

struct Ratio {
    double value, standardError;
};

/// The root of the quotient of two sums, from pairs of terms of independent pixels.
Ratio rootOfQuotient(const std::vector<double>& a, const std::vector<double>& b) {
    const double sumA = std::accumulate(a.begin(), a.end(), 0.0);
    const double sumB = std::accumulate(b.begin(), b.end(), 0.0);
    const double quotient = sumA / sumB;
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(a[i] - quotient * b[i], 2);
    const double error = std::sqrt(squares) / sumB; // of the quotient
    return {std::sqrt(quotient), error / (2 * std::sqrt(quotient))};
}

class Frames : public testing::TestWithParam<Case> {};

TEST_P(Frames, GoOnWithoutGaps) {
    const Case& c = GetParam();
    const std::vector<double> base = squaredErrors(c, independent);
    const Ratio on = rootOfQuotient(squaredErrors(c, goingOn), base);
    EXPECT_LT(on.value + kStandardErrors * on.standardError, c.goingOnAtMost)
        << on.value << " +- " << on.standardError;
    const Ratio gaps = rootOfQuotient(squaredErrors(c, withGaps(c.stride)), base);
    EXPECT_GT(gaps.value - kStandardErrors * gaps.standardError, c.withGapsAtLeast)
        << gaps.value << " +- " << gaps.standardError;
}

const JointProgressive kJoint;
const LongProgressive kLong;
const BlueProgressive kBlue;

template <unsigned count>
unsigned always(unsigned /*frame*/) {
    return count;
}
unsigned changing(unsigned frame) { return 1 + frame % 4; }

INSTANTIATE_TEST_SUITE_P(
    Rules, Frames,
    testing::Values(Case{"padded_1", nullptr, false, always<1>, 2, 0.55, 0.9},
                    Case{"padded_3", nullptr, false, always<3>, 4, 0.55, 0.8},
                    Case{"padded_4", nullptr, false, always<4>, 5, 0.65, 1.0},
                    Case{"padded_changing", nullptr, false, changing, 4, 0.65, 0.8},
                    Case{"two_padded_1", nullptr, true, always<1>, 2, 0.85, 0.9},
                    Case{"two_padded_3", nullptr, true, always<3>, 4, 0.9, 0.88},
                    Case{"slot_1", &kJoint, false, always<1>, 2, 0.55, 2.0},
                    Case{"slot_3", &kJoint, false, always<3>, 4, 0.55, 2.0},
                    Case{"slot_changing", &kJoint, false, changing, 4, 0.65, 1.3},
                    Case{"two_slots_1", &kJoint, true, always<1>, 2, 0.75, 1.4},
                    Case{"two_slots_3", &kJoint, true, always<3>, 4, 0.75, 1.1},
                    Case{"long_1", &kLong, false, always<1>, 2, 0.55, 2.0},
                    Case{"two_long_3", &kLong, true, always<3>, 4, 0.75, 1.1},
                    Case{"blue_1", &kBlue, false, always<1>, 2, 0.55, 2.0},
                    Case{"two_blue_3", &kBlue, true, always<3>, 4, 0.75, 1.1}),
    [](const auto& test) { return std::string(test.param.name); });

/// Frames that nobody averages lose nothing where their count is a power of two, and little else.
TEST(Frame, AloneIsAsGoodAsFromSampleZero) {
    struct Limit {
        Counts counts;
        double atMost;
    };
    const Generator* const generators[] = {nullptr, &kJoint, &kLong, &kBlue};
    const Limit limits[] = {
        {always<1>, 1.05}, {always<4>, 1.05}, {always<8>, 1.05}, {always<6>, 1.15}};
    for (const Generator* const generator : generators) {
        for (const Limit& limit : limits) {
            const Case c{"", generator, false, limit.counts, 0, 0, 0};
            const Ratio ratio =
                rootOfQuotient(squaredErrors(c, goingOn, 1), squaredErrors(c, independent, 1));
            EXPECT_LT(ratio.value + kStandardErrors * ratio.standardError, limit.atMost);
        }
    }
}

} // namespace
