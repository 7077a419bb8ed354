// SPDX-License-Identifier: Apache-2.0

#include "measure.h"

#include <cmath>
#include <cstddef>

namespace wellstrat::cli {
namespace {

double square(double x) { return x * x; }

struct RootMeanSquare {
    double value, standardError;
};

/// From the mean squares of the differences of K images from their mean: those of the expectation
/// are larger by K / (K - 1).
RootMeanSquare errorOfOne(const std::vector<double>& squares) {
    const auto count = static_cast<double>(squares.size());
    double sum = 0, deviations = 0;
    for (const double x : squares) sum += x;
    for (const double x : squares) deviations += square(x - sum / count);
    if (sum == 0) return {0, 0};
    const double value = std::sqrt(sum / (count - 1));
    const double relative = std::sqrt(deviations / (count - 1) / count) / (sum / count);
    return {value, value * relative / 2}; // the root has half the relative error
}

/// Measures the error of one image by how `films` differ from their mean.
MeasuredErrors measureSpread(const FilmsBySeed& films, const render::Film& mean,
                             const render::ErrorMeasure& measure) {
    std::vector<double> squares, relative;
    std::vector<std::vector<double>> filtered(measure.blurs.size());
    for (const render::Film& film : films) {
        const render::FilmError error = render::filmError(film, mean, measure);
        squares.push_back(square(error.rmse));
        relative.push_back(error.relativeMse);
        for (std::size_t k = 0; k < filtered.size(); ++k) {
            filtered[k].push_back(square(error.filtered[k]));
        }
    }
    const RootMeanSquare plain = errorOfOne(squares);
    MeasuredErrors errors{{plain.value, square(errorOfOne(relative).value), {}},
                          Uncertainty{plain.standardError, {}},
                          {}};
    for (const std::vector<double>& values : filtered) {
        const RootMeanSquare blurred = errorOfOne(values);
        errors.error.filtered.push_back(blurred.value);
        errors.uncertainty->filtered.push_back(blurred.standardError);
    }
    return errors;
}

} // namespace

render::Film meanOf(const FilmsBySeed& films) {
    render::Film sum = films.front();
    for (std::size_t k = 1; k < films.size(); ++k) sum.add(films[k]);
    return sum;
}

MeasuredErrors measureErrors(const FilmsBySeed& films, const render::Film& reference,
                             const render::ErrorMeasure& measure) {
    MeasuredErrors errors =
        films.size() > 1
            ? measureSpread(films, reference, measure)
            : MeasuredErrors{render::filmError(films.front(), reference, measure), {}, {}};
    ImagePeriodogram spectrum(reference.width(), reference.height());
    for (const render::Film& film : films) {
        render::addErrors(film, reference, measure.mask, spectrum);
    }
    errors.spectrum = radialPower(spectrum);
    return errors;
}

} // namespace wellstrat::cli
