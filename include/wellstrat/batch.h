// SPDX-License-Identifier: Apache-2.0
//
// The scalar functions of lookup.h, sequence.h, blue.h, domain.h and hash.h over arrays, with the
// same bits.
//
// All are compiled into the library. Arrays are given by a pointer, which is not checked, or as
// anything that knows its size (array_argument.h): one of fewer than `n` elements ends the program
// with a line that says so, before anything is written. `n` may be 0, and then pointers may be
// null. Arrays need no alignment beyond that of their type. Input and output may be the same array
// where their types are the same, but must not overlap otherwise. Safe in any thread for arrays
// that no other thread writes.

#pragma once

#include "wellstrat/array_argument.h"
#include "wellstrat/domain.h"
#include "wellstrat/order.h"
#include "wellstrat/platform.h"
#include "wellstrat/vector.h"

#include <cstddef>
#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

/// xis[i] = the sample of contexts[i], for i in [0, n): sample1D, sample2D, sample3D.
WELLSTRAT_API void drawSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                 ArrayArgument<float> xis);
WELLSTRAT_API void drawSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                 ArrayArgument<Float2> xis);
WELLSTRAT_API void drawSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                 ArrayArgument<Float3> xis);

/// The same, and then one is added to each sampleid.
WELLSTRAT_API void generateSamples1D(std::size_t n, ArrayArgument<SampleCtx> contexts,
                                     ArrayArgument<float> xis);
WELLSTRAT_API void generateSamples2D(std::size_t n, ArrayArgument<SampleCtx> contexts,
                                     ArrayArgument<Float2> xis);
WELLSTRAT_API void generateSamples3D(std::size_t n, ArrayArgument<SampleCtx> contexts,
                                     ArrayArgument<Float3> xis);

/// xis[i] = the sample of {patternid, first + i}, modulo 2^32, for i in [0, n): the samples of one
/// pattern one after another, in less time.
WELLSTRAT_API void drawRun1D(std::size_t n, uint32_t patternid, uint32_t first,
                             ArrayArgument<float> xis);
WELLSTRAT_API void drawRun2D(std::size_t n, uint32_t patternid, uint32_t first,
                             ArrayArgument<Float2> xis);
WELLSTRAT_API void drawRun3D(std::size_t n, uint32_t patternid, uint32_t first,
                             ArrayArgument<Float3> xis);

/// xis[i] = the sample of contexts[i] in a domain of this order, as JointProgressive (joint.h)
/// draws it, for i in [0, n): jointSample1D, jointSample2D, jointSample3D for an order with a slot,
/// else sample1D and its kin. An order that deriveOrder never gives ends the program with a line
/// that says so.
WELLSTRAT_API void drawJointSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                      Order order, ArrayArgument<float> xis);
WELLSTRAT_API void drawJointSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                      Order order, ArrayArgument<Float2> xis);
WELLSTRAT_API void drawJointSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                      Order order, ArrayArgument<Float3> xis);

/// xis[i] = the sample of contexts[i] in a domain of this order, as LongProgressive (long.h) draws
/// it, for i in [0, n): jointSequenceSample1D, 2D and 3D for an order with a slot, else
/// sequenceSample1D and its kin. Orders as above.
WELLSTRAT_API void drawSequenceSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                         Order order, ArrayArgument<float> xis);
WELLSTRAT_API void drawSequenceSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                         Order order, ArrayArgument<Float2> xis);
WELLSTRAT_API void drawSequenceSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                         Order order, ArrayArgument<Float3> xis);

/// xis[i] = the sample of contexts[i] in a domain of this order, as BlueProgressive (blue.h) draws
/// it, for i in [0, n): blueSlotSample1D, 2D and 3D for an order with a slot, else blueSample1D and
/// its kin. Orders as above.
WELLSTRAT_API void drawBlueSamples1D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                     Order order, ArrayArgument<float> xis);
WELLSTRAT_API void drawBlueSamples2D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                     Order order, ArrayArgument<Float2> xis);
WELLSTRAT_API void drawBlueSamples3D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                     Order order, ArrayArgument<Float3> xis);

/// bits[i] = all 32 bits of each coordinate of the samples of drawSequenceSamples1D, 2D and 3D, of
/// which floats are the upper 24, for i in [0, n).
WELLSTRAT_API void drawSequenceBits1D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                      Order order, ArrayArgument<uint32_t> bits);
WELLSTRAT_API void drawSequenceBits2D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                      Order order, ArrayArgument<Bits2> bits);
WELLSTRAT_API void drawSequenceBits3D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                      Order order, ArrayArgument<Bits3> bits);

/// The same of drawBlueSamples1D, 2D and 3D. Computed one by one, not in vectors.
WELLSTRAT_API void drawBlueBits1D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                  Order order, ArrayArgument<uint32_t> bits);
WELLSTRAT_API void drawBlueBits2D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                  Order order, ArrayArgument<Bits2> bits);
WELLSTRAT_API void drawBlueBits3D(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                  Order order, ArrayArgument<Bits3> bits);

/// children[i] = parents[i].NewDomain(scramble), for i in [0, n); likewise the others.
WELLSTRAT_API void newDomains(std::size_t n, ArrayArgument<const SampleCtx> parents,
                              Scramble scramble, ArrayArgument<SampleCtx> children);
WELLSTRAT_API void newDomainsDistrib(std::size_t n, ArrayArgument<const SampleCtx> parents,
                                     Scramble scramble, unsigned newsampleid,
                                     ArrayArgument<SampleCtx> children);
WELLSTRAT_API void newDomainsSplit(std::size_t n, ArrayArgument<const SampleCtx> parents,
                                   Scramble scramble, unsigned newnumsamples,
                                   ArrayArgument<SampleCtx> children);

/// children[i] = newBlueDomainSplit(parents[i], scramble, newnumsamples), for i in [0, n);
/// likewise the other.
WELLSTRAT_API void newBlueDomainsSplit(std::size_t n, ArrayArgument<const SampleCtx> parents,
                                       Scramble scramble, unsigned newnumsamples,
                                       ArrayArgument<SampleCtx> children);
WELLSTRAT_API void newBlueDomainsDistrib(std::size_t n, ArrayArgument<const SampleCtx> parents,
                                         Scramble scramble, unsigned newsampleid,
                                         ArrayArgument<SampleCtx> children);

/// xis[i] = HashToRandom(contexts[i].patternid, contexts[i].sampleid), for i in [0, n).
WELLSTRAT_API void hashToRandom(std::size_t n, ArrayArgument<const SampleCtx> contexts,
                                ArrayArgument<float> xis);

} // namespace stream1
} // namespace wellstrat
