// SPDX-License-Identifier: Apache-2.0
//
// The pattern of the interface's documentation: an integrator wraps an array of its own in a RixRNG
// made from a parent, and fills it one by one with new domains of the parent's points. Products of
// what the two draw must converge, whatever the generator and the parent's domain are. Guards
// against a wrapped array that draws in the order of its parent's slot, in lockstep with it: then
// the error stays at 0.09.

#include "RixRNG.h"
#include "wellstrat/domain_linter.h"
#include "wellstrat/joint.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <cmath>
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

/// Independent samples have 0.0304 for one branch, all others less; six standard deviations of the
/// measurement more is 0.038, so a false alarm has a probability below 10^-8.
TEST(WrappedContexts, ConvergeForEveryGenerator) {
    const wellstrat::RandomGenerator random;
    const wellstrat::JointProgressive joint;
    const wellstrat::DomainLinter linter(&joint);
    const RixRNG::Generator* const generators[] = {nullptr, &random, &joint, &linter};
    for (const RixRNG::Generator* generator : generators) {
        for (const Parent kind :
             {Parent::camera, Parent::ordinary, Parent::slot, Parent::splitSlot}) {
            for (const Fill fill : {Fill::byParent, Fill::byContext}) {
                for (const unsigned split : {1u, 4u}) {
                    const unsigned patterns = generator == &linter ? kPatterns / 10 : kPatterns;
                    double squares = 0;
                    for (unsigned pattern = 0; pattern < patterns; ++pattern) {
                        const double error = errorOf(generator, kind, fill, split, pattern);
                        squares += error * error;
                    }
                    const double bound = generator == &linter ? 0.055 : 0.038;
                    EXPECT_LT(std::sqrt(squares / patterns), bound)
                        << static_cast<int>(kind) << " " << static_cast<int>(fill) << " split by "
                        << split;
                }
            }
        }
    }
}

} // namespace
