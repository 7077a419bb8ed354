// SPDX-License-Identifier: Apache-2.0
//
// The samples of slots, computed anew from their definition: matrices as columns of bits, divisions
// as divisions, table values one by one.

#pragma once

#include "wellstrat/joint_bank.h"
#include "wellstrat/lookup.h"

#include <cstdint>

namespace wellstrat::test {

/// The product of the 12x12 matrix over GF(2) with entries entry(row, column) and a vector.
template <typename Entry>
uint32_t multiply(Entry entry, uint32_t vector) {
    uint32_t product = 0;
    for (unsigned row = 0; row < 12; ++row) {
        unsigned sum = 0;
        for (unsigned column = 0; column < 12; ++column) {
            sum += entry(row, column) * (vector >> column & 1u);
        }
        product |= sum % 2 << row;
    }
    return product;
}

inline uint32_t slotOrder(unsigned slot, bool swap, uint32_t index) {
    const uint32_t place = multiply(
        [&](unsigned row, unsigned column) { return kJointBank[slot][column] >> row & 1u; }, index);
    if (!swap) return place;
    return multiply([](unsigned row, unsigned column) { return (column & row) == row ? 1u : 0u; },
                    place);
}

/// Where the sample is in the unshuffled sequence of its pattern, but for the constant shift, or -1
/// if it is random.
inline int64_t referenceIndex(uint32_t patternid, uint32_t sampleid, unsigned slot, unsigned n) {
    const uint32_t seed = patternSeed(patternid), visits = kStratifiedSamples / n;
    const uint32_t visit = sampleid / n, branch = sampleid % n;
    if (visit >= visits) return -1;
    // The visits are cut into aligned runs of 2^m, at most 4096 of them, the longest first.
    uint32_t run = 4096, start = 0;
    for (;; start += run) {
        while (start + run > visits) run /= 2;
        if (visit < start + run) break;
    }
    const uint32_t place = start + slotOrder(slot, seed / 16 % 2 == 1, visit - start);
    uint32_t evenPart = 1;
    while (n / evenPart % 2 == 0) evenPart *= 2;
    const uint32_t hash = mixBits(seed + visit * 0x9e3779b9u), odd = n / evenPart;
    const uint32_t q = branch / evenPart, multiplier = 1u << hash % 8;
    const uint32_t high = (q * multiplier + scaleToRange(hash, odd)) % odd;
    const uint32_t shuffled = shuffledPlace(hash + q * 0x9e3779b9u, branch % evenPart);
    const uint32_t low = reverseBits(shuffled << 24) % evenPart;
    return int64_t{place} * n + high * evenPart + low;
}

inline Float3 referenceSample(uint32_t patternid, uint32_t sampleid, unsigned slot, unsigned n) {
    const int64_t index = referenceIndex(patternid, sampleid, slot, n);
    if (index < 0) return randomSample3D(patternid, sampleid);
    const uint32_t seed = patternSeed(patternid);
    const unsigned table = tableOfBlock(seed, static_cast<uint32_t>(index / 4096));
    // Bit 0 of the seed is for the halves of the group of 256, bit 7 for neighbors.
    uint32_t place = static_cast<uint32_t>(index % 4096);
    for (unsigned bit = 0; bit < 8; ++bit) place ^= (seed >> bit & 1u) << (7 - bit);
    const auto value = [&](Coordinate c) {
        return toUnitFloat(tableValue(table, place, c) ^ digitalShift(seed, c));
    };
    return {value(Coordinate::x), value(Coordinate::y), value(Coordinate::z)};
}

} // namespace wellstrat::test
