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

/// n >= 1 in all. The draws add `step`, 0 or 1, to each sampleid after its draw; with 0 the
/// contexts are not written to. Those of the sequence and of the blue one are padded where `slot`
/// is kJointSlots.
struct Kernels {
    const char* target;
    void (*draw1D)(std::size_t n, const uint32_t* words, SampleCtx* contexts, unsigned step,
                   float* xis);
    void (*draw2D)(std::size_t n, const uint32_t* words, SampleCtx* contexts, unsigned step,
                   Float2* xis);
    void (*draw3D)(std::size_t n, const uint32_t* words, SampleCtx* contexts, unsigned step,
                   Float3* xis);
    /// Samples `first` to first + n - 1 of a pattern, all below kStratifiedSamples.
    void (*drawRun1D)(std::size_t n, const uint32_t* words, uint32_t patternid, uint32_t first,
                      float* xis);
    void (*drawRun2D)(std::size_t n, const uint32_t* words, uint32_t patternid, uint32_t first,
                      Float2* xis);
    void (*drawRun3D)(std::size_t n, const uint32_t* words, uint32_t patternid, uint32_t first,
                      Float3* xis);
    void (*drawJoint1D)(std::size_t n, const uint32_t* words, const SampleCtx* contexts,
                        unsigned slot, unsigned split, float* xis);
    void (*drawJoint2D)(std::size_t n, const uint32_t* words, const SampleCtx* contexts,
                        unsigned slot, unsigned split, Float2* xis);
    void (*drawJoint3D)(std::size_t n, const uint32_t* words, const SampleCtx* contexts,
                        unsigned slot, unsigned split, Float3* xis);
    void (*drawSequence1D)(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                           float* xis);
    void (*drawSequence2D)(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                           Float2* xis);
    void (*drawSequence3D)(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                           Float3* xis);
    void (*drawSequenceBits1D)(std::size_t n, const SampleCtx* contexts, unsigned slot,
                               unsigned split, uint32_t* bits);
    void (*drawSequenceBits2D)(std::size_t n, const SampleCtx* contexts, unsigned slot,
                               unsigned split, Bits2* bits);
    void (*drawSequenceBits3D)(std::size_t n, const SampleCtx* contexts, unsigned slot,
                               unsigned split, Bits3* bits);
    void (*drawBlue1D)(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                       float* xis);
    void (*drawBlue2D)(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                       Float2* xis);
    void (*drawBlue3D)(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                       Float3* xis);
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
