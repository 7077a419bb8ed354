// SPDX-License-Identifier: Apache-2.0
//
// Unstratified samples, one independent hash for each coordinate: for when the tables have run out,
// and for comparison.

#pragma once

#include "wellstrat/bits.h"
#include "wellstrat/coordinate.h"
#include "wellstrat/hash.h"
#include "wellstrat/vector.h"

namespace wellstrat {
inline namespace stream1 {

/// The key that gives x and y patterns of their own in `randomBits`.
WELLSTRAT_HOST_DEVICE constexpr PermutationKey randomKey(Coordinate coordinate) {
    return permutationKey(0x72616e64u + static_cast<uint32_t>(coordinate)); // "rand"
}

/// A coordinate of a sample as a fraction of 2^32. That of z is `hashPair(patternid, sampleid)`.
WELLSTRAT_HOST_DEVICE constexpr uint32_t randomBits(uint32_t patternid, uint32_t sampleid,
                                                    Coordinate coordinate) {
    if (coordinate != Coordinate::z) patternid = permuteBits(patternid, randomKey(coordinate));
    return hashPair(patternid, sampleid);
}

/// z, (x, y) and (x, y, z) of a sample, in [0, 1).
WELLSTRAT_HOST_DEVICE WELLSTRAT_NOINLINE inline float randomSample1D(uint32_t patternid,
                                                                     uint32_t sampleid) {
    return toUnitFloat(randomBits(patternid, sampleid, Coordinate::z));
}
WELLSTRAT_HOST_DEVICE WELLSTRAT_NOINLINE inline Float2 randomSample2D(uint32_t patternid,
                                                                      uint32_t sampleid) {
    return {toUnitFloat(randomBits(patternid, sampleid, Coordinate::x)),
            toUnitFloat(randomBits(patternid, sampleid, Coordinate::y))};
}
WELLSTRAT_HOST_DEVICE WELLSTRAT_NOINLINE inline Float3 randomSample3D(uint32_t patternid,
                                                                      uint32_t sampleid) {
    const Float2 xy = randomSample2D(patternid, sampleid);
    return {xy.x, xy.y, randomSample1D(patternid, sampleid)};
}

} // namespace stream1
} // namespace wellstrat
