// SPDX-License-Identifier: Apache-2.0
//
// The interface in C99 of the library wellstrat-analysis: L2 discrepancies of point sets. Statuses,
// errors and arrays are as in wellstrat/c.h.

#ifndef WELLSTRAT_ANALYSIS_C_H
#define WELLSTRAT_ANALYSIS_C_H

// NOLINTBEGIN(modernize-*, readability-identifier-naming): C, and names by its customs

#include "wellstrat/c.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Families of boxes of L2 discrepancies; wellstrat/analysis/discrepancy.h says what they are and
/// where they come from. The numbers never change.
enum {
    WELLSTRAT_L2_STAR = 0,
    WELLSTRAT_L2_CENTERED = 1,
    WELLSTRAT_L2_WRAP_AROUND = 2,
    WELLSTRAT_L2_MIXTURE = 3,
    WELLSTRAT_L2_MODIFIED = 4
};

/// The L2 discrepancy of this kind of `n` points in [0, 1)^dims, into *discrepancy: the root of
/// what some packages, SciPy among them, return for all kinds but star. Coordinate d of point i is
/// points[i * dims + d]. n is 1 or more, dims 1 to 64.
/// Time: in one to three dimensions n log2(n)^(dims - 1) steps, in more n^2 * dims / 2. Memory: 100
/// bytes a point, or 8 a coordinate. Fails for other arguments, for a coordinate that is NaN or
/// outside [0, 1), whose place it names, and without memory.
WELLSTRAT_C_API int wellstrat_l2_discrepancy(uint32_t kind, const double* points, size_t n,
                                             uint32_t dims, double* discrepancy);

#ifdef __cplusplus
} // extern "C"
#endif

// NOLINTEND(modernize-*, readability-identifier-naming)

#endif // WELLSTRAT_ANALYSIS_C_H
