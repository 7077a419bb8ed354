// SPDX-License-Identifier: Apache-2.0
//
// The mistakes with domains that DomainLinter finds.

#pragma once

#include "wellstrat/domain.h"

#include <cstdint>
#include <string>

namespace wellstrat {
inline namespace stream1 {

enum class DomainFault {
    drawnTwice,  ///< one domain drawn twice at one sampleid; (x, y) and z once each are fine
    samePattern, ///< two derivations led to one pattern
    splitCount,  ///< a visit of a split by n did not draw n samples
    slotTwice,   ///< two domains of a path draw from one slot (wellstrat/joint.h)
    slotLost,    ///< contexts below a slot are drawn through a RixRNG(parent, contexts, n)
    skipped,     ///< a sampleid that no path has, between those that paths have
    repeated,    ///< a whole path drawn again
};

/// All cases of one fault in the same domains.
struct DomainFinding {
    DomainFault fault;
    std::string message; ///< one line, which names the domains: "camera > 0x03707344 split 4"
    uint64_t count;      ///< of samples, patterns, visits, paths, sampleids and paths
    SampleCtx path;      ///< one of them: the camera's context, or that of the last distribution
};

} // namespace stream1
} // namespace wellstrat
