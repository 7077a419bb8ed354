// SPDX-License-Identifier: Apache-2.0
//
// Samples whose most important domains are stratified together.
//
// Domains that are drawn from the tables alone are only as good together as random pairing. An
// integrator that sets a JointProgressive on its camera RixRNG may mark up to 16 domains of a path,
// wherever they are derived, and these are stratified against each other as well:
//
//     const wellstrat::JointProgressive joint;
//     RixRNG camera(contexts, numPts, &joint);
//     RixRNG lens(camera, wellstrat::jointScramble(0), lensContexts);
//     RixRNG bxdf(camera, kBxdfScramble, bxdfContexts);                      // padded
//     RixRNG direction(bxdf, wellstrat::jointScramble(1), directionContexts);
//
// Each slot by itself keeps every promise of the tables' samples (under splits, if they are powers
// of two). The first 4 slots are held to the strictest standard together, whatever of 1D, 2D and 3D
// is drawn from them, and the first 8 to a stricter one than all 16: give low slots to the domains
// that matter most, and use each slot once on a path. What is gained is measured in docs/joint.md;
// the samples are defined in joint_lookup.h.

#pragma once

#include "wellstrat/batch.h"
#include "wellstrat/generator.h"
#include "wellstrat/joint_lookup.h"

namespace wellstrat {
inline namespace stream1 {

/// The generator of jointly stratified samples. It has no state, so all of them are alike;
/// constructing one costs nothing, and they may be used in any thread.
///
/// How a domain draws whose RixRNG has this generator, by its order (order.h):
///
///     by jointScramble(slot)           from the slot; by another scramble: as without a generator
///     split by n                       as above, if all splits make up 1 to kMaxJointSplit
///     branches otherwise, and by distribution   as without a generator, and so do all its children
///     RixRNG(parent, indices, n, contexts)      as its parent, some points of which it is
///     RixRNG(parent, contexts, n)               as without a generator
///
/// No other domain inherits a slot. To draw one slot through two different domains for one sample
/// of the camera is a mistake, by which the two are correlated; a DomainLinter finds it.
class WELLSTRAT_API JointProgressive final : public OrderedGenerator {
public:
    constexpr JointProgressive() : OrderedGenerator(Source::tables) {}
    ~JointProgressive() override;

    float OrderedSample1D(const SampleCtx& sc, unsigned i, Order order) const override;
    Float2 OrderedSample2D(const SampleCtx& sc, unsigned i, Order order) const override;
    Float3 OrderedSample3D(const SampleCtx& sc, unsigned i, Order order) const override;
    void MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                              float* xis) const override;
    void MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                              Float2* xis) const override;
    void MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                              Float3* xis) const override;
};

} // namespace stream1
} // namespace wellstrat
