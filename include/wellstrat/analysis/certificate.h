// SPDX-License-Identifier: Apache-2.0
//
// The certificate: an exact check of every promise about stratification, on the tables and on the
// samples that users draw.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace wellstrat {

/// One promise and what its check found.
struct CertificateLine {
    std::string promise;        ///< for example "(x, y) is a (0,m,2)-net in base 2"
    std::string subject;        ///< what was checked, for example "384 tables, m = 0..12"
    uint64_t intervals;         ///< elementary intervals, strata or boxes counted
    uint64_t violations;        ///< of these, how many do not hold the promised number of points
    std::string firstViolation; ///< names the table or pattern, block and interval; or empty
};

/// Called now and then from the checking thread with the share of the work done, in [0, 1].
using CertificateProgress = std::function<void(double)>;

/// Checks tables first to last, both in [0, kTableCount), first <= last. Throws
/// std::invalid_argument otherwise.
WELLSTRAT_API std::vector<CertificateLine> certifyTables(unsigned first, unsigned last,
                                                         const CertificateProgress& progress = {});

/// Checks what users draw for `count` pseudo-random patterns (the same ones for the same `seed`)
/// and for a few special ones: every coordinate, aligned blocks of every size, blocks beyond the
/// first 4096 samples up to the last, distinct tables, and the run-out.
WELLSTRAT_API std::vector<CertificateLine>
certifyPatterns(unsigned count, uint32_t seed = 1, const CertificateProgress& progress = {});

} // namespace wellstrat
