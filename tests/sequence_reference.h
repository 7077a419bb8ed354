// SPDX-License-Identifier: Apache-2.0
//
// The computed samples anew from their definition: Sobol' matrices column by column, digits in the
// order of the coordinate, matrices of slots as columns of bits, divisions as divisions.

#pragma once

#include "wellstrat/joint_bank.h"
#include "wellstrat/joint_lookup.h"
#include "wellstrat/sequence.h"

#include <array>
#include <cstdint>
#include <iterator>

namespace wellstrat::test {

constexpr unsigned kBankDigits = std::size(kJointBank[0]);

/// The 32 bits of x, y and z of the point at `index`, as a pattern with this seed has it.
inline std::array<uint32_t, 3> referencePoint(uint32_t seed, uint32_t index) {
    static const SobolMatrix matrices[3] = {sobolMatrix(0), sobolMatrix(1), sobolMatrix(2)};
    std::array<uint32_t, 3> bits;
    for (unsigned d = 0; d < 3; ++d) {
        const uint32_t digits = reverseBits(sobolSample(matrices[d], index));
        bits[d] = reverseBits(owenHash(digits, scramblingKey(seed, static_cast<Coordinate>(d))));
    }
    return bits;
}

inline uint32_t referenceShuffle(uint32_t seed, uint32_t index) {
    return reverseBits(owenHash(reverseBits(index), shuffleKey(seed)));
}

/// The index of a sample without slots: the swaps of all runs that begin at 0 and are longer than
/// 2^16 are undone.
inline uint32_t referenceIndex(uint32_t seed, uint32_t sampleid) {
    const uint32_t undone = referenceShuffle(seed, 0) >> 16 << 16;
    return referenceShuffle(seed, sampleid) ^ undone;
}

/// The place of visit i of a slot.
inline uint32_t referenceSlotPlace(uint32_t seed, unsigned slot, uint32_t i) {
    uint32_t inBlock = 0;
    for (unsigned k = 0; k < kBankDigits; ++k) {
        if (i >> k & 1u) inBlock ^= kJointBank[slot][k];
    }
    if (seed >> 31 != 0) {
        uint32_t swapped = 0;
        for (unsigned row = 0; row < kBankDigits; ++row) {
            uint32_t sum = 0;
            for (unsigned column = 0; column < kBankDigits; ++column) {
                if ((column & row) == row) sum ^= inBlock >> column;
            }
            swapped |= (sum & 1u) << row;
        }
        inBlock = swapped;
    }
    const uint32_t block = i >> kBankDigits << kBankDigits;
    return inBlock ^ referenceShuffle(seed, block) ^ referenceShuffle(seed, 0);
}

/// The index of a sample of a slot under splits by n, if it is of a whole visit.
inline uint32_t referenceSlotIndex(uint32_t seed, uint32_t sampleid, unsigned slot, unsigned n) {
    const uint64_t visits = (uint64_t{1} << 32) / n;
    const uint32_t visit = sampleid / n, branch = sampleid % n;
    // The visits are cut into aligned runs of 2^m, the longest first.
    uint64_t run = uint64_t{1} << 32, start = 0;
    for (;; start += run) {
        while (start + run > visits) run /= 2;
        if (visit < start + run) break;
    }
    const uint64_t place = start + referenceSlotPlace(seed, slot, visit) % run;
    return static_cast<uint32_t>(place * n + detail::jointBranch(seed, visit, branch, n));
}

} // namespace wellstrat::test
