// SPDX-License-Identifier: Apache-2.0
//
// All that a kernel may ask of the library, as one function of plain words, so that a GPU and a
// processor can be asked the same. `answer` is compiled for both.

#pragma once

#include "RixRNGInline.h"
#include "wellstrat/blue_domain.h"
#include "wellstrat/camera.h"
#include "wellstrat/device_tables.h"

#include <cstdint>

namespace gpu_check {

using wellstrat::DeviceTables;

/// What is asked; the arguments and the words of the answer are those of the golden files
/// (tests/golden/golden.h).
enum class Kind : uint32_t {
    sample,
    random,
    joint,
    longSample,
    longSlot,
    blue,
    blueSlot,
    sequence,
    tablePoint, ///< table index = x y z, fractions of 2^32
    hash,
    domain,
    distrib,
    split,
    camera,
    seeded,
    blueSplit,
    blueDistrib,
    blueCamera,
    order,  ///< the slot and the splits of a domain, from those of its parent, a scramble, a split
    noSlot, ///< a sample of `long` of a slot out of range, which shaders take as none
};
constexpr uint32_t kKinds = static_cast<uint32_t>(Kind::noSlot) + 1;

struct Question {
    Kind kind;
    uint32_t arguments[5];
};

/// Words that the answer does not need are 0.
struct Answer {
    uint32_t words[3];
};

WELLSTRAT_HOST_DEVICE inline bool operator==(const Answer& a, const Answer& b) {
    return a.words[0] == b.words[0] && a.words[1] == b.words[1] && a.words[2] == b.words[2];
}

/// The 24 bits of a sample.
WELLSTRAT_HOST_DEVICE inline uint32_t bitsOf(float xi) {
    return static_cast<uint32_t>(xi * 0x1p24f);
}

/// The answer of three draws from one context, or words that no sample has if they disagree.
WELLSTRAT_HOST_DEVICE inline Answer drawn(float z, wellstrat::Float2 xy, wellstrat::Float3 xyz) {
    if (xyz != wellstrat::Float3(xy.x, xy.y, z)) return {{~0u, ~0u, ~0u}};
    return {{bitsOf(xyz.x), bitsOf(xyz.y), bitsOf(xyz.z)}};
}

WELLSTRAT_HOST_DEVICE inline Answer context(wellstrat::SampleCtx sc) {
    return {{sc.patternid, sc.sampleid, 0}};
}

/// The answers about samples.
WELLSTRAT_HOST_DEVICE inline Answer sampleAnswer(const DeviceTables& t, const Question& question) {
    using namespace wellstrat;
    const uint32_t* const a = question.arguments;
    switch (question.kind) {
    case Kind::sample:
        return drawn(sample1D(t.words, a[0], a[1]), sample2D(t.words, a[0], a[1]),
                     sample3D(t.words, a[0], a[1]));
    case Kind::random:
        return drawn(randomSample1D(a[0], a[1]), randomSample2D(a[0], a[1]),
                     randomSample3D(a[0], a[1]));
    case Kind::joint:
        return drawn(jointSample1D(t.words, t.jointOrders, a[0], a[1], a[2], a[3]),
                     jointSample2D(t.words, t.jointOrders, a[0], a[1], a[2], a[3]),
                     jointSample3D(t.words, t.jointOrders, a[0], a[1], a[2], a[3]));
    case Kind::longSample:
    case Kind::noSlot:
        return drawn(sequenceSample1D(a[0], a[1]), sequenceSample2D(a[0], a[1]),
                     sequenceSample3D(a[0], a[1]));
    case Kind::longSlot:
        return drawn(jointSequenceSample1D(t.slotOrders, a[0], a[1], a[2], a[3]),
                     jointSequenceSample2D(t.slotOrders, a[0], a[1], a[2], a[3]),
                     jointSequenceSample3D(t.slotOrders, a[0], a[1], a[2], a[3]));
    case Kind::blue:
        return drawn(blueSample1D(t.blueTables, a[0], a[1]), blueSample2D(t.blueTables, a[0], a[1]),
                     blueSample3D(t.blueTables, a[0], a[1]));
    default:
        return drawn(blueSlotSample1D(t.blueTables, t.slotOrders, a[0], a[1], a[2], a[3]),
                     blueSlotSample2D(t.blueTables, t.slotOrders, a[0], a[1], a[2], a[3]),
                     blueSlotSample3D(t.blueTables, t.slotOrders, a[0], a[1], a[2], a[3]));
    }
}

WELLSTRAT_HOST_DEVICE inline Answer answer(const DeviceTables& t, const Question& question) {
    using namespace wellstrat;
    const uint32_t* const a = question.arguments;
    const SampleCtx parent{a[0], a[1]};
    const auto scramble = static_cast<Scramble>(a[2]);
    const int x = static_cast<int>(a[0]), y = static_cast<int>(a[1]);
    switch (question.kind) {
    case Kind::sequence:
        return {{sequenceBits(a[0], a[1], Coordinate::x), sequenceBits(a[0], a[1], Coordinate::y),
                 sequenceBits(a[0], a[1], Coordinate::z)}};
    case Kind::tablePoint: {
        const uint32_t offset = tableOffset(a[0], a[1]);
        const uint64_t xy = tableXY(t.words[offset]);
        return {{static_cast<uint32_t>(xy) & ~0xffu, static_cast<uint32_t>(xy >> 32) & ~0xffu,
                 t.words[kTablePoints + offset] & ~0xffu}};
    }
    case Kind::hash: return {{HashToUnsigned(a[0], a[1]), 0, 0}};
    case Kind::domain: return context(parent.NewDomain(scramble));
    case Kind::distrib: return context(parent.NewDomainDistrib(scramble, a[3]));
    case Kind::split: return context(parent.NewDomainSplit(scramble, a[3]));
    case Kind::camera: return context(cameraContext(x, y, a[2], a[3]));
    case Kind::seeded: return context(cameraContext(x, y, a[2], a[3], a[4]));
    case Kind::blueSplit: return context(newBlueDomainSplit(parent, scramble, a[3]));
    case Kind::blueDistrib: return context(newBlueDomainDistrib(parent, scramble, a[3]));
    case Kind::blueCamera: return context(blueContext(x, y, a[2], a[3]));
    case Kind::order: {
        const Order outer{static_cast<uint16_t>(a[0]), static_cast<uint16_t>(a[1])};
        const Order child = deriveOrder(outer, scramble, a[3]);
        return {{child.slot, child.splits, 0}};
    }
    default: return sampleAnswer(t, question);
    }
}

/// One of 2^32 questions of a kind with random arguments in the ranges that they have: sampleids of
/// all magnitudes, all slots, half of them under splits.
WELLSTRAT_HOST_DEVICE inline Question randomQuestion(Kind kind, uint32_t number) {
    Question question{kind, {}};
    uint32_t* const a = question.arguments;
    for (uint32_t i = 0; i < 5; ++i) {
        a[i] = wellstrat::hashPair(number, 5 * static_cast<uint32_t>(kind) + i);
    }
    a[1] >>= a[4] & 31u;
    if (kind == Kind::joint || kind == Kind::longSlot || kind == Kind::blueSlot) {
        a[2] %= wellstrat::kJointSlots;
        a[3] = (a[3] & 1u) != 0 ? 1 : 1 + (a[3] >> 1) % wellstrat::kMaxJointSplit;
    }
    if (kind == Kind::order) {
        a[0] %= wellstrat::kJointSlots + 1;
        a[1] = a[4] % (wellstrat::kMaxJointSplit + 1);
        a[2] = wellstrat::detail::kJointScramble + a[2] % (wellstrat::kJointSlots + 2);
        a[3] = (a[3] & 1u) != 0 ? a[3] >> (a[4] & 31u) : a[3] % 4;
    }
    if (kind == Kind::noSlot) { // one of the two is in range
        if ((a[4] >> 5 & 1u) != 0) {
            a[2] = wellstrat::kJointSlots + a[2] / 2;
            a[3] = 1 + a[3] % wellstrat::kMaxJointSplit;
        } else {
            a[2] %= wellstrat::kJointSlots;
            a[3] = (a[3] & 1u) != 0 ? 0 : wellstrat::kMaxJointSplit + 1 + a[3] / 2;
        }
    }
    if (kind == Kind::tablePoint) {
        a[0] %= wellstrat::kTableCount;
        a[1] %= wellstrat::kTableSize;
    }
    return question;
}

/// A word that depends on the number of a question and on every bit of the answer. Sums of these
/// are the same in any order of the questions.
WELLSTRAT_HOST_DEVICE inline uint64_t digestOf(const Answer& result, uint32_t number) {
    uint64_t hash = number;
    for (const uint32_t word : result.words) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15u; // 2^64 / golden ratio
        hash ^= hash >> 32;
    }
    return hash;
}

WELLSTRAT_HOST_DEVICE inline uint64_t digest(const DeviceTables& tables, Kind kind,
                                             uint32_t number) {
    return digestOf(answer(tables, randomQuestion(kind, number)), number);
}

} // namespace gpu_check
