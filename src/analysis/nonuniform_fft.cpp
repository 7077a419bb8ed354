// SPDX-License-Identifier: Apache-2.0

#include "nonuniform_fft.h"

#include "fourier_grid.h"
#include "point_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// Cells to each side of a point that its Gaussian reaches. With an oversampling of 2, 12 give 12
/// digits (Greengard, Lee 2004, section 2).
constexpr std::size_t kReach = 12;
constexpr std::size_t kWidth = 2 * kReach;

/// A Gaussian in units of cells: exp(-decay t^2) at a distance of t cells.
struct Gaussian {
    explicit Gaussian(double decayPerCell) : decay(decayPerCell) {
        for (std::size_t k = 0; k < kWidth; ++k) {
            const double t = static_cast<double>(k) - static_cast<double>(kReach - 1);
            atCells[k] = std::exp(-decay * t * t);
        }
    }

    double decay;
    std::array<double, kWidth> atCells;
};

/// The part of a point's Gaussian that belongs to one axis.
struct Spread {
    /// With f the distance of the point from the cell at or below it, and m = k - kReach + 1, cell
    /// k has the weight exp(-decay (f - m)^2), which is exp(-decay f^2) exp(2 decay f)^m times the
    /// Gaussian at m (Greengard, Lee 2004, equation 12): two exponentials instead of one a cell.
    Spread(double x, std::size_t side, const Gaussian& gaussian) {
        const double scaled = x * static_cast<double>(side);
        const double below = std::floor(scaled);
        const double f = scaled - below;
        first = (static_cast<std::size_t>(below) + side + 1 - kReach) % side;
        const double step = std::exp(2 * gaussian.decay * f);
        double factor = std::exp(-gaussian.decay * f * (f + 2 * (kReach - 1)));
        for (std::size_t k = 0; k < kWidth; ++k, factor *= step) {
            weights[k] = factor * gaussian.atCells[k];
        }
    }

    std::size_t first;
    std::array<double, kWidth> weights;
};

void addPoint(FourierGrid& grid, std::size_t side, const Spread& x, const Spread& y) {
    const std::size_t beforeWrap = std::min(kWidth, side - x.first);
    for (std::size_t j = 0; j < kWidth; ++j) {
        double* const row = grid.row((y.first + j) % side);
        const double weight = y.weights[j];
        for (std::size_t k = 0; k < beforeWrap; ++k) row[x.first + k] += weight * x.weights[k];
        for (std::size_t k = beforeWrap; k < kWidth; ++k) {
            row[k - beforeWrap] += weight * x.weights[k];
        }
    }
}

} // namespace

std::vector<std::complex<double>> planeSums(const UnitPoints& points, int maxFrequency) {
    const UnitPoints ordered = inCellOrder(points);
    // `modes` frequencies an axis, twice as many cells.
    const std::size_t modes =
        std::max<std::size_t>(2 * static_cast<std::size_t>(maxFrequency) + 2, kWidth);
    const std::size_t side = 2 * modes;
    const double tau = kPi * kReach / (static_cast<double>(modes * modes) * 2 * (2 - 0.5));
    const double cell = 2 * kPi / static_cast<double>(side);
    const Gaussian gaussian(cell * cell / (4 * tau));
    FourierGrid grid(side, side);
    for (std::size_t i = 0; i < ordered.count(); ++i) {
        addPoint(grid, side, Spread(ordered.coordinate(0)[i], side, gaussian),
                 Spread(ordered.coordinate(1)[i], side, gaussian));
    }
    grid.transform();

    std::vector<std::complex<double>> sums;
    sums.reserve(static_cast<std::size_t>(2 * maxFrequency + 1) *
                 static_cast<std::size_t>(maxFrequency + 1));
    const double scale = kPi / tau / static_cast<double>(side * side);
    for (int fy = 0; fy <= maxFrequency; ++fy) {
        for (int fx = -maxFrequency; fx <= maxFrequency; ++fx) {
            sums.push_back(grid.at(fx, fy) * (scale * std::exp((fx * fx + fy * fy) * tau)));
        }
    }
    return sums;
}

} // namespace stream1
} // namespace wellstrat
