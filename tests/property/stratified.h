// SPDX-License-Identifier: Apache-2.0
//
// What every aligned block of 4096 samples promises.

#pragma once

#include "wellstrat/analysis/nets.h"
#include "wellstrat/vector.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wellstrat::test {

/// For all aligned runs of 2^m samples: each coordinate alone, (x, y) and (x, y, z).
inline void expectStratified(const std::vector<Float3>& xis, const std::string& name) {
    const PointSet points = PointSet::fromFloats(&xis[0].x, xis.size(), 3);
    for (unsigned d = 0; d < 3; ++d) {
        EXPECT_EQ(checkSequence(points.projection({d}), 0).firstViolation, "") << name;
    }
    EXPECT_EQ(checkSequence(points.projection({0, 1}), 0).firstViolation, "") << name;
    EXPECT_EQ(checkSequence(points, 1).firstViolation, "") << name;
    EXPECT_EQ(checkSequence(points, 0, NetBase::four).firstViolation, "") << name;
}

} // namespace wellstrat::test
