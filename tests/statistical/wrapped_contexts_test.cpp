// SPDX-License-Identifier: Apache-2.0
//
// The pattern of the interface's documentation: an integrator wraps an array of its own in a RixRNG
// made from a parent, and fills it one by one with new domains of the parent's points. Products of
// what the two draw must converge as without a generator, whatever the generator and the parent's
// domain are. Guards against a wrapped array that draws in the order of its parent's slot, in
// lockstep with it, and against slots below it that do not know of splits or distributions above.

#include "RixRNG.h"
#include "wellstrat/blue.h"
#include "wellstrat/domain_linter.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace {

using SampleCtx = RixRNG::SampleCtx;
using Scramble = RixRNG::Scramble;

constexpr Scramble kChild{0x8732f9a1};
constexpr unsigned kPoints = 256;
constexpr unsigned kPatterns = 300;
constexpr double kPi = 3.14159265358979323846;

double inDisk(RtFloat2 xi) { return xi.x * xi.x + xi.y * xi.y < 1.0f ? 1 : 0; }

/// The points of the parent in another order.
unsigned indexOf(unsigned point) { return (point * 77 + 13) % kPoints; }

enum class Parent { camera, ordinary, slot, splitSlot };
enum class Fill { byParent, byContext };

/// The error of the quarter disk's area squared, one factor drawn from the parent's domain and one
/// from its wrapped child's, by all samples of a pattern.
double errorOf(const RixRNG::Generator* generator, Parent kind, Fill fill, unsigned split,
               unsigned pattern) {
    std::vector<SampleCtx> camera(kPoints), own(kPoints), wrapped(kPoints);
    for (unsigned i = 0; i < kPoints; ++i) camera[i] = {HashToUnsigned(9, pattern), i};
    RixRNG parent(camera, kPoints, generator);
    switch (kind) {
    case Parent::camera: break;
    case Parent::ordinary: parent = RixRNG(parent, Scramble{0x2d96c92b}, own); break;
    case Parent::slot: parent = RixRNG(parent, wellstrat::jointScramble(0), own); break;
    case Parent::splitSlot:
        parent = RixRNG(parent, wellstrat::jointScramble(3), own, RixRNG::Split{2});
        break;
    }
    std::vector<RtFloat2> ofParent(kPoints), ofChild(kPoints);
    parent.DrawSamples2D(ofParent);

    RixRNG child(parent, wrapped, kPoints);
    for (unsigned pt = 0; pt < kPoints; ++pt) {
        const unsigned i = indexOf(pt);
        wrapped[pt] = fill == Fill::byParent
                          ? parent.NewDomainSplit(i, kChild, split)
                          : parent.sampleCtxArray[i].NewDomainSplit(kChild, split);
    }
    double sum = 0;
    for (unsigned branch = 0; branch < split; ++branch) {
        child.GenerateSamples2D(ofChild);
        for (unsigned pt = 0; pt < kPoints; ++pt) {
            sum += inDisk(ofParent[indexOf(pt)]) * inDisk(ofChild[pt]);
        }
    }
    return sum / (split * kPoints) - kPi * kPi / 16;
}

template <class Error>
double rmse(Error error) {
    double squares = 0;
    for (unsigned pattern = 0; pattern < kPatterns; ++pattern) {
        const double e = error(pattern);
        squares += e * e;
    }
    return std::sqrt(squares / kPatterns);
}

/// A ratio of two RMSE of so many patterns has a standard deviation of 6 %: 1.4 is six of them and
/// more above 1, so a false alarm has a probability below 10^-8. Lockstep has 1.8 and more in
/// slots.
constexpr double kRatio = 1.4;

const wellstrat::JointProgressive kJoint;
const wellstrat::LongProgressive kLong;
const wellstrat::BlueProgressive kBlue;
const std::pair<const char*, const RixRNG::Generator*> kGenerators[] = {
    {"joint", &kJoint}, {"long", &kLong}, {"blue", &kBlue}};

