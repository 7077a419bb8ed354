// SPDX-License-Identifier: Apache-2.0

#include "image_file.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

namespace area_light {

namespace {

/// IEC 61966-2-1, the sRGB transfer function.
uint8_t encodeSrgb(float linear) {
    const float value = std::min(std::max(linear, 0.0f), 1.0f);
    const float encoded =
        value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1.0f / 2.4f) - 0.055f;
    return static_cast<uint8_t>(std::lround(255.0f * encoded));
}

} // namespace

void writePng(const std::string& path, unsigned size, const std::vector<const Image*>& images) {
    std::vector<uint8_t> bytes;
    bytes.reserve(images.size() * size * size * 3);
    for (unsigned y = 0; y < size; ++y) {
        for (const Image* image : images) {
            for (unsigned x = 0; x < size; ++x) {
                const RtFloat3 color = (*image)[std::size_t{y} * size + x];
                for (float channel : {color.x, color.y, color.z}) {
                    bytes.push_back(encodeSrgb(channel));
                }
            }
        }
    }

    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(size * images.size());
    png.height = size;
    png.format = PNG_FORMAT_RGB;
    const std::string temporary = path + ".part";
    if (!png_image_write_to_file(&png, temporary.c_str(), 0, bytes.data(), 0, nullptr)) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw std::runtime_error("cannot write '" + path + "': " + png.message);
    }
    std::filesystem::rename(temporary, path);
}

} // namespace area_light
