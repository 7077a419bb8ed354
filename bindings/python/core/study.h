// SPDX-License-Identifier: Apache-2.0
//
// Errors of integrals by number of points, over many patterns.

#pragma once

#include "wellstrat/analysis/convergence.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace python {

/// The names of the generators that `Study::addPatterns` knows.
std::vector<std::string> sourceNames();

/// The errors of some integrands, which have the same domains, at some numbers of points.
class Study {
public:
    /// Throws std::invalid_argument for names that are no integrands, for other domains than those
    /// of the first, and for counts that do not increase from 1 on.
    Study(const std::vector<std::string>& integrands, std::vector<uint32_t> counts);

    /// The coordinates of a point.
    unsigned dims() const { return wellstrat::totalDims(integrands_.front().domains); }

    /// Adds the errors of patterns [begin, end) of a generator. Throws std::invalid_argument for a
    /// name that there is not, and for what the generator cannot draw.
    void addPatterns(const std::string& source, uint64_t begin, uint64_t end);

    /// Adds the errors of one pattern at the numbers of points counts[first, last). points[0,
    /// counts[last - 1] * dims()) are its points, one after the other.
    void addPoints(const double* points, std::size_t first, std::size_t last);

    /// By integrand, and then by number of points.
    std::vector<std::vector<wellstrat::ErrorEstimate>> estimates() const;

    /// By integrand; the slope of the errors of counts from `firstCount` on.
    std::vector<wellstrat::SlopeFit> slopes(uint32_t firstCount) const;

private:
    std::vector<wellstrat::Integrand> integrands_;
    std::vector<uint32_t> counts_;
    std::vector<wellstrat::ErrorSums> sums_; ///< of integrand k and count c: [k * counts + c]
    uint64_t patterns_ = 0;                  ///< whose errors at the last count were added

    std::vector<const wellstrat::Integrand*> pointers() const;
};

} // namespace python
