// SPDX-License-Identifier: Apache-2.0
//
// Faults of paths: drawn again, skipped, or with a slot taken twice.

#include "debug/fault_search.h"

#include "wellstrat/order.h"

#include <set>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

namespace {

using Domains = std::set<const Derivation*>;

/// How often the whole path of uses [first, last) was drawn: as often as each of its samples.
/// Where one domain is all there is, that is no different from a domain drawn twice, unless it is
/// drawn once on another path; and not from a split that runs into the next visit's samples.
unsigned timesOfPath(Uses::const_iterator first, Uses::const_iterator last,
                     const Domains& drawnOnce) {
    unsigned least = first->times();
    for (auto use = first; use != last; ++use) least = std::min(least, use->times());
    const Derivation* domain = first->domain;
    const bool several = domain != (last - 1)->domain;
    return several || (domain->split <= 1 && drawnOnce.count(domain) > 0) ? least : 1;
}

} // namespace

void markWholePaths(Uses& uses) {
    Domains drawnOnce;
    for (const Use& use : uses) {
        if (use.times() == 1) drawnOnce.insert(use.domain);
    }
    bool anyRepeated = false;
    forEachRun(uses.begin(), uses.end(), samePath, [&](auto first, auto last) {
        // The camera's paths come first. Those from distributions are drawn again with them.
        const bool ofCamera = !first->path.base->parent;
        const unsigned times = ofCamera || anyRepeated ? timesOfPath(first, last, drawnOnce) : 1;
        if (ofCamera) anyRepeated |= times > 1;
        const bool alone = first->domain == (last - 1)->domain;
        for (auto use = first; use != last; ++use) {
            use->pathTimes = times;
            use->aloneOnPath = alone;
        }
    });
}

void findRepeated(const Uses& uses, Findings& findings) {
    forEachRun(uses.begin(), uses.end(), samePath, [&](auto first, auto) {
        if (first->path.base->parent || first->pathTimes < 2) return;
        findings.add(Fault::repeated, "whole paths are drawn again, with the same sampleids",
                     first->path.start);
    });
}

/// Which sampleids some camera pattern should have, because it has lower and higher ones, and no
/// pattern has. What one pixel lacks and another one has may be a path that ended before its first
/// draw.
void findSkipped(const Uses& uses, Findings& findings) {
    struct Range {
        SampleCtx first;
        unsigned last;
    };
    std::vector<Range> ranges;
    std::set<unsigned> drawn;
    for (const Use& use : uses) { // sorted by path
        if (use.path.base->parent) break;
        const SampleCtx start = use.path.start;
        drawn.insert(start.sampleid);
        const bool sameRange = !ranges.empty() && ranges.back().first.patternid == start.patternid;
        if (!sameRange) ranges.push_back({start, start.sampleid});
        ranges.back().last = start.sampleid;
    }
    for (auto next = drawn.begin(); next != drawn.end();) {
        const unsigned low = *next++;
        if (next == drawn.end() || *next == low + 1) continue;
        for (const Range& range : ranges) {
            if (range.first.sampleid > low || range.last < *next) continue;
            findings.add(
                Fault::skipped,
                "sampleids are skipped: no path has them, and paths have lower and higher ones",
                {range.first.patternid, low + 1}, *next - low - 1);
            break;
        }
    }
}

void findSlots(const Uses& uses, Findings& findings) {
    forEachRun(uses.begin(), uses.end(), samePath, [&](auto first, auto last) {
        const Derivation* takenBy[kJointSlots] = {};
        const auto sameDomain = [](const Use& a, const Use& b) { return a.domain == b.domain; };
        forEachRun(first, last, sameDomain, [&](auto use, auto) {
            const unsigned slot = slotOf(*use->domain);
            if (slot == kJointSlots) return;
            const Derivation* other = std::exchange(takenBy[slot], use->domain);
            if (!other) return;
            std::string names[] = {nameOf(*other), nameOf(*use->domain)};
            std::sort(names, names + 2);
            findings.add(Fault::slotTwice,
                         "slot " + std::to_string(slot) + " twice on a path: " + names[0] +
                             " and " + names[1],
                         use->path.start);
        });
    });
}

void findLostSlots(const Uses& uses, Findings& findings) {
    for (const Use& use : uses) {
        if (!use.domain->isSlotView) continue;
        findings.add(Fault::slotLost,
                     nameOf(*use.domain) +
                         ": contexts in a RixRNG(parent, contexts, n) have no slot and no order; "
                         "derive them by their indices",
                     use.path.start);
    }
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
