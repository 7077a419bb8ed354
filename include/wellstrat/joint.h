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
// of two). Lower slots are better together, so give slot 0 to the domain that matters most, and use
// each slot once on a path. What is gained is measured in docs/joint.md; the samples are defined in
// joint_lookup.h.

#pragma once

#include "wellstrat/generator.h"
#include "wellstrat/joint_lookup.h"

#include <cstddef>

namespace wellstrat {
inline namespace stream1 {

namespace detail {
constexpr unsigned kJointScramble = 0x6a6f696eu; // "join"
} // namespace detail

/// The scramble that derives the domain of `slot`, in [0, kJointSlots). With a larger number it is
/// a scramble like any other, and marks no slot.
WELLSTRAT_HOST_DEVICE constexpr Scramble jointScramble(unsigned slot) {
    return static_cast<Scramble>(detail::kJointScramble + slot);
}

/// The generator of jointly stratified samples. All state is that of the domain: which slot it is,
/// if any, and the product of all splits since the camera. Constructing one costs nothing, all of
/// them are alike, and they may be used in any thread. Children are never freed.
///
/// How a domain that is derived from one with this generator draws:
///
///     by jointScramble(slot)           from the slot; by another scramble: as without a generator
///     RixRNG(parent, contexts, n)      as its parent, of which it is another view
///     split by n                       as above, if all splits make up 1 to kMaxJointSplit
///     branches otherwise, and by distribution   as without a generator, and so do all its children
///
/// No other domain inherits a slot. But a RixRNG(parent, contexts, n) whose contexts were filled
/// with NewDomain of a slot's contexts is another domain in the order of the slot: its samples and
/// the slot's are in lockstep. Make its generator with ForChild, as docs/api.md shows. Drawing one
/// slot through two different domains for one sample of the camera is a mistake, by which the two
/// are correlated. DomainLinter finds it (docs/linter.md).
class WELLSTRAT_API JointProgressive final : public Generator {
public:
    /// For a camera's RixRNG: padded samples itself.
    constexpr JointProgressive() : slot_(kJointSlots), split_(1) {}
    ~JointProgressive() override;

    float Sample1D(const SampleCtx& sc, unsigned i) const override;
    Float2 Sample2D(const SampleCtx& sc, unsigned i) const override;
    Float3 Sample3D(const SampleCtx& sc, unsigned i) const override;

    void MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const override;
    void MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const override;
    void MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const override;

    const Generator* ForChild(Scramble scramble, unsigned split) const override;

    /// The slot that this draws from, or kJointSlots if none.
    unsigned slot() const { return slot_; }
    /// The product of all splits since the camera, in [1, kMaxJointSplit].
    unsigned split() const { return split_; }

private:
    class Children;

    unsigned slot_;
    unsigned split_;
};

/// xis[i] = the sample of contexts[i] drawn from `slot` in [0, kJointSlots) under splits by `split`
/// in [1, kMaxJointSplit] in all, for i in [0, n): jointSample1D, jointSample2D, jointSample3D. `n`
/// may be 0. Arrays must not overlap. Safe in any thread.
WELLSTRAT_API void drawJointSamples1D(std::size_t n, const SampleCtx* contexts, unsigned slot,
                                      unsigned split, float* xis);
WELLSTRAT_API void drawJointSamples2D(std::size_t n, const SampleCtx* contexts, unsigned slot,
                                      unsigned split, Float2* xis);
WELLSTRAT_API void drawJointSamples3D(std::size_t n, const SampleCtx* contexts, unsigned slot,
                                      unsigned split, Float3* xis);

} // namespace stream1
} // namespace wellstrat
