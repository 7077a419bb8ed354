// SPDX-License-Identifier: Apache-2.0

#include "film_error.h"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace wellstrat::render {
namespace {

constexpr double kDark = 0.01;

void checkSizes(const Film& film, const Film& reference, const PixelMask& mask) {
    const auto differs = [&film](const auto& width, const auto& height) {
        return width != film.width() || height != film.height();
    };
    if (differs(reference.width(), reference.height()) || differs(mask.width, mask.height)) {
        throw std::invalid_argument("images of different sizes cannot be compared");
    }
}

/// The differences of the means of a color, 0 for pixels that do not count.
std::vector<double> differencesOf(const Film& film, const Film& reference, const PixelMask& mask,
                                  int color) {
    std::vector<double> differences = meansOf(film, color);
    const std::vector<double> right = meansOf(reference, color);
    for (std::size_t i = 0; i < differences.size(); ++i) {
        differences[i] = mask.counts[i] ? differences[i] - right[i] : 0;
    }
    return differences;
}

double sumOfSquares(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value * value;
    return sum;
}

double sumOfRelativeSquares(const std::vector<double>& differences,
                            const std::vector<double>& right) {
    double sum = 0;
    for (std::size_t i = 0; i < differences.size(); ++i) {
        sum += differences[i] * differences[i] / (right[i] * right[i] + kDark);
    }
    return sum;
}

} // namespace

ErrorMeasure errorMeasure(PixelMask mask, const std::vector<double>& sigmas) {
    ErrorMeasure measure{std::move(mask), {}};
    for (const double sigma : sigmas) measure.blurs.emplace_back(sigma, measure.mask);
    return measure;
}

FilmError filmError(const Film& film, const Film& reference, const ErrorMeasure& measure) {
    checkSizes(film, reference, measure.mask);
    const std::size_t pixels = countOf(measure.mask);
    if (pixels == 0) throw std::invalid_argument("no pixel of the image counts");
    double squares = 0, relative = 0;
    std::vector<double> filtered(measure.blurs.size());
    for (int c = 0; c < 3; ++c) {
        const std::vector<double> differences = differencesOf(film, reference, measure.mask, c);
        squares += sumOfSquares(differences);
        relative += sumOfRelativeSquares(differences, meansOf(reference, c));
        for (std::size_t k = 0; k < filtered.size(); ++k) {
            std::vector<double> values = differences;
            measure.blurs[k].apply(values);
            filtered[k] += sumOfSquares(values);
        }
    }
    const double count = 3.0 * static_cast<double>(pixels);
    for (double& sum : filtered) sum = std::sqrt(sum / count);
    return {std::sqrt(squares / count), relative / count, std::move(filtered)};
}

FilmError filmError(const Film& film, const Film& reference) {
    return filmError(film, reference, {allPixels(film.width(), film.height()), {}});
}

void addErrors(const Film& film, const Film& reference, const PixelMask& mask,
               ImagePeriodogram& spectrum) {
    checkSizes(film, reference, mask);
    for (int c = 0; c < 3; ++c) spectrum.add(differencesOf(film, reference, mask, c));
}

} // namespace wellstrat::render
