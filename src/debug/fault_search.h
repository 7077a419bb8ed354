// SPDX-License-Identifier: Apache-2.0
//
// All samples that were drawn as a list, sorted by path or by pattern, and the searches for faults
// in it.

#pragma once

#include "debug/draw_record.h"
#include "wellstrat/domain_finding.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

using Fault = DomainFault;
using Finding = DomainFinding;

/// A sample that was drawn.
struct Use {
    const Derivation* domain;
    SampleCtx context;
    DrawCounts drawn;
    PathId path;
    unsigned pathTimes = 1;   ///< how often the whole path was drawn
    bool aloneOnPath = false; ///< no other domain of the path was drawn
    bool runsOver = false;    ///< visits of its split draw too many

    unsigned times() const { return std::max(drawn.xy, drawn.z); }
    bool isTwice() const { return times() > pathTimes; }
};

using Uses = std::vector<Use>;

inline bool lessByPath(const Use& a, const Use& b) {
    const auto key = [](const Use& use) {
        return std::make_tuple(use.path.base->number, use.path.start.patternid,
                               use.path.start.sampleid, use.domain->number, use.context.patternid,
                               use.context.sampleid);
    };
    return key(a) < key(b);
}

inline bool samePath(const Use& a, const Use& b) {
    return a.path.base == b.path.base && a.path.start.patternid == b.path.start.patternid &&
           a.path.start.sampleid == b.path.start.sampleid;
}

inline bool lessByPattern(const Use& a, const Use& b) {
    const auto key = [](const Use& use) {
        return std::make_tuple(use.context.patternid, use.domain->number, use.context.sampleid);
    };
    return key(a) < key(b);
}

inline bool samePattern(const Use& a, const Use& b) {
    return a.context.patternid == b.context.patternid;
}

inline bool sameDomainAndPattern(const Use& a, const Use& b) {
    return samePattern(a, b) && a.domain == b.domain;
}

/// Calls visit(first, last) for each longest run of uses that are the same as their neighbors.
template <class Iterator, class Same, class Visit>
void forEachRun(Iterator begin, Iterator end, const Same& same, const Visit& visit) {
    while (begin != end) {
        Iterator last = begin;
        while (last != end && same(*begin, *last)) ++last;
        visit(begin, last);
        begin = last;
    }
}

/// Equal faults of the same domains, as one finding.
class Findings {
public:
    void add(Fault fault, const std::string& message, SampleCtx path, uint64_t count = 1) {
        const auto [found, isNew] =
            all_.try_emplace({fault, message}, Finding{fault, message, 0, path});
        Finding& finding = found->second;
        finding.count += count;
        const auto key = [](SampleCtx sc) { return std::make_pair(sc.sampleid, sc.patternid); };
        if (key(path) < key(finding.path)) finding.path = path;
    }

    std::vector<Finding> sorted() const {
        std::vector<Finding> list;
        for (const auto& entry : all_) list.push_back(entry.second);
        return list;
    }

private:
    std::map<std::pair<Fault, std::string>, Finding> all_;
};

/// Sets `pathTimes` and `aloneOnPath`. Sorted by path, as in the next four.
void markWholePaths(Uses& uses);
void findRepeated(const Uses& uses, Findings& findings);
void findSkipped(const Uses& uses, Findings& findings);
void findSlots(const Uses& uses, Findings& findings);
void findLostSlots(const Uses& uses, Findings& findings);

/// Also sets `runsOver`. Sorted by pattern, as in the next two.
void findSplits(Uses& uses, Findings& findings);
/// `placeBits` as in Generator::PlaceBits.
void findDrawnTwice(const Uses& uses, Findings& findings, unsigned placeBits);
void findSharedPatterns(const Uses& uses, Findings& findings, unsigned placeBits);

} // namespace detail
} // namespace stream1
} // namespace wellstrat
