// SPDX-License-Identifier: Apache-2.0
//
// Pictures through OpenImageIO.

#include "texture.h"
#include "color.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {
namespace {

constexpr uint64_t kMaxPixels = uint64_t{1} << 27; // 16384 x 8192; 1.5 GiB in memory

/// IEC 61966-2-1, the transfer function of sRGB.
float linearFromSrgb(float v) {
    return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f);
}

constexpr float kLargestIntensity = 1e9f; // what light multiplies it with stays finite

/// From 0 to kLargestIntensity; what is not finite becomes 0.
float asIntensity(float v) {
    return v > 0.0f && std::isfinite(v) ? std::min(v, kLargestIntensity) : 0.0f;
}

[[noreturn]] void fail(const std::string& reason) {
    const auto line = reason.substr(0, reason.find('\n'));
    throw std::runtime_error(line.empty() ? "not a picture in a known format" : line);
}

Texture readPixels(OIIO::ImageInput& input, Encoding encoding, uint64_t* replaced) {
    const OIIO::ImageSpec& spec = input.spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
        fail("has no pixels, or is no plain two-dimensional picture");
    if (spec.image_pixels() > kMaxPixels)
        fail(fmt::format("has {} x {} pixels, more than 2^27", spec.width, spec.height));

    const auto width = static_cast<unsigned>(spec.width);
    const auto height = static_cast<unsigned>(spec.height);
    const bool isColor = spec.nchannels >= 3; // one or two: gray, gray and alpha
    // Pictures of floats are linear whatever they are used for.
    const bool decode = encoding == Encoding::sRgb && !spec.format.is_floating_point();
    std::vector<Float3> pixels(std::size_t{width} * height);
    if (!input.read_image(0, 0, 0, isColor ? 3 : 1, OIIO::TypeDesc::FLOAT, pixels.data(),
                          sizeof(Float3)))
        fail(input.geterror());
    for (Float3& pixel : pixels) {
        if (!isColor) pixel.y = pixel.z = pixel.x;
        bool isChanged = false;
        for (int c = 0; c < 3; ++c) {
            const float v = asIntensity(pixel[c]);
            isChanged = isChanged || v != pixel[c];
            pixel[c] = decode ? linearFromSrgb(v) : v;
        }
        if (isChanged && replaced) ++*replaced;
    }
    return {width, height, std::move(pixels)};
}

unsigned wrap(int i, unsigned size) {
    return i < 0 ? size - 1 : static_cast<unsigned>(i) >= size ? 0 : static_cast<unsigned>(i);
}

/// The two pixels of a row or column between which a coordinate falls, and how far it is from the
/// first to the second.
struct Neighbors {
    unsigned first, second;
    float fraction;
};

Neighbors neighbors(float coordinate, unsigned size) {
    const float position = (coordinate - std::floor(coordinate)) * static_cast<float>(size) - 0.5f;
    const float below = std::floor(position);
    const int first = static_cast<int>(below);
    return {wrap(first, size), wrap(first + 1, size), position - below};
}

} // namespace

Texture::Texture(unsigned width, unsigned height, std::vector<Float3> pixels)
    : width_(width), height_(height), pixels_(std::move(pixels)) {
    if (pixels_.empty() || pixels_.size() != std::size_t{width} * height)
        throw std::invalid_argument(fmt::format("a texture of {} x {} cannot have {} pixels", width,
                                                height, pixels_.size()));
}

Float3 Texture::lookup(Float2 uv) const {
    const Neighbors x = neighbors(uv.x, width_), y = neighbors(uv.y, height_);
    return lerp(lerp(pixel(x.first, y.first), pixel(x.second, y.first), x.fraction),
                lerp(pixel(x.first, y.second), pixel(x.second, y.second), x.fraction), y.fraction);
}

Texture readTexture(const std::string& path, Encoding encoding, uint64_t* replaced) {
    const auto input = OIIO::ImageInput::open(path);
    if (!input) fail(OIIO::geterror());
    return readPixels(*input, encoding, replaced);
}

Texture readTexture(const std::vector<unsigned char>& bytes, const std::string& formatHint,
                    Encoding encoding) {
    OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::open("embedded." + formatHint, nullptr, &reader);
    if (!input) fail(OIIO::geterror());
    return readPixels(*input, encoding, nullptr);
}

void readTexturesInOneThread() {
    OIIO::attribute("threads", 1);
    // OpenEXR's C++ library has threads of its own, its C library none.
    OIIO::attribute("openexr:core", 1);
}

} // namespace wellstrat::render