TEST(WrappedContexts, ConvergeForEveryGenerator) {
    for (const Parent kind : {Parent::camera, Parent::ordinary, Parent::slot, Parent::splitSlot}) {
        for (const Fill fill : {Fill::byParent, Fill::byContext}) {
            for (const unsigned split : {1u, 4u}) {
                const auto with = [&](const RixRNG::Generator* generator) {
                    return rmse(
                        [&](unsigned p) { return errorOf(generator, kind, fill, split, p); });
                };
                const double tables = with(nullptr);
                for (const auto& [name, generator] : kGenerators) {
                    EXPECT_LT(with(generator), kRatio * tables)
                        << name << " " << static_cast<int>(kind) << " " << static_cast<int>(fill)
                        << " split by " << split;
                }
            }
        }
    }
}

/// The linter passes on the samples of what it wraps, and random samples have an error of 0.0304.
TEST(WrappedContexts, ConvergeForOtherGenerators) {
    const wellstrat::RandomGenerator random;
    const wellstrat::DomainLinter linter(&kJoint);
    for (const Parent kind : {Parent::camera, Parent::slot}) {
        EXPECT_LT(rmse([&](unsigned p) { return errorOf(&random, kind, Fill::byParent, 1, p); }),
                  0.038);
        for (unsigned pattern = 0; pattern < 4; ++pattern) {
            EXPECT_EQ(errorOf(&linter, kind, Fill::byParent, 4, pattern),
                      errorOf(&kJoint, kind, Fill::byParent, 4, pattern));
        }
    }
}

/// Two domains of one path, of each of which an integrator wraps all points once more, and derives
/// slot `a` or `b` from there. `split` is 0 for distribution.
double errorBelowViews(const RixRNG::Generator* generator, unsigned split, unsigned a, unsigned b,
                       unsigned pattern) {
    const unsigned visits = split == 0 ? 1 : kPoints / split, branches = kPoints / visits;
    std::vector<RtFloat2> drawn[2];
    for (unsigned d = 0; d < 2; ++d) {
        std::vector<SampleCtx> camera(visits), children(visits), wrapped(kPoints), slot(kPoints);
        for (unsigned i = 0; i < visits; ++i) camera[i] = {HashToUnsigned(10, pattern), i};
        const RixRNG rng(camera, visits, generator);
        const Scramble scramble{0x2d96c92b + d};
        const RixRNG parent = split == 0 ? RixRNG(rng, scramble, children, RixRNG::Distrib{0})
                                         : RixRNG(rng, scramble, children, RixRNG::Split{split});
        for (unsigned i = 0; i < kPoints; ++i) {
            wrapped[i] = children[i / branches];
            wrapped[i].sampleid += i % branches;
        }
        const RixRNG view(parent, wrapped, kPoints);
        drawn[d].resize(kPoints);
        RixRNG(view, wellstrat::jointScramble(d == 0 ? a : b), slot).DrawSamples2D(drawn[d]);
    }
    double sum = 0;
    for (unsigned i = 0; i < kPoints; ++i) sum += inDisk(drawn[0][i]) * inDisk(drawn[1][i]);
    return sum / kPoints - kPi * kPi / 16;
}

TEST(WrappedContexts, SlotsBelowKnowOfSplitsAndDistributionsAbove) {
    struct {
        unsigned split, a, b;
    } const cases[] = {{0, 0, 0}, {0, 3, 5}, {2, 12, 1}, {8, 7, 15}, {1, 0, 1}};
    for (const auto& c : cases) {
        const auto with = [&](const RixRNG::Generator* generator) {
            return rmse(
                [&](unsigned p) { return errorBelowViews(generator, c.split, c.a, c.b, p); });
        };
        const double tables = with(nullptr);
        for (const auto& [name, generator] : kGenerators) {
            EXPECT_LT(with(generator), kRatio * tables)
                << name << " " << c.split << ": " << c.a << ", " << c.b;
        }
    }
}

} // namespace
