// SPDX-License-Identifier: Apache-2.0
//
// Exact checks of stratification: (t,m,s)-nets in base 2 and 4, of any point set.
// Niederreiter 1987, "Point sets and sequences with small discrepancy", definition 2.2: b^m points
// of [0,1)^s are a (t,m,s)-net in base b if every elementary interval of volume b^(t-m)
//
//     [a_1 / b^k_1, (a_1 + 1) / b^k_1) x ... x [a_s / b^k_s, (a_s + 1) / b^k_s)
//
// holds exactly b^t of them. In one dimension with t = 0 these are the b^m strata.
//
//     const PointSet points = PointSet::fromFloats(xyz, 1024, 3);
//     checkNet(points.projection({0, 1}), 0).holds();   // is (x, y) a (0,10,2)-net in base 2?
//     tValue(points);                                   // the quality parameter of (x, y, z)
//
// No floating-point arithmetic takes part, so a result is a proof for the points given.

#pragma once

#include "wellstrat/analysis/point_set.h"
#include "wellstrat/platform.h"

#include <cstdint>
#include <string>

namespace wellstrat {
inline namespace stream1 {

/// The base of a net: how many parts an interval is split into at a time.
enum class NetBase : unsigned { two = 2, four = 4 };

/// What a check found.
struct NetReport {
    uint64_t intervals = 0;     ///< elementary intervals counted
    uint64_t violations = 0;    ///< of these, how many hold the wrong number of points
    std::string firstViolation; ///< points, interval and count in words; empty if there is none

    bool holds() const { return violations == 0; }
    /// Adds the counts of another check; the first violation stays the first.
    WELLSTRAT_API NetReport& operator+=(const NetReport& other);
};

/// Is the whole set a (t,m,s)-net? The number of points must be b^m with m >= t: NetError if not.
/// Time: points * (number of interval shapes, which is binomial(m - t + s - 1, s - 1)).
/// Memory: 4 (s + 1) bytes a point.
WELLSTRAT_API NetReport checkNet(const PointSet& points, unsigned t, NetBase base = NetBase::two);

/// Does every aligned block, points [j b^m, (j + 1) b^m) for every j and every m, form a
/// (min(t, m), m, s)-net? That is what makes the set the start of a (t,s)-sequence.
WELLSTRAT_API NetReport checkSequence(const PointSet& points, unsigned t,
                                      NetBase base = NetBase::two);

/// Does each of the `count()` strata of coordinate `dim` hold one point?
WELLSTRAT_API NetReport checkStrata(const PointSet& points, unsigned dim);

/// The smallest t for which the set is a (t,m,s)-net in base 2: from 0, the best, to m, which any
/// set reaches. Costs one check for each t that fails, up to the first violation, and a full one.
WELLSTRAT_API unsigned tValue(const PointSet& points);

/// The smallest t for which `checkSequence` holds in base 2.
WELLSTRAT_API unsigned tValueOfSequence(const PointSet& points);

} // namespace stream1
} // namespace wellstrat
