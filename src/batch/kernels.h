// SPDX-License-Identifier: Apache-2.0
//
// The functions of batch.h, one set for each instruction set.

#pragma once

#include "wellstrat/domain.h"
#include "wellstrat/vector.h"

#include <cstddef>
#include <cstdint>

namespace wellstrat {
inline namespace stream1 {
namespace batch {

// n >= 1 in all.

/// Draws from the tables, and adds `step`, 0 or 1, to each sampleid after its draw; with 0 the
/// contexts are not written to.
template <typename Sample>
using DrawTables = void (*)(std::size_t n, const uint32_t* words, SampleCtx* contexts,
                            unsigned step, Sample* xis);

/// Samples `first` to first + n - 1 of a pattern, all below kStratifiedSamples.
template <typename Sample>
using DrawRun = void (*)(std::size_t n, const uint32_t* words, uint32_t patternid, uint32_t first,
                         Sample* xis);
template <typename Sample>
using DrawJoint = void (*)(std::size_t n, const uint32_t* words, const SampleCtx* contexts,
                           unsigned slot, unsigned split, Sample* xis);

/// Of points without tables: padded where `slot` is kJointSlots.
template <typename Sample>
using DrawComputed = void (*)(std::size_t n, const SampleCtx* contexts, unsigned slot,
                              unsigned split, Sample* xis);

struct Kernels {
    const char* target;
    DrawTables<float> draw1D;
    DrawTables<Float2> draw2D;
    DrawTables<Float3> draw3D;
    DrawRun<float> drawRun1D;
    DrawRun<Float2> drawRun2D;
    DrawRun<Float3> drawRun3D;
    DrawJoint<float> drawJoint1D;
    DrawJoint<Float2> drawJoint2D;
    DrawJoint<Float3> drawJoint3D;
    DrawComputed<float> drawSequence1D;
    DrawComputed<Float2> drawSequence2D;
    DrawComputed<Float3> drawSequence3D;
    DrawComputed<uint32_t> drawSequenceBits1D;
    DrawComputed<Bits2> drawSequenceBits2D;
    DrawComputed<Bits3> drawSequenceBits3D;
    DrawComputed<float> drawBlue1D;
    DrawComputed<Float2> drawBlue2D;
    DrawComputed<Float3> drawBlue3D;
    void (*newDomainsSplit)(std::size_t n, const SampleCtx* parents, Scramble scramble,
                            unsigned newnumsamples, SampleCtx* children);
    void (*newDomainsDistrib)(std::size_t n, const SampleCtx* parents, Scramble scramble,
                              unsigned newsampleid, SampleCtx* children);
    void (*newBlueDomainsSplit)(std::size_t n, const SampleCtx* parents, Scramble scramble,
                                unsigned newnumsamples, SampleCtx* children);
    void (*newBlueDomainsDistrib)(std::size_t n, const SampleCtx* parents, Scramble scramble,
                                  unsigned newsampleid, SampleCtx* children);
    void (*hashToRandom)(std::size_t n, const SampleCtx* contexts, float* xis);
};

/// Plain loops over the scalar functions: the reference, and the code for processors that no other
/// set is for.
extern const Kernels kScalarKernels;

/// Those sets of vector code that this processor can run, best first; ends with a null pointer.
const Kernels* const* vectorKernels();

/// The set that all batches use: the best, or the one that was forced (wellstrat/batch_target.h).
const Kernels& chosenKernels();

} // namespace batch
} // namespace stream1
} // namespace wellstrat
