// SPDX-License-Identifier: Apache-2.0

#include "image_file.h"

#include "srgb.h"

#include <png.h>

#include <filesystem>
#include <stdexcept>

namespace area_light {

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
