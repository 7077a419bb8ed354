// SPDX-License-Identifier: Apache-2.0
//
// The judge of DomainLinter: from the record to the findings.

#include "debug/domain_faults.h"

#include "debug/fault_search.h"

namespace wellstrat {
inline namespace stream1 {
namespace detail {

std::vector<Finding> findFaults(const Derivations& derivations, const DrawRecord& record,
                                const Generator& generator) {
    Uses uses;
    record.forEach(derivations, [&](const Derivation& domain, SampleCtx context, DrawCounts drawn) {
        uses.push_back({&domain, context, drawn, pathOf(domain, context, generator)});
    });
    Findings findings;
    std::sort(uses.begin(), uses.end(), lessByPath);
    markWholePaths(uses);
    findRepeated(uses, findings);
    findSkipped(uses, findings);
    findSlots(uses, findings);
    findLostSlots(uses, findings);

    std::sort(uses.begin(), uses.end(), lessByPattern);
    findSplits(uses, findings);
    findDrawnTwice(uses, findings, generator.PlaceBits());
    findSharedPatterns(uses, findings, generator.PlaceBits());
    return findings.sorted();
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
