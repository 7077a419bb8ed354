// SPDX-License-Identifier: Apache-2.0

#include "webp.h"

#include <cstring>
#include <stdexcept>

#if WELLSTRAT_WEBP
#include <webp/decode.h>
#endif

namespace wellstrat::render {

bool isWebp(const unsigned char* bytes, std::size_t size) {
    return size >= 12 && std::memcmp(bytes, "RIFF", 4) == 0 &&
           std::memcmp(bytes + 8, "WEBP", 4) == 0;
}

#if WELLSTRAT_WEBP

WebpPicture decodeWebp(const std::vector<unsigned char>& bytes, uint64_t mostPixels) {
    int width = 0, height = 0;
    if (WebPGetInfo(bytes.data(), bytes.size(), &width, &height) == 0)
        throw std::runtime_error("not a WebP picture");
    WebpPicture picture{static_cast<unsigned>(width), static_cast<unsigned>(height), {}};
    const uint64_t pixels = uint64_t{picture.width} * picture.height;
    if (pixels > mostPixels) throw std::runtime_error("has too many pixels");
    picture.rgba.resize(4 * pixels);
    if (!WebPDecodeRGBAInto(bytes.data(), bytes.size(), picture.rgba.data(), picture.rgba.size(),
                            4 * width))
        throw std::runtime_error("the WebP picture is damaged");
    return picture;
}

#else

WebpPicture decodeWebp(const std::vector<unsigned char>&, uint64_t) {
    throw std::runtime_error("this program was built without libwebp");
}

#endif

} // namespace wellstrat::render
