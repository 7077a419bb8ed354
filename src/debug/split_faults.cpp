// SPDX-License-Identifier: Apache-2.0
//
// Faults of splits: visits that draw too few samples or too many.

#include "debug/fault_search.h"

#include <set>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

namespace {

/// Visits of splits, all samples of which must be drawn if any is.
class Splits {
public:
    Splits(Uses& uses, Findings& findings) : uses_(uses), findings_(findings) {
        for (const Use& use : uses) domains_[patternOf(use.path)].insert(use.domain);
        for (const Use& use : uses) {
            if (use.domain->split > 1 && isConfirmed(use)) confirmed_.insert(use.domain);
        }
    }

    void find() {
        forEachRun(uses_.begin(), uses_.end(), sameDomainAndPattern, [&](auto first, auto last) {
            if (first->domain->split <= 1) return;
            if (isConfirmed(*first) || confirmed_.count(first->domain) == 0) judge(first, last);
        });
    }

private:
    using Iterator = Uses::iterator;
    using Pattern = std::pair<const Derivation*, unsigned>;

    struct Visit {
        Iterator first, last;
        std::size_t samples() const { return static_cast<std::size_t>(last - first); }
        bool startsTwice() const { return first->isTwice(); }
        bool endsTwice() const { return (last - 1)->isTwice(); }
        bool isAlone() const { return first->aloneOnPath; }
    };

    static Pattern patternOf(const PathId& path) { return {path.base, path.start.patternid}; }

    /// Whether domains that are not derived from the split know the path's pattern. Contexts that
    /// were made by hand below the split, and whose paths may end, have patterns that none knows.
    bool isConfirmed(const Use& use) const {
        const std::set<const Derivation*>& domains = domains_.at(patternOf(use.path));
        return std::any_of(domains.begin(), domains.end(), [&](const Derivation* domain) {
            return !isUnder(*domain, *use.domain);
        });
    }

    void judge(Iterator first, Iterator last) {
        const unsigned split = first->domain->split;
        std::vector<Visit> visits;
        const auto sameVisit = [split](const Use& a, const Use& b) {
            return a.context.sampleid / split == b.context.sampleid / split;
        };
        forEachRun(first, last, sameVisit, [&](Iterator begin, Iterator end) {
            visits.push_back({begin, end});
        });
        const std::string visitsDraw = nameOf(*first->domain) + ": visits draw ";
        const std::string samples = " than " + std::to_string(split) + " samples";
        if (runOver(visits)) {
            for (Iterator use = first; use != last; ++use) use->runsOver = true;
            findings_.add(Fault::splitCount, visitsDraw + "more" + samples, first->path.start);
            return;
        }
        for (const Visit& visit : visits) {
            if (visit.samples() == split) continue;
            findings_.add(Fault::splitCount, visitsDraw + "fewer" + samples,
                          visit.first->path.start);
        }
    }

    /// Whether visits drew samples of the next ones. These are drawn twice then, in part or, but
    /// for those of the first visit and of one after the last, whole.
    static bool runOver(const std::vector<Visit>& visits) {
        const Visit& back = visits.back();
        if (visits.size() < 2 || visits.front().startsTwice()) return false;
        const auto isPartly = [](const Visit& v) { return v.startsTwice() && !v.endsTwice(); };
        if (std::any_of(visits.begin(), visits.end(), isPartly)) return true;
        const auto startsTwice = [](const Visit& v) { return v.startsTwice(); };
        if (visits.size() > 2 && back.isAlone() && !back.startsTwice()) {
            return std::all_of(visits.begin() + 1, visits.end() - 1, startsTwice);
        }
        return back.isAlone() && !visits.front().isAlone() &&
               back.samples() < back.first->domain->split;
    }

    Uses& uses_;
    Findings& findings_;
    std::map<Pattern, std::set<const Derivation*>> domains_;
    std::set<const Derivation*> confirmed_;
};

} // namespace

void findSplits(Uses& uses, Findings& findings) { Splits(uses, findings).find(); }

} // namespace detail
} // namespace stream1
} // namespace wellstrat
