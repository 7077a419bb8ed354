// SPDX-License-Identifier: Apache-2.0

#include "crops.h"

#include <algorithm>

namespace wellstrat::cli {
namespace {

constexpr unsigned kCropSize = 96;
constexpr unsigned kEnlargement = 4;
constexpr double kDark = 0.01; ///< as in the relative MSE

double clampedDifference(const render::Film& film, const render::Film& reference, unsigned x,
                         unsigned y) {
    const Float3 a = film.mean(x, y), b = reference.mean(x, y);
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
        const double right{b[c]}, d = double{a[c]} - right;
        sum += std::min(d * d / (right * right + kDark), 1.0);
    }
    return sum;
}

} // namespace

Crop worstCrop(const render::Film& film, const render::Film& reference) {
    const unsigned width = std::min(kCropSize, film.width());
    const unsigned height = std::min(kCropSize, film.height());
    Crop worst{0, 0, width, height};
    double most = -1;
    for (unsigned y = 0; y + height <= film.height(); y += kCropSize / 4) {
        for (unsigned x = 0; x + width <= film.width(); x += kCropSize / 4) {
            double sum = 0;
            for (unsigned j = 0; j < height; ++j) {
                for (unsigned i = 0; i < width; ++i) {
                    sum += clampedDifference(film, reference, x + i, y + j);
                }
            }
            if (sum <= most) continue;
            most = sum;
            worst = {x, y, width, height};
        }
    }
    return worst;
}

render::Film enlarged(const render::Film& film, const Crop& crop) {
    render::Film large(crop.width * kEnlargement, crop.height * kEnlargement);
    for (unsigned y = 0; y < large.height(); ++y) {
        for (unsigned x = 0; x < large.width(); ++x) {
            large.pixel(x, y) = film.pixel(crop.x + x / kEnlargement, crop.y + y / kEnlargement);
        }
    }
    return large;
}

std::vector<render::Film> blurredCrops(const render::Film& film,
                                       const std::vector<render::GaussianBlur>& blurs,
                                       const Crop& crop) {
    std::vector<render::Film> crops;
    crops.reserve(blurs.size());
    for (const render::GaussianBlur& blur : blurs) {
        crops.push_back(enlarged(render::blurred(film, blur), crop));
    }
    return crops;
}

} // namespace wellstrat::cli
