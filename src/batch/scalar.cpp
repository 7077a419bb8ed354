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
void drawRun(std::size_t n, const uint32_t* words, uint32_t patternid, uint32_t first,
             Sample* xis) {
    for (std::size_t i = 0; i < n; ++i) {
        xis[i] = kSample(words, patternid, first + static_cast<uint32_t>(i));
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
        bits[i] = kBits(slot == kJointSlots
                            ? sequencePoint(seed, sampleid)
                            : slotDigits(detail::kSlotOrders, seed, sampleid, slot, split),
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
template <typename Sample>
using Joint = Sample (*)(const uint32_t*, uint32_t, uint32_t, unsigned, unsigned);
template <typename Sample>
using Computed = Sample (*)(uint32_t, uint32_t);
template <typename Sample>
using Slot = Sample (*)(uint32_t, uint32_t, unsigned, unsigned);

} // namespace

const Kernels kScalarKernels = {
    "scalar",
    draw<static_cast<Sample1D>(sample1D)>,
    draw<static_cast<Sample2D>(sample2D)>,
    draw<static_cast<Sample3D>(sample3D)>,
    drawRun<static_cast<Sample1D>(sample1D)>,
    drawRun<static_cast<Sample2D>(sample2D)>,
    drawRun<static_cast<Sample3D>(sample3D)>,
    drawJoint<Joint<float>{jointSample1D}>,
    drawJoint<Joint<Float2>{jointSample2D}>,
    drawJoint<Joint<Float3>{jointSample3D}>,
    drawComputed<Computed<float>{sequenceSample1D}, Slot<float>{jointSequenceSample1D}>,
    drawComputed<Computed<Float2>{sequenceSample2D}, Slot<Float2>{jointSequenceSample2D}>,
    drawComputed<Computed<Float3>{sequenceSample3D}, Slot<Float3>{jointSequenceSample3D}>,
    drawSequenceBits<scrambledBitsZ>,
    drawSequenceBits<scrambledBitsXY>,
    drawSequenceBits<scrambledBitsXYZ>,
    drawComputed<Computed<float>{blueSample1D}, Slot<float>{blueSlotSample1D}>,
    drawComputed<Computed<Float2>{blueSample2D}, Slot<Float2>{blueSlotSample2D}>,
    drawComputed<Computed<Float3>{blueSample3D}, Slot<Float3>{blueSlotSample3D}>,
    newDomainsSplit,
    newDomainsDistrib,
    newBlueDomainsSplit,
    newBlueDomainsDistrib,
    hashToRandom,
};

} // namespace batch
} // namespace stream1
} // namespace wellstrat
