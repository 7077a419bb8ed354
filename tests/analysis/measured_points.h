// SPDX-License-Identifier: Apache-2.0
//
// Point sets for the tests of the measures.

#pragma once

#include "property/point_sets.h"
#include "wellstrat/analysis/unit_points.h"
#include "wellstrat/owen.h"

#include <vector>

namespace wellstrat::test {

/// value(i, d) for points i in [0, count) and coordinates d in [0, dims).
template <class Value>
UnitPoints makeUnitPoints(std::size_t count, unsigned dims, const Value& value) {
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        for (unsigned d = 0; d < dims; ++d) values.push_back(value(i, d));
    }
    return {values.data(), count, dims};
}

inline UnitPoints unitPoints(const RawPoints& raw) {
    return makeUnitPoints(raw.count(), raw.dims, [&](std::size_t i, unsigned d) {
        return static_cast<double>(raw.at(i, d)) * 0x1p-32;
    });
}

inline UnitPoints randomUnitPoints(std::size_t count, unsigned dims, uint32_t seed) {
    return makeUnitPoints(count, dims, [=](std::size_t i, unsigned d) {
        return hashPair(seed, static_cast<uint32_t>(i) * dims + d) * 0x1p-32;
    });
}

/// The first points of the Sobol' sequence, each coordinate scrambled with a seed of its own.
inline RawPoints owenPoints(unsigned m, unsigned dims, uint32_t seed) {
    return makePoints(m, dims, [=](uint32_t i, unsigned d) {
        return owenScramble(sobolSample(sobolMatrix(d), i), hashPair(seed, d));
    });
}

} // namespace wellstrat::test
