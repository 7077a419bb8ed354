// SPDX-License-Identifier: Apache-2.0
#include "bank_search/integrand_levels.h"

#include <cmath>
#include <stdexcept>

namespace wellstrat::bank {
namespace {

using Digits = std::array<unsigned, 3>; ///< of each axis

/// Of at most 2^digits points. The first ones are the most alike in all axes.
std::vector<Digits> gridsOf(unsigned dims, unsigned digits) {
    if (dims == 1) return {{0, 0, 16}};
    if (dims == 2) return {{digits / 2, digits / 2, 0}, {16, digits - 16, 0}, {digits - 16, 16, 0}};
    std::vector<Digits> grids{{digits / 3, digits / 3, digits / 3}};
    for (const unsigned most : {12u, 16u}) {
        const unsigned others = (digits - most) / 2;
        grids.push_back({most, others, others});
        grids.push_back({others, most, others});
        grids.push_back({others, others, most});
    }
    return grids;
}

/// The values in the middles of the cells of a grid, x fastest.
std::vector<double> valuesOn(const Integrand& integrand, const Digits& digits) {
    std::vector<double> values;
    values.reserve(std::size_t{1} << (digits[0] + digits[1] + digits[2]));
    double point[3]{};
    const double* const arguments = integrand.domains[0] == 1 ? &point[2] : point;
    for (unsigned z = 0; z < 1u << digits[2]; ++z) {
        point[2] = std::ldexp(z + 0.5, -static_cast<int>(digits[2]));
        for (unsigned y = 0; y < 1u << digits[1]; ++y) {
            point[1] = std::ldexp(y + 0.5, -static_cast<int>(digits[1]));
            const double width = std::ldexp(1.0, -static_cast<int>(digits[0]));
            for (unsigned x = 0; x < 1u << digits[0]; ++x) {
                point[0] = (x + 0.5) * width;
                values.push_back(integrand.value(arguments));
            }
        }
    }
    return values;
}

/// Along one axis: pairs become their mean and half their difference, then pairs of means, ... The
/// coefficients of level k stand at odd multiples of 2^(digits - k).
void haarTransform(std::vector<double>& values, std::size_t stride, unsigned digits) {
    const std::size_t length = stride << digits;
    for (std::size_t half = stride; half < length; half *= 2) {
        for (std::size_t low = 0; low < values.size(); low += 2 * half) {
            for (std::size_t i = low; i < low + stride; ++i) {
                const double a = values[i], b = values[i + half];
                values[i] = (a + b) / 2;
                values[i + half] = (a - b) / 2;
            }
        }
    }
}

/// The level of each coefficient along an axis.
std::vector<unsigned> coefficientLevels(unsigned digits) {
    std::vector<unsigned> levels(std::size_t{1} << digits, 0);
    for (unsigned level = digits, first = 1; level > 0; --level, first *= 2) {
        for (std::size_t i = first; i < levels.size(); i += 2 * first) levels[i] = level;
    }
    return levels;
}

/// How many coefficients level k has, as a binary logarithm.
int countLog2(unsigned level) { return level == 0 ? 0 : static_cast<int>(level) - 1; }

/// Sets the shares that `grid` has and no earlier one had.
void addShares(ByLevels& shares, std::vector<char>& known, const Integrand& integrand,
               const Digits& grid) {
    std::vector<double> values = valuesOn(integrand, grid);
    haarTransform(values, 1, grid[0]);
    haarTransform(values, std::size_t{1} << grid[0], grid[1]);
    haarTransform(values, std::size_t{1} << (grid[0] + grid[1]), grid[2]);
    std::array<std::vector<unsigned>, 3> levels;
    for (unsigned axis = 0; axis < 3; ++axis) levels[axis] = coefficientLevels(grid[axis]);
    ByLevels sums{};
    const double* value = values.data();
    for (const unsigned j : levels[2]) {
        for (const unsigned l : levels[1]) {
            for (const unsigned k : levels[0]) {
                sums[j][l][k] += *value * *value;
                ++value;
            }
        }
    }
    char* isKnown = known.data();
    for (unsigned j = 0; j <= kDigits; ++j) {
        for (unsigned l = 0; l <= kDigits; ++l) {
            for (unsigned k = 0; k <= kDigits; ++k, ++isKnown) {
                if (*isKnown || k > grid[0] || l > grid[1] || j > grid[2]) continue;
                const int count = countLog2(k) + countLog2(l) + countLog2(j);
                shares[j][l][k] = std::ldexp(sums[j][l][k], -count);
                *isKnown = 1;
            }
        }
    }
}

} // namespace

ByLevels levelShares(const Integrand& integrand, unsigned gridDigits) {
    if (integrand.domains.size() != 1) {
        throw std::invalid_argument("'" + integrand.name + "' does not have just one domain");
    }
    ByLevels shares{};
    std::vector<char> known(sizeof shares / sizeof(double), 0);
    for (const Digits& grid : gridsOf(integrand.domains[0], gridDigits)) {
        addShares(shares, known, integrand, grid);
    }
    return shares;
}

JudgedIntegrand judgedIntegrand(const Integrand& integrand, unsigned gridDigits) {
    const ByLevels shares = levelShares(integrand, gridDigits);
    return {integrand.name, integrand.domains[0], shares[0][0][0], covariances(shares)};
}

} // namespace wellstrat::bank
