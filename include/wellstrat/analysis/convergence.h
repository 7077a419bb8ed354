// SPDX-License-Identifier: Apache-2.0
//
// How fast the error of an integral falls with the number of points: the root of the mean squared
// error (RMSE) over many patterns of a point source, with confidence bands and fitted slopes.
//
//     const std::vector<uint32_t> counts{4, 16, 64};
//     std::vector<ErrorSums> sums(counts.size());
//     addErrors(*source, {&integrand}, counts, {0, 1000}, sums.data());
//     const ErrorEstimate error = estimateError(sums[2], 1000);      // of 64 points
//
// The sums are exact (exact_sum.h): ranges of patterns may be added in any order, by any number of
// threads and machines, and merged, with the same bits as the result. Memory does not grow with
// the number of patterns.

#pragma once

#include "wellstrat/analysis/exact_sum.h"
#include "wellstrat/analysis/integrands.h"
#include "wellstrat/analysis/point_source.h"
#include "wellstrat/platform.h"

#include <cstdint>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// Sums over patterns of the powers of (mean of the integrand over N points - its integral).
struct ErrorSums {
    ExactSum first, second, fourth;

    WELLSTRAT_API ErrorSums& operator+=(const ErrorSums& other);
};

/// Patterns [begin, end).
struct PatternRange {
    uint64_t begin, end; ///< end at most 2^32
};

/// Adds to sums[k * counts.size() + c] the errors of integrands[k] with counts[c] points, for each
/// pattern of the range. The integrands have the same domains, and counts increase strictly from 1
/// on: std::invalid_argument if not. `sums` must not be written to by others meanwhile.
WELLSTRAT_API void addErrors(const PointSource& source,
                             const std::vector<const Integrand*>& integrands,
                             const std::vector<uint32_t>& counts, PatternRange patterns,
                             ErrorSums* sums);

/// The RMSE over some patterns. The band is where the RMSE over infinitely many patterns lies with
/// 95 % confidence, from the variance of the squared errors and normal in the logarithm; NaN for a
/// single pattern.
struct ErrorEstimate {
    double rmse, low, high;
    double bias; ///< the mean error; its standard error is about rmse / sqrt(patterns)
};

/// `patterns`, at least 1, is the number of patterns whose errors are in `sums`.
WELLSTRAT_API ErrorEstimate estimateError(const ErrorSums& sums, uint64_t patterns);

/// RMSE = c N^slope, fitted.
struct SlopeFit {
    double slope;
    double standardError; ///< from how far the points lie from the line; NaN for two points
    unsigned points;      ///< how many took part; the slope is NaN if there are less than two
};

/// The least-squares line through (log counts[i], log rmse[i]), over the i with
/// counts[i] >= firstCount and an RMSE above 0. The standard error says how well a line fits, not
/// how certain the slope is: errors at neighboring counts come from the same patterns.
WELLSTRAT_API SlopeFit fitSlope(const std::vector<uint32_t>& counts,
                                const std::vector<double>& rmse, uint32_t firstCount);

} // namespace stream1
} // namespace wellstrat
