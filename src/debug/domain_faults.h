// SPDX-License-Identifier: Apache-2.0
//
// The judge of DomainLinter.

#pragma once

#include "debug/draw_record.h"
#include "wellstrat/domain_finding.h"
#include "wellstrat/generator.h"

#include <vector>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// All faults in a record of domains that `generator` derived, sorted by kind and message.
std::vector<DomainFinding> findFaults(const Derivations& derivations, const DrawRecord& record,
                                      const Generator& generator);

} // namespace detail
} // namespace stream1
} // namespace wellstrat
