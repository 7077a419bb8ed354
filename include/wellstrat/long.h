// SPDX-License-Identifier: Apache-2.0
//
// Samples without end and without tables: the computed sequence of sequence.h.
//
//     const wellstrat::LongProgressive longSamples;
//     RixRNG camera(contexts, numPts, &longSamples); // and all that is derived from it
//
// All 2^32 samples of a pattern are stratified, where the tables have 4096 at a time; and nothing
// is read from memory, which matters where a scene fills the caches. Domains may be marked as
// slots, as those of a JointProgressive (joint.h).

#pragma once

#include "wellstrat/generator.h"

namespace wellstrat {
inline namespace stream1 {

/// The generator of computed samples. It has no state, so all of them are alike; constructing one
/// costs nothing, and they may be used in any thread.
///
/// Any 2^m samples of a pattern from a multiple of 2^m on are a (0,m,2)-net in (x, y) and a
/// (1,m,3)-net in (x, y, z), for m from 0 to 32; z is the 1D sample. Split domains keep all that,
/// since their samples count up from 0 as those of others do. Sampleids count modulo 2^32: a split
/// whose product exceeds it begins the sequence anew.
///
/// How a domain draws whose RixRNG has this generator, by its order (order.h):
///
///     by jointScramble(slot)           from the slot (sequence_slots.h); by another: shuffled
///     split by n                       as above, if all splits make up 1 to kMaxJointSplit
///     branches otherwise               shuffled, and so do all its children
///     by distribution                  shuffled, and so do all its children
///     RixRNG(parent, indices, n, ctx)  as its parent, some points of which it is
///     RixRNG(parent, contexts, n)      shuffled
///
/// A slot alone keeps every promise, under splits by a power of two at least. Without a RixRNG, as
/// by Sample2D(context, 0), samples are shuffled. An order that deriveOrder never gives ends the
/// program with a line that says so.
class WELLSTRAT_API LongProgressive final : public OrderedGenerator {
public:
    constexpr LongProgressive() : OrderedGenerator(Source::sequence) {}
    ~LongProgressive() override;

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
