// SPDX-License-Identifier: Apache-2.0
//
// Point sets with known quality parameters, for tests.

#pragma once

#include "wellstrat/analysis/nets.h"
#include "wellstrat/hash.h"
#include "wellstrat/sobol.h"

#include <cstdint>
#include <vector>

namespace wellstrat::test {

/// Points as fractions of 2^32, point after point.
struct RawPoints {
    std::vector<uint32_t> values;
    unsigned dims;

    std::size_t count() const { return values.size() / dims; }
    uint32_t& at(std::size_t point, unsigned dim) { return values[point * dims + dim]; }
    uint32_t at(std::size_t point, unsigned dim) const { return values[point * dims + dim]; }
    PointSet set() const { return PointSet::fromIntegers(values.data(), count(), dims); }
};

/// value(i, d) for points i in [0, 2^m) and coordinates d in [0, dims).
template <class Value>
RawPoints makePoints(unsigned m, unsigned dims, const Value& value) {
    RawPoints points{{}, dims};
    for (uint32_t i = 0; i < (1u << m); ++i) {
        for (unsigned d = 0; d < dims; ++d) points.values.push_back(value(i, d));
    }
    return points;
}

/// The first points of the Sobol' sequence: t = 0 for 1 and 2 dimensions, 1 for 3.
inline RawPoints sobolPoints(unsigned m, unsigned dims = 3) {
    return makePoints(m, dims,
                      [](uint32_t i, unsigned d) { return sobolSample(sobolMatrix(d), i); });
}

/// i / 2^m and the first dims - 1 Sobol' dimensions. A (t,s)-sequence gives a (t,m,s+1)-net
/// (Niederreiter 1987, lemma 5.15), so t = 0 for up to 3 dimensions.
inline RawPoints hammersleyPoints(unsigned m, unsigned dims = 3) {
    return makePoints(m, dims, [m](uint32_t i, unsigned d) {
        return d == 0 ? static_cast<uint32_t>(uint64_t{i} << (32 - m))
                      : sobolSample(sobolMatrix(d - 1), i);
    });
}

/// Hashed values: no net but for the trivial t = m.
inline RawPoints randomPoints(unsigned m, unsigned dims, uint32_t seed) {
    return makePoints(m, dims,
                      [=](uint32_t i, unsigned d) { return hashPair(seed, i * dims + d); });
}

} // namespace wellstrat::test
