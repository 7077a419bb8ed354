// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/picture_error.h"

#include "prefix_means.h"
#include "wellstrat/camera.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace wellstrat {
inline namespace stream1 {
namespace {

void checkPictures(const std::vector<const IntegrandPicture*>& integrands,
                   const GaussianFilter& filter) {
    for (const IntegrandPicture* integrand : integrands) {
        if (integrand->size != integrands[0]->size) {
            throw std::invalid_argument("the pictures of one call must have the same size");
        }
    }
    if (!integrands.empty() && integrands[0]->size <= 2 * filter.border()) {
        throw std::invalid_argument("pictures of " + std::to_string(integrands[0]->size) +
                                    " pixels a side have none inside borders of " +
                                    std::to_string(filter.border()));
    }
}

void addPicture(const std::vector<double>& errors, ErrorSums& sums) {
    const auto pixels = static_cast<double>(errors.size());
    double sum = 0, squares = 0;
    for (const double error : errors) {
        sum += error;
        squares += error * error;
    }
    const double meanSquare = squares / pixels;
    sums.first += sum / pixels;
    sums.second += meanSquare;
    sums.fourth += meanSquare * meanSquare;
}

} // namespace

uint32_t cameraPattern(int x, int y, uint32_t seed) {
    return cameraContext(x, y, 0, 0, seed).patternid;
}

GaussianFilter::GaussianFilter(double sigma) : sigma_(sigma) {
    if (!(sigma >= 0 && sigma <= kMaxSigma)) {
        throw std::invalid_argument("the sigma of a filter must be from 0 to 16 pixels");
    }
    const auto reach = static_cast<unsigned>(std::ceil(3 * sigma));
    double sum = 0;
    for (unsigned i = 0; i <= reach; ++i) {
        const double distance = i;
        weights_.push_back(i == 0 ? 1 : std::exp(-distance * distance / (2 * sigma * sigma)));
        sum += i == 0 ? 1 : 2 * weights_.back();
    }
    for (double& weight : weights_) weight /= sum;
}

std::vector<double> GaussianFilter::apply(const std::vector<double>& picture, unsigned size) const {
    const std::size_t reach = border(), inner = size - 2 * reach;
    std::vector<double> rows(size * inner), filtered(inner * inner);
    for (std::size_t y = 0; y < size; ++y) {
        for (std::size_t x = 0; x < inner; ++x) {
            const double* const middle = &picture[y * size + x + reach];
            double sum = weights_[0] * *middle;
            for (std::size_t i = 1; i <= reach; ++i)
                sum += weights_[i] * (middle[i] + *(middle - i));
            rows[y * inner + x] = sum;
        }
    }
    for (std::size_t y = 0; y < inner; ++y) {
        for (std::size_t x = 0; x < inner; ++x) {
            const double* const middle = &rows[(y + reach) * inner + x];
            double sum = weights_[0] * *middle;
            for (std::size_t i = 1; i <= reach; ++i) {
                sum += weights_[i] * (middle[i * inner] + *(middle - i * inner));
            }
            filtered[y * inner + x] = sum;
        }
    }
    return filtered;
}

void addPictureErrors(const PixelSource& source,
                      const std::vector<const IntegrandPicture*>& integrands,
                      const std::vector<uint32_t>& counts, const GaussianFilter& filter,
                      PatternRange seeds, ErrorSums* sums) {
    checkSubjects(integrands, counts, seeds.end);
    checkPictures(integrands, filter);
    if (integrands.empty() || counts.empty()) return;
    const unsigned size = integrands[0]->size;
    PrefixMeans means(source.points, integrands[0]->domains, counts);
    std::vector<const Integrand*> ofPixel(integrands.size());
    std::vector<std::vector<double>> errors(integrands.size() * counts.size(),
                                            std::vector<double>(std::size_t{size} * size));
    for (uint64_t seed = seeds.begin; seed < seeds.end; ++seed) {
        for (std::size_t pixel = 0; pixel < std::size_t{size} * size; ++pixel) {
            for (std::size_t k = 0; k < integrands.size(); ++k) {
                ofPixel[k] = &integrands[k]->pixels[pixel];
            }
            const uint32_t pattern =
                source.patternOf(static_cast<int>(pixel % size), static_cast<int>(pixel / size),
                                 static_cast<uint32_t>(seed));
            means.forEach(pattern, ofPixel, [&](std::size_t k, std::size_t c, double mean) {
                errors[k * counts.size() + c][pixel] = mean - ofPixel[k]->integral;
            });
        }
        for (std::size_t cell = 0; cell < errors.size(); ++cell) {
            addPicture(filter.apply(errors[cell], size), sums[cell]);
        }
    }
}

} // namespace stream1
} // namespace wellstrat
