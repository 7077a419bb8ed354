// SPDX-License-Identifier: Apache-2.0

#include "pixel_mask.h"

#include "texture.h"

#include <algorithm>

namespace wellstrat::render {
namespace {

constexpr double kDark = 0.01;

/// Whether the pixels from (x0, y0) to (x1, y1), the latter excluded, differ little.
bool isSmooth(const Film& film, unsigned x0, unsigned y0, unsigned x1, unsigned y1) {
    Float3 least = film.mean(x0, y0), most = least;
    for (unsigned y = y0; y < y1; ++y) {
        for (unsigned x = x0; x < x1; ++x) {
            const Float3 mean = film.mean(x, y);
            for (int c = 0; c < 3; ++c) {
                least[c] = std::min(least[c], mean[c]);
                most[c] = std::max(most[c], mean[c]);
            }
        }
    }
    for (int c = 0; c < 3; ++c) {
        const double low{least[c]}, high{most[c]};
        if (high - low > kSmoothContrast * (high + low + 2 * kDark)) return false;
    }
    return true;
}

} // namespace

PixelMask allPixels(unsigned width, unsigned height) {
    return {width, height, std::vector<uint8_t>(std::size_t{width} * height, 1)};
}

std::size_t countOf(const PixelMask& mask) {
    return static_cast<std::size_t>(std::count(mask.counts.begin(), mask.counts.end(), 1));
}

PixelMask smoothAreas(const Film& film) {
    PixelMask mask{film.width(), film.height(), {}};
    const auto first = [](unsigned at) { return std::max(at, kSmoothReach) - kSmoothReach; };
    const auto end = [](unsigned at, unsigned size) {
        return std::min(at + kSmoothReach + 1, size);
    };
    for (unsigned y = 0; y < mask.height; ++y) {
        for (unsigned x = 0; x < mask.width; ++x) {
            mask.counts.push_back(
                isSmooth(film, first(x), first(y), end(x, mask.width), end(y, mask.height)) ? 1
                                                                                            : 0);
        }
    }
    return mask;
}

PixelMask readMask(const std::string& path) {
    const Texture picture = readTexture(path, Encoding::linear);
    PixelMask mask{picture.width(), picture.height(), {}};
    for (const Float3& color : picture.pixels()) {
        mask.counts.push_back(color.x > 0 || color.y > 0 || color.z > 0 ? 1 : 0);
    }
    return mask;
}

} // namespace wellstrat::render
