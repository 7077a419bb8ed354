// SPDX-License-Identifier: Apache-2.0
//
// Pictures through OpenImageIO.

#include "texture.h"
#include "color.h"
#include "webp.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {
namespace {

constexpr uint64_t kMaxPixels = uint64_t{1} << 27; // 16384 x 8192; 1.5 GiB in memory

constexpr float kLargestIntensity = 1e9f; // what light multiplies it with stays finite

[[noreturn]] void fail(const std::string& reason) {
    const auto line = reason.substr(0, reason.find('\n'));
    throw std::runtime_error(line.empty() ? "not a picture in a known format" : line);
}

/// A file, or what `memory` has if that is not null, whatever format its name speaks of.
OIIO::ImageInput::unique_ptr opened(const std::string& name, OIIO::Filesystem::IOProxy* memory) {
    OIIO::ImageSpec wanted;
    wanted["oiio:UnassociatedAlpha"] = 1; // or colors are multiplied by alpha
    // Without this, ImageInput 2.4 takes no note of the memory where there are wishes.
    if (memory) wanted.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &memory);
    auto input = OIIO::ImageInput::create(name, true, &wanted, memory);
    if (!input) fail(OIIO::geterror());
    return input;
}

/// What kind of numbers a picture has.
struct Format {
    int channels; ///< one or two: gray, gray and alpha
    int alpha;    ///< which of them; negative: none
    bool isFloat;
};

bool isFinite(Float3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The largest finite value, from 0 to kLargestIntensity.
float largestFinite(const std::vector<Float3>& pixels) {
    float largest = 0;
    for (const Float3& pixel : pixels)
        for (int c = 0; c < 3; ++c)
            if (std::isfinite(pixel[c])) largest = std::max(largest, pixel[c]);
    return std::min(largest, kLargestIntensity);
}

/// Makes all values those of light, as `readTexture` says.
ReplacedPixels makeUsable(std::vector<Float3>& pixels) {
    ReplacedPixels replaced;
    replaced.largestFinite = largestFinite(pixels);
    for (Float3& pixel : pixels) {
        const Float3 stored = pixel;
        for (int c = 0; c < 3; ++c) {
            if (std::isnan(pixel[c]) || pixel[c] > FLT_MAX)
                pixel[c] = replaced.largestFinite;
            else
                pixel[c] = pixel[c] > 0.0f ? std::min(pixel[c], kLargestIntensity) : 0.0f;
        }
        if (!isFinite(stored))
            ++replaced.notFinite;
        else if (!(stored == pixel))
            ++replaced.outOfRange;
    }
    return replaced;
}

/// Makes a texture of a picture with the colors or the alpha of its pixels, three numbers each.
/// `fill` gets `pixels`, the first channel that is wanted, and how many of them.
template <typename Fill>
Texture textureOf(uint64_t width, uint64_t height, Format format, Encoding encoding,
                  Channels channels, ReplacedPixels* replaced, Fill fill) {
    if (width * height > kMaxPixels)
        fail(fmt::format("has {} x {} pixels, more than 2^27", width, height));
    const auto columns = static_cast<unsigned>(width), rows = static_cast<unsigned>(height);
    std::vector<Float3> pixels(width * height, Float3(1.0f));
    const bool isColors = channels == Channels::colors;
    const bool isAlpha = !isColors && format.alpha >= 0;
    if (channels == Channels::alpha && !isAlpha) return {columns, rows, std::move(pixels)};
    const bool isGray = isAlpha || format.channels < 3;
    fill(pixels, isAlpha ? format.alpha : 0, isGray ? 1 : 3);
    if (isGray)
        for (Float3& pixel : pixels) pixel.y = pixel.z = pixel.x;
    const ReplacedPixels changed = makeUsable(pixels);
    if (replaced) *replaced = changed;
    // Pictures of floats are linear whatever they are used for.
    if (encoding == Encoding::sRgb && isColors && !format.isFloat)
        for (Float3& pixel : pixels) pixel = linearFromSrgb(pixel);
    if (!isColors && !isGray)
        for (Float3& pixel : pixels) pixel = Float3(luminance(pixel));
    return {columns, rows, std::move(pixels)};
}

Texture readPixels(OIIO::ImageInput& input, Encoding encoding, Channels channels,
                   ReplacedPixels* replaced) {
    const OIIO::ImageSpec& spec = input.spec();
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
        fail("has no pixels, or is no plain two-dimensional picture");
    const auto fill = [&](std::vector<Float3>& pixels, int first, int count) {
        if (!input.read_image(0, 0, first, first + count, OIIO::TypeDesc::FLOAT, pixels.data(),
                              sizeof(Float3)))
            fail(input.geterror());
    };
    return textureOf(static_cast<uint64_t>(spec.width), static_cast<uint64_t>(spec.height),
                     {spec.nchannels, spec.alpha_channel, spec.format.is_floating_point()},
                     encoding, channels, replaced, fill);
}

Texture readWebp(const std::vector<unsigned char>& bytes, Encoding encoding, Channels channels) {
    const WebpPicture picture = decodeWebp(bytes, kMaxPixels);
    const auto fill = [&](std::vector<Float3>& pixels, int first, int count) {
        for (std::size_t i = 0; i < pixels.size(); ++i)
            for (int c = 0; c < count; ++c)
                pixels[i][c] =
                    static_cast<float>(picture.rgba[4 * i + static_cast<std::size_t>(first + c)]) /
                    255.0f;
    };
    return textureOf(picture.width, picture.height, {4, 3, false}, encoding, channels, nullptr,
                     fill);
}

/// All of a file that begins as WebP pictures do; nothing of others.
std::vector<unsigned char> webpBytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    char head[12] = {};
    file.read(head, sizeof head);
    if (!isWebp(reinterpret_cast<const unsigned char*>(head), sizeof head)) return {};
    file.seekg(0);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// The pixel in which a place in [0, size] is, or next to it: -1 and `size` are beyond the border.
unsigned wrapped(int i, unsigned size, Wrap wrap) {
    if (i < 0) return wrap == Wrap::repeat ? size - 1 : 0;
    if (static_cast<unsigned>(i) >= size) return wrap == Wrap::repeat ? 0 : size - 1;
    return static_cast<unsigned>(i);
}

/// The coordinate in [0, 1] where the picture has the color for `coordinate`. At the borders of a
/// mirrored picture a pixel is its own neighbor, as at those of a clamped one.
float inPicture(float coordinate, Wrap wrap) {
    if (wrap == Wrap::clamp) return std::min(std::max(coordinate, 0.0f), 1.0f);
    if (wrap == Wrap::repeat) return coordinate - std::floor(coordinate);
    const float inPair = coordinate - 2.0f * std::floor(0.5f * coordinate);
    return inPair > 1.0f ? 2.0f - inPair : inPair;
}

/// The two pixels of a row or column between which a coordinate falls, and how far it is from the
/// first to the second.
struct Neighbors {
    unsigned first, second;
    float fraction;
};

Neighbors neighborsAt(float coordinateInPicture, unsigned size, Wrap wrap) {
    const float position = coordinateInPicture * static_cast<float>(size) - 0.5f;
    const float below = std::floor(position);
    const int first = static_cast<int>(below);
    return {wrapped(first, size, wrap), wrapped(first + 1, size, wrap), position - below};
}

Neighbors neighbors(float coordinate, unsigned size, Wrap wrap) {
    if (wrap == Wrap::repeat) // nearly always: worth to be compiled for itself
        return neighborsAt(coordinate - std::floor(coordinate), size, Wrap::repeat);
    return neighborsAt(inPicture(coordinate, wrap), size, wrap);
}

unsigned nearest(float coordinate, unsigned size, Wrap wrap) {
    const float position = inPicture(coordinate, wrap) * static_cast<float>(size);
    return wrapped(static_cast<int>(position), size, wrap);
}

} // namespace

