// SPDX-License-Identifier: Apache-2.0
//
// The means of integrands over the first points of a pattern, and what is asked of the arguments of
// those who take them.

#pragma once

#include "wellstrat/analysis/point_source.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// Throws std::invalid_argument unless `subjects`, integrands or pictures of such, have the same
/// domains, the counts increase strictly from 1 on, and patterns below `end` exist.
template <typename Subject>
void checkSubjects(const std::vector<const Subject*>& subjects, const std::vector<uint32_t>& counts,
                   uint64_t end) {
    for (const Subject* subject : subjects) {
        if (subject->domains != subjects[0]->domains) {
            throw std::invalid_argument("the integrands of one call must have the same domains");
        }
    }
    uint32_t last = 0;
    for (const uint32_t count : counts) {
        if (count <= last) {
            throw std::invalid_argument("the numbers of points must increase, from 1 on");
        }
        last = count;
    }
    if (end > uint64_t{1} << 32) {
        throw std::invalid_argument("there are no patterns from 2^32 on");
    }
}

class PrefixMeans {
public:
    /// There is at least one count, and checkSubjects accepts them. `source` and `counts` must
    /// outlive this.
    PrefixMeans(const PointSource& source, const DomainDims& domains,
                const std::vector<uint32_t>& counts)
        : source_(source), domains_(domains), counts_(counts), dims_(totalDims(domains)),
          points_(std::size_t{counts.back()} * dims_) {}

    /// Calls take(k, c, mean) with the mean of integrands[k] over the first counts[c] points of
    /// `pattern`, for all k and c. The integrands have the domains.
    template <typename Take>
    void forEach(uint32_t pattern, const std::vector<const Integrand*>& integrands, Take take) {
        if (source_.isProgressive()) {
            draw(pattern, counts_.back());
            for (std::size_t k = 0; k < integrands.size(); ++k) {
                forEachPrefix(*integrands[k],
                              [&](std::size_t c, double mean) { take(k, c, mean); });
            }
            return;
        }
        for (std::size_t c = 0; c < counts_.size(); ++c) {
            draw(pattern, counts_[c]);
            for (std::size_t k = 0; k < integrands.size(); ++k) {
                take(k, c, sumOfValues(*integrands[k], 0, counts_[c], 0) / counts_[c]);
            }
        }
    }

private:
    void draw(uint32_t pattern, uint32_t count) {
        source_.draw(pattern, domains_, count, points_.data());
    }

    /// `sum` and the values at points [begin, end), added in order.
    double sumOfValues(const Integrand& integrand, uint32_t begin, uint32_t end, double sum) const {
        for (uint32_t i = begin; i < end; ++i) {
            sum += integrand.value(&points_[std::size_t{i} * dims_]);
        }
        return sum;
    }

    template <typename Take>
    void forEachPrefix(const Integrand& integrand, Take take) const {
        double sum = 0;
        uint32_t done = 0;
        for (std::size_t c = 0; c < counts_.size(); ++c) {
            sum = sumOfValues(integrand, done, counts_[c], sum);
            done = counts_[c];
            take(c, sum / counts_[c]);
        }
    }

    const PointSource& source_;
    DomainDims domains_;
    const std::vector<uint32_t>& counts_;
    unsigned dims_;
    std::vector<double> points_;
};

} // namespace stream1
} // namespace wellstrat
