// SPDX-License-Identifier: Apache-2.0
//
// Discrepancies: how far the share of points in boxes is from the volume of the boxes.
//
// With A(B) the number of the N points in the box B:
//     star discrepancy   the largest |A(B) / N - volume(B)| over all boxes B = [0, z)
//     L2 discrepancies   the root of a mean square of that difference, over families of boxes

#pragma once

#include "wellstrat/analysis/unit_points.h"
#include "wellstrat/platform.h"

#include <cstddef>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// Families of boxes of L2 discrepancies. Except for the first, each also takes the mean over all
/// projections of the points.
enum class L2Kind {
    star,       ///< boxes with a corner at 0. Warnock 1972, in Zaremba (ed.), "Applications of
                ///< number theory to numerical analysis", 319-343
    centered,   ///< boxes with a corner at the nearest corner of the cube. Hickernell 1998, "A
                ///< generalized discrepancy and quadrature error bound", Math. Comp. 67, 299-322
    wrapAround, ///< any boxes on the torus. Hickernell 1998, "Lattice rules: how well do they
                ///< measure up?", in Random and Quasi-Random Point Sets, 106-166
    mixture,    ///< between the two before. Zhou, Fang, Ning 2013, "Mixture discrepancy for
                ///< quasi-random point sets", J. Complexity 29, 283-301
    modified,   ///< boxes with a corner at 0, and their projections. Hickernell 1998, as centered
};

/// Up to so many dimensions, L2 discrepancies take few steps.
constexpr unsigned kMaxFastL2Dimensions = 3;

/// The L2 discrepancy: the root of what some packages, SciPy among them, return for all kinds but
/// star. Rounding adds up to about 1e-14 to its square, and 1e-17 for many points.
/// Time: in one to three dimensions, count log2(count)^(dims - 1) steps (Heinrich 1996, "Efficient
/// algorithms for computing the L2-discrepancy", Math. Comp. 65, 1621-1633); in more,
/// count^2 * dims / 2 of a fraction of a nanosecond. Memory: 100 bytes a point, or 8 a coordinate.
WELLSTRAT_API double l2Discrepancy(const UnitPoints& points, L2Kind kind);

/// Those of several kinds, in their order, in less time.
WELLSTRAT_API std::vector<double> l2Discrepancies(const UnitPoints& points,
                                                  const std::vector<L2Kind>& kinds);

/// The star discrepancy lies in [lower, upper].
struct StarBounds {
    double lower, upper;

    bool exact() const { return lower == upper; }
};

/// The most dimensions for which `starDiscrepancy` is there.
constexpr unsigned kMaxStarDimensions = 3;

/// The star discrepancy in one to three dimensions. Throws PointError for more.
///
/// In one (Niederreiter 1992, "Random number generation and quasi-Monte Carlo methods", theorem
/// 2.6) and two dimensions it is exact, in about count log^2(count) steps. The corners of the boxes
/// that matter lie on the grid of the coordinates of the points and 1 (Bundschuh, Zhu
/// 1993, Abh. Math. Sem. Univ. Hamburg 63, 115-133); a kinetic tournament finds the worst one of
/// each column.
///
/// In three dimensions the third coordinate is split into slabs. The sweep of the plane is exact
/// for boxes that end at the border of a slab; for those that end inside, volume and points of the
/// two borders bound it. The slab with the largest bound is halved until the bounds meet, which
/// makes the result exact, or after `maxSweeps` sweeps of all points; from 3 on, more give a
/// narrower bound.
WELLSTRAT_API StarBounds starDiscrepancy(const UnitPoints& points, std::size_t maxSweeps = 1024);

} // namespace stream1
} // namespace wellstrat