Texture::Texture(unsigned width, unsigned height, std::vector<Float3> pixels)
    : width_(width), height_(height), pixels_(std::move(pixels)) {
    if (pixels_.empty() || pixels_.size() != std::size_t{width} * height)
        throw std::invalid_argument(fmt::format("a texture of {} x {} cannot have {} pixels", width,
                                                height, pixels_.size()));
}

Float3 Texture::lookup(Float2 uv, TextureSampling sampling) const {
    if (sampling.nearest)
        return pixel(nearest(uv.x, width_, sampling.u), nearest(uv.y, height_, sampling.v));
    const Neighbors x = neighbors(uv.x, width_, sampling.u);
    const Neighbors y = neighbors(uv.y, height_, sampling.v);
    return lerp(lerp(pixel(x.first, y.first), pixel(x.second, y.first), x.fraction),
                lerp(pixel(x.first, y.second), pixel(x.second, y.second), x.fraction), y.fraction);
}

Texture readTexture(const std::string& path, Encoding encoding, Channels channels,
                    ReplacedPixels* replaced) {
    if (kHasWebp)
        if (const auto bytes = webpBytes(path); !bytes.empty())
            return readWebp(bytes, encoding, channels);
    return readPixels(*opened(path, nullptr), encoding, channels, replaced);
}

Texture readTexture(const std::vector<unsigned char>& bytes, const std::string& formatHint,
                    Encoding encoding, Channels channels) {
    if (kHasWebp && isWebp(bytes.data(), bytes.size())) return readWebp(bytes, encoding, channels);
    OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
    return readPixels(*opened("embedded." + formatHint, &reader), encoding, channels, nullptr);
}

void readTexturesInOneThread() {
    OIIO::attribute("threads", 1);
    // OpenEXR's C++ library has threads of its own, its C library none.
    OIIO::attribute("openexr:core", 1);
}

} // namespace wellstrat::render
