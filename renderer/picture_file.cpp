// SPDX-License-Identifier: Apache-2.0
#include "picture_file.h"

#include "color.h"
#include "image_encoder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace wellstrat::render {

namespace {

float filmicCurve(float x) {
    x *= 0.6f; // the factor by which the curve matches ACES
    return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f);
}

/// 8 bits of sRGB, IEC 61966-2-1.
unsigned char encodeSrgb(float x) {
    const float encoded = x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1.0f / 2.4f) - 0.055f;
    return static_cast<unsigned char>(std::lround(255.0f * encoded));
}

/// Of each pixel, color(x, y) and alpha(x, y) if there is an alpha.
template <typename T, typename Color, typename Alpha>
std::string encode(const Film& film, const std::string& suffix, OIIO::ImageSpec spec,
                   const Color& color, const Alpha& alpha) {
    const bool hasAlpha = spec.nchannels == 4;
    ImageEncoder encoder(suffix, std::move(spec));
    std::vector<T> row;
    for (unsigned y = 0; y < film.height(); ++y) {
        row.clear();
        for (unsigned x = 0; x < film.width(); ++x) {
            for (const T channel : color(x, y)) row.push_back(channel);
            if (hasAlpha) row.push_back(alpha(x, y));
        }
        encoder.write(y, y + 1, row.data());
    }
    return encoder.finish();
}

} // namespace

Float3 displayed(Float3 light, const Display& display) {
    light *= std::exp2(display.exposure);
    if (display.isFilmic) // beyond 1e6 the curve is flat, and its squares overflow
        for (int c = 0; c < 3; ++c) light[c] = filmicCurve(std::min(light[c], 1e6f));
    return clamp01(light);
}

std::string encodePicture(const Film& film, const std::string& suffix, const Display& display) {
    const bool isJpeg = suffix == ".jpg" || suffix == ".jpeg",
               isScreen = isJpeg || suffix == ".png";
    if (!isScreen && suffix != ".hdr" && suffix != ".exr")
        throw std::runtime_error(fmt::format("no picture format has the suffix '{}'", suffix));
    const bool hasAlpha = isTransparent(film) && (suffix == ".png" || suffix == ".exr");
    OIIO::ImageSpec spec(static_cast<int>(film.width()), static_cast<int>(film.height()),
                         hasAlpha ? 4 : 3,
                         isScreen ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    if (isJpeg) spec.attribute("Compression", "jpeg:95");
    if (!isScreen) {
        const auto color = [&](unsigned x, unsigned y) {
            const Float3 mean = film.mean(x, y);
            return std::array<float, 3>{mean.x, mean.y, mean.z};
        };
        return encode<float>(film, suffix, std::move(spec), color,
                             [&](unsigned x, unsigned y) { return film.alpha(x, y); });
    }
    if (hasAlpha) spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto color = [&](unsigned x, unsigned y) {
        Float3 mean = film.mean(x, y);
        if (hasAlpha && film.alpha(x, y) > 0.0f) mean /= film.alpha(x, y);
        const Float3 shown = displayed(mean, display);
        return std::array<unsigned char, 3>{encodeSrgb(shown.x), encodeSrgb(shown.y),
                                            encodeSrgb(shown.z)};
    };
    return encode<unsigned char>(film, suffix, std::move(spec), color, [&](unsigned x, unsigned y) {
        return static_cast<unsigned char>(std::lround(255.0f * film.alpha(x, y)));
    });
}

} // namespace wellstrat::render
