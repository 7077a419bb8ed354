// SPDX-License-Identifier: Apache-2.0

#include "batch/kernels.h"

#include "wellstrat/blue_lookup.h"
#include "wellstrat/domain.h"
#include "wellstrat/joint_lookup.h"
#include "wellstrat/lookup.h"
#include "wellstrat/sequence_slots.h"

namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace {

template <auto kSample, typename Sample>
void draw(std::size_t n, const uint32_t* words, SampleCtx* contexts, unsigned step, Sample* xis) {
    for (std::size_t i = 0; i < n; ++i) {
        xis[i] = kSample(words, contexts[i].patternid, contexts[i].sampleid);
        if (step != 0) contexts[i].sampleid += step;
    }
}

template <auto kSample, typename Sample>
void drawJoint(std::size_t n, const uint32_t* words, const SampleCtx* contexts, unsigned slot,
               unsigned split, Sample* xis) {
    for (std::size_t i = 0; i < n; ++i) {
        xis[i] = kSample(words, contexts[i].patternid, contexts[i].sampleid, slot, split);
    }
}

template <auto kPadded, auto kJoint, typename Sample>
void drawComputed(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                  Sample* xis) {
    for (std::size_t i = 0; i < n; ++i) {
        const SampleCtx sc = contexts[i];
        xis[i] = slot == kJointSlots ? kPadded(sc.patternid, sc.sampleid)
                                     : kJoint(sc.patternid, sc.sampleid, slot, split);
    }
}

/// All bits of the samples, by kBits of a point and its seed.
template <auto kBits, typename Bits>
void drawSequenceBits(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                      Bits* bits) {
    for (std::size_t i = 0; i < n; ++i) {
        const uint32_t sampleid = contexts[i].sampleid;
        const uint32_t seed = sequenceSeed(contexts[i].patternid);
        bits[i] = kBits(slot == kJointSlots ? sequencePoint(seed, sampleid)
                                            : slotDigits(seed, sampleid, slot, split),
                        seed);
    }
}

void newDomainsSplit(std::size_t n, const SampleCtx* parents, Scramble scramble,
                     unsigned newnumsamples, SampleCtx* children) {
    for (std::size_t i = 0; i < n; ++i) {
        children[i] = parents[i].NewDomainSplit(scramble, newnumsamples);
    }
}

void newDomainsDistrib(std::size_t n, const SampleCtx* parents, Scramble scramble,
                       unsigned newsampleid, SampleCtx* children) {
    for (std::size_t i = 0; i < n; ++i) {
        children[i] = parents[i].NewDomainDistrib(scramble, newsampleid);
    }
}

void newBlueDomainsSplit(std::size_t n, const SampleCtx* parents, Scramble scramble,
                         unsigned newnumsamples, SampleCtx* children) {
    for (std::size_t i = 0; i < n; ++i) {
        children[i] = newBlueDomainSplit(parents[i], scramble, newnumsamples);
    }
}

void newBlueDomainsDistrib(std::size_t n, const SampleCtx* parents, Scramble scramble,
                           unsigned newsampleid, SampleCtx* children) {
    for (std::size_t i = 0; i < n; ++i) {
        children[i] = newBlueDomainDistrib(parents[i], scramble, newsampleid);
    }
}

void hashToRandom(std::size_t n, const SampleCtx* contexts, float* xis) {
    for (std::size_t i = 0; i < n; ++i) {
        xis[i] = toUnitFloat(hashPair(contexts[i].patternid, contexts[i].sampleid));
    }
}

using Sample1D = float (*)(const uint32_t*, uint32_t, uint32_t);
using Sample2D = Float2 (*)(const uint32_t*, uint32_t, uint32_t);
using Sample3D = Float3 (*)(const uint32_t*, uint32_t, uint32_t);

} // namespace

const Kernels kScalarKernels = {
    "scalar",
    draw<static_cast<Sample1D>(sample1D)>,
    draw<static_cast<Sample2D>(sample2D)>,
    draw<static_cast<Sample3D>(sample3D)>,
    drawJoint<jointSample1D>,
    drawJoint<jointSample2D>,
    drawJoint<jointSample3D>,
    drawComputed<sequenceSample1D, jointSequenceSample1D>,
    drawComputed<sequenceSample2D, jointSequenceSample2D>,
    drawComputed<sequenceSample3D, jointSequenceSample3D>,
    drawSequenceBits<scrambledBitsZ>,
    drawSequenceBits<scrambledBitsXY>,
    drawSequenceBits<scrambledBitsXYZ>,
    drawComputed<blueSample1D, blueSlotSample1D>,
    drawComputed<blueSample2D, blueSlotSample2D>,
    drawComputed<blueSample3D, blueSlotSample3D>,
    newDomainsSplit,
    newDomainsDistrib,
    newBlueDomainsSplit,
    newBlueDomainsDistrib,
    hashToRandom,
};

} // namespace batch
} // namespace stream1
} // namespace wellstrat
