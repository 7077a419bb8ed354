// SPDX-License-Identifier: Apache-2.0
//
// The contexts of BlueProgressive (blue.h): where they begin, and how those of a new domain follow
// from their parent's.
//
// A patternid has two parts. The *state* says which domain it is, and is the same for all pixels of
// a tile of 64 x 64; the *place* says where in the tile the pixel is, and is the same for all
// domains:
//
//     bit  31          state          12 11   place   0
//                                        y % 64  x % 64
//
// So all pixels of a tile know what the others draw in a domain, and that is what makes their
// errors cancel. SampleCtx::NewDomain, which knows nothing of it, mixes the two: sound, but white.

#pragma once

#include "wellstrat/domain.h"
#include "wellstrat/hash.h"
#include "wellstrat/rank.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

namespace detail {

constexpr uint32_t kPlaceBits = kRanks - 1, kStateBits = ~kPlaceBits;

/// Keep the keys of seeds and of sampleids apart from scrambles: "blue" and "dist" in ASCII.
constexpr uint32_t kBlueKey = 0x626c7565u;
constexpr uint32_t kBlueDistribKey = 0x64697374u;

/// For each key a bijection of the states, the upper 20 bits of a word; drops the place. Two
/// domains share as many states as random permutations would (tests/unit/blue_domain_test.cpp),
/// which multiplying once does not give.
WELLSTRAT_HOST_DEVICE constexpr uint32_t permuteState(uint32_t patternid, DerivationKey key) {
    uint32_t state = ((patternid ^ key.mask) & kStateBits) * kGolden;
    state ^= state >> 10 & kStateBits;
    state *= key.multiplier;
    return state ^ (state >> 10 & kStateBits);
}

/// The state that permuteState maps to that of `patternid`. It undoes the steps one by one: the
/// shifts are their own inverses in 20 bits.
WELLSTRAT_HOST_DEVICE constexpr uint32_t unpermuteState(uint32_t patternid, DerivationKey key) {
    uint32_t state = patternid & kStateBits;
    state ^= state >> 10 & kStateBits;
    state *= oddInverse(key.multiplier);
    state ^= state >> 10 & kStateBits;
    return (state * oddInverse(kGolden) ^ key.mask) & kStateBits;
}

/// What distribution adds to a state, by exclusive or: another state for each of 2^20 sampleids.
WELLSTRAT_HOST_DEVICE constexpr uint32_t distribState(uint32_t sampleid) {
    return (sampleid ^ (sampleid >> 20) * kGolden) << 12;
}

/// The place of a pixel in a tile that is shifted by the upper 12 bits of a hash: on a torus, so a
/// tile of the picture is a whole tile always.
WELLSTRAT_HOST_DEVICE constexpr uint32_t shiftedPlace(uint32_t place, uint32_t hash) {
    constexpr uint32_t kX = 63u, kY = 63u << 6;
    const uint32_t shift = hash >> 20;
    return ((place + shift) & kX) | (((place & kY) + shift) & kY);
}

/// The place with x and y exchanged.
WELLSTRAT_HOST_DEVICE constexpr uint32_t transposedPlace(uint32_t place) {
    return (place & 63u) << 6 | place >> 6;
}

/// The place in a tile that is shifted, flipped and transposed by the upper 15 bits of a hash.
WELLSTRAT_HOST_DEVICE constexpr uint32_t movedPlace(uint32_t place, uint32_t hash) {
    uint32_t moved = shiftedPlace(place, hash);
    if ((hash >> 19 & 1u) != 0) moved ^= 63u;
    if ((hash >> 18 & 1u) != 0) moved ^= 63u << 6;
    return (hash >> 17 & 1u) != 0 ? transposedPlace(moved) : moved;
}

} // namespace detail

/// The pattern of the domain `scramble` under `patternid`, as BlueProgressive derives it: another
/// state at the same place. For a fixed scramble a bijection.
WELLSTRAT_HOST_DEVICE constexpr unsigned deriveBluePattern(unsigned patternid, Scramble scramble) {
    return detail::permuteState(patternid, derivationKey(scramble)) |
           (patternid & detail::kPlaceBits);
}

/// The pattern of which deriveBluePattern(., scramble) is `patternid`. For tests and tools.
WELLSTRAT_HOST_DEVICE constexpr unsigned parentBluePattern(unsigned patternid, Scramble scramble) {
    return detail::unpermuteState(patternid, derivationKey(scramble)) |
           (patternid & detail::kPlaceBits);
}

/// The contexts of a new domain, as SampleCtx::NewDomainSplit and NewDomainDistrib are, for
/// BlueProgressive. Distribution tells the sampleids apart by the state, as all pixels of a tile
/// do, so visits know nothing of each other and pixels still do. The first 2^20 visits of a domain
/// have states of their own.
WELLSTRAT_HOST_DEVICE constexpr SampleCtx newBlueDomainSplit(SampleCtx parent, Scramble scramble,
                                                             unsigned newnumsamples) {
    return {deriveBluePattern(parent.patternid, scramble), parent.sampleid * newnumsamples};
}
WELLSTRAT_HOST_DEVICE constexpr SampleCtx newBlueDomainDistrib(SampleCtx parent, Scramble scramble,
                                                               unsigned newsampleid) {
    const unsigned domain = deriveBluePattern(parent.patternid, scramble);
    return {deriveBluePattern(domain ^ detail::distribState(parent.sampleid),
                              static_cast<Scramble>(detail::kBlueDistribKey)),
            newsampleid};
}

/// The context of sample `sampleid` of pixel (x, y), for a RixRNG whose generator is a
/// BlueProgressive. It takes the place of cameraContext: samples of one pixel share a pattern, and
/// count up from sampleid 0.
///
/// Pixels of one `seed` know of each other; images of different seeds are independent. The frames
/// of a sequence share a seed and go on in the sampleid, without gaps. A crop of an image, and its
/// overscan, has the image's samples, as long as pixels keep their coordinates.
///
/// x and y count modulo 2^16, with or without a sign. All tiles of 65536 x 65536 pixels have states
/// of their own, and so all pixels patterns of their own.
WELLSTRAT_HOST_DEVICE constexpr SampleCtx blueContext(int x, int y, unsigned seed,
                                                      unsigned sampleid) {
    const uint32_t column = static_cast<uint32_t>(x), row = static_cast<uint32_t>(y);
    const uint32_t tile = (column >> 6 & 1023u) | (row >> 6 & 1023u) << 10;
    const uint32_t state = detail::permuteState(
        tile << 12, derivationKey(static_cast<Scramble>(seed ^ detail::kBlueKey)));
    const uint32_t place = (column & 63u) | (row & 63u) << 6;
    return {state | detail::movedPlace(place, wellstrat::mixBits(state ^ detail::kBlueKey)),
            sampleid};
}

} // namespace stream1
} // namespace wellstrat
