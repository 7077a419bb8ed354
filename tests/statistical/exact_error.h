// SPDX-License-Identifier: Apache-2.0
//
// The error of an integral over all patterns, exactly, without drawing one.
//
// A pattern takes the points of a table in a random nested order and XORs a random number to them.
// What is left of the points is how often two of them differ by d, bit by bit, at each depth of the
// order: samples i and j are at depth h if bit h - 1 is the highest in which i and j differ. With
//
//     A(d) = E f(u) f(u ^ d) - (E f)^2      over uniform u
//     C_h  = mean of A(p_i ^ p_j) over all pairs of samples at depth h, over all tables
//
// the mean squared error of N = 2^m samples is (A(0) + C_1 + 2 C_2 + 4 C_3 + ... + N/2 C_m) / N.
//
// Coordinates are cut to 8 digits, in which 256 samples are stratified. Those after them are taken
// as independent of all else.

#pragma once

#include "wellstrat/analysis/integrand.h"
#include "wellstrat/sobol.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace statistical {

constexpr unsigned kCellDigits = 8;
constexpr unsigned kCellSide = 1u << kCellDigits;
constexpr unsigned kCellSamples = 256;
constexpr unsigned kDepths = 8;

/// The first digits of the coordinates of samples 0 to 255: the first coordinate in bits 0 to 7,
/// the second, if there is one, above it.
using Cells = std::array<uint32_t, kCellSamples>;

/// The position of the highest bit of `x` > 0, from 1.
inline unsigned bitLength(uint32_t x) {
    unsigned length = 0;
    for (; x != 0; x >>= 1) ++length;
    return length;
}

/// How often samples of two or one coordinates differ by d, for each depth 1 to kDepths.
class Differences {
public:
    /// Adds the samples of one table.
    void add(const Cells& cells) {
        for (uint32_t i = 1; i < kCellSamples; ++i) {
            for (uint32_t j = 0; j < i; ++j) {
                const unsigned depth = bitLength(i ^ j);
                ++counts_[depth][cells[i] ^ cells[j]];
                ++pairs_[depth];
            }
        }
    }

    /// Adds what nested uniform scrambling of Sobol' points has in the mean: two numbers part at
    /// the same digit as before, and are independent after it.
    void addNestedUniform(const std::vector<unsigned>& sobolDimensions) {
        for (uint32_t i = 1; i < kCellSamples; ++i) {
            std::array<uint32_t, 2> size{1, 1}, first{0, 0}; // of what the differences may be
            for (std::size_t k = 0; k < sobolDimensions.size(); ++k) {
                const uint32_t value =
                    wellstrat::sobolSample(wellstrat::sobolMatrix(sobolDimensions[k]), i);
                size[k] = first[k] = 1u << (bitLength(value >> (32 - kCellDigits)) - 1);
            }
            const unsigned depth = bitLength(i);
            for (uint32_t cell = 0; cell < size[0] * size[1]; ++cell) {
                const uint32_t x = first[0] + cell % size[0], y = first[1] + cell / size[0];
                counts_[depth][x | y << kCellDigits] += 1.0 / (size[0] * size[1]);
            }
            ++pairs_[depth];
        }
    }

    /// The mean of covariance[d] over the differences d at a depth.
    double mean(unsigned depth, const std::vector<double>& covariance) const {
        double sum = 0;
        for (std::size_t d = 0; d < covariance.size(); ++d)
            sum += counts_[depth][d] * covariance[d];
        return sum / pairs_[depth];
    }

private:
    using Counts = std::vector<double>;
    std::vector<Counts> counts_ =
        std::vector<Counts>(kDepths + 1, Counts(std::size_t{kCellSide} * kCellSide));
    std::array<double, kDepths + 1> pairs_{};
};

/// In place; the size is a power of two. Twice gives the size times the original.
inline void walshTransform(std::vector<double>& values) {
    for (std::size_t half = 1; half < values.size(); half *= 2) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if ((i & half) != 0) continue;
            const double low = values[i], high = values[i | half];
            values[i] = low + high;
            values[i | half] = low - high;
        }
    }
}

/// Of 1, 2, 4, ..., 256 samples.
using Errors = std::array<double, kDepths + 1>;

/// What the error of an integrand over one domain of one or two dimensions depends on.
class ShiftedIntegrand {
public:
    /// Evaluates the integrand at 4 places of a cell along each axis.
    explicit ShiftedIntegrand(const wellstrat::Integrand& integrand) {
        constexpr unsigned kPlaces = 4, kSide = kCellSide * kPlaces;
        const unsigned dims = integrand.domains[0];
        const unsigned rows = dims == 1 ? 1 : kSide;
        covariance_.resize(dims == 1 ? kCellSide : std::size_t{kCellSide} * kCellSide);
        const double weight = 1.0 / kSide / rows;
        double mean = 0, square = 0;
        for (unsigned y = 0; y < rows; ++y) {
            for (unsigned x = 0; x < kSide; ++x) {
                const double point[2] = {(x + 0.5) / kSide, (y + 0.5) / kSide};
                const double value = integrand.value(point);
                covariance_[(y / kPlaces) * kCellSide + x / kPlaces] += value * weight;
                mean += value * weight;
                square += value * value * weight;
            }
        }
        variance_ = square - mean * mean;
        walshTransform(covariance_); // of means of cells over their number: Walsh coefficients
        covariance_[0] = 0;
        for (double& coefficient : covariance_) coefficient *= coefficient;
        walshTransform(covariance_);
    }

    /// The root mean squared errors of 2^m samples, by m.
    Errors errors(const Differences& differences) const {
        Errors result{};
        double sum = variance_;
        for (unsigned m = 0; m <= kDepths; ++m) {
            const int log2 = static_cast<int>(m);
            if (m > 0) sum += std::ldexp(differences.mean(m, covariance_), log2 - 1);
            result[m] = std::sqrt(std::ldexp(sum, -log2));
        }
        return result;
    }

private:
    double variance_;
    std::vector<double> covariance_; ///< A(d), without its part within cells
};

} // namespace statistical
