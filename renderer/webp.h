// SPDX-License-Identifier: Apache-2.0
//
// WebP pictures by libwebp. OpenImageIO 2.4 reads them too, but always multiplies their colors by
// alpha.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat::render {

/// Can they be read?
#if WELLSTRAT_WEBP
constexpr bool kHasWebp = true;
#else
constexpr bool kHasWebp = false;
#endif

/// Do these bytes begin as a WebP picture does?
bool isWebp(const unsigned char* bytes, std::size_t size);

struct WebpPicture {
    unsigned width = 0, height = 0;
    std::vector<uint8_t> rgba; ///< row by row, the top row first; alpha is not in the colors
};

/// Throws std::runtime_error if the bytes are no such picture, or of more than `mostPixels`.
WebpPicture decodeWebp(const std::vector<unsigned char>& bytes, uint64_t mostPixels);

} // namespace wellstrat::render
