// SPDX-License-Identifier: Apache-2.0
//
// Functions of the C interface: measures of point sets.

#include "wellstrat/analysis/c.h"
#include "c/call.h"
#include "wellstrat/analysis/discrepancy.h"

#include <limits>
#include <string>

using namespace wellstrat;

namespace {

L2Kind kindOf(uint32_t kind) {
    switch (kind) {
    case WELLSTRAT_L2_STAR: return L2Kind::star;
    case WELLSTRAT_L2_CENTERED: return L2Kind::centered;
    case WELLSTRAT_L2_WRAP_AROUND: return L2Kind::wrapAround;
    case WELLSTRAT_L2_MIXTURE: return L2Kind::mixture;
    case WELLSTRAT_L2_MODIFIED: return L2Kind::modified;
    default:
        throw std::invalid_argument("kind " + std::to_string(kind) +
                                    " does not exist; accepted are 0 (star) to 4 (modified)");
    }
}

} // namespace

int wellstrat_l2_discrepancy(uint32_t kind, const double* points, size_t n, uint32_t dims,
                             double* discrepancy) {
    return c::guarded(__func__, [&] {
        constexpr size_t kMost =
            std::numeric_limits<size_t>::max() / (UnitPoints::kMaxDimensions * sizeof(double));
        const L2Kind known = kindOf(kind);
        if (n > kMost) {
            throw std::invalid_argument("n is " + std::to_string(n) + "; accepted are 1 to " +
                                        std::to_string(kMost));
        }
        c::checkPointer(points, "points", n);
        c::checkPointer(discrepancy, "discrepancy");
        *discrepancy = l2Discrepancy(UnitPoints(points, n, dims), known);
    });
}
