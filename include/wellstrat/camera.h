// SPDX-License-Identifier: Apache-2.0
//
// Where sample contexts begin: at a pixel of a frame.

#pragma once

#include "wellstrat/domain.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

namespace detail {

/// Keep the keys of frames and of seeds apart from each other and from the scrambles of domains:
/// "came" and "seed" in ASCII.
constexpr uint32_t kCameraKey = 0x63616d65u;
constexpr uint32_t kSeedKey = 0x73656564u;

} // namespace detail

/// The domains that every camera has, to be derived from the context of `cameraContext`. The
/// values are hexadecimal digits of the fraction of pi, so that nobody has chosen them.
constexpr Scramble kPixelFilterScramble = static_cast<Scramble>(0x243f6a88u);
constexpr Scramble kLensScramble = static_cast<Scramble>(0x85a308d3u);
constexpr Scramble kTimeScramble = static_cast<Scramble>(0x13198a2eu);

/// The context of sample `sampleid` of pixel (x, y) in `frame`: samples of one pixel share a
/// pattern, and count up from sampleid 0.
///
/// x and y count modulo 2^16. Within a frame all 2^32 pixels have different patterns, so that any
/// image of up to 65536 x 65536 pixels has no two alike, with or without negative coordinates for
/// overscan. The frame is the key of the mapping and not added to the pixel, so noise does not
/// slide over the image from frame to frame.
///
/// All this holds for each `seed`, which is for images of one frame with independent noise. Seed 0
/// changes nothing; any other permutes the pixels before the frame does, with a key of its own. So
/// a frame and a seed cannot stand for another frame with another seed.
///
/// Frames that are averaged over time do better in one pattern, with the same `frame` and sampleids
/// that go on from frame to frame without gaps: docs/concepts.md, "Frames and passes".
WELLSTRAT_HOST_DEVICE constexpr SampleCtx cameraContext(int x, int y, unsigned frame,
                                                        unsigned sampleid, unsigned seed = 0) {
    uint32_t pixel = (static_cast<uint32_t>(x) & 0xffffu) | (static_cast<uint32_t>(y) << 16);
    if (seed != 0) pixel = permuteBits(pixel, permutationKey(seed ^ detail::kSeedKey));
    return {permuteBits(pixel, permutationKey(frame ^ detail::kCameraKey)), sampleid};
}

} // namespace stream1
} // namespace wellstrat
