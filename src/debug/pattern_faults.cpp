// SPDX-License-Identifier: Apache-2.0
//
// Faults of patterns: samples drawn twice, and patterns that two derivations lead to.

#include "debug/fault_search.h"

#include <cmath>
#include <set>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

namespace {

/// 32-bit patterns coincide by chance as well. Coincidences count only where as many would come
/// about with less than this probability, for each pair of domains.
constexpr double kChance = 1e-6;

/// Different patterns, as far as chance knows them: those of all pixels of a tile coincide at once.
class Patterns {
public:
    explicit Patterns(unsigned placeBits) : placeBits_(placeBits) {}
    void add(unsigned patternid) { states_.insert(patternid >> placeBits_); }
    std::size_t count() const { return states_.size(); }

private:
    unsigned placeBits_;
    std::set<unsigned> states_;
};

/// Whether so many coincidences among so many pairs of patterns are no chance: a bound on the tail
/// of the Poisson distribution, mean^count / count!.
bool isNoChance(std::size_t count, double pairs, unsigned placeBits) {
    const double mean = std::ldexp(pairs, static_cast<int>(placeBits) - 32);
    double logarithm = 0.0;
    for (std::size_t i = 1; i <= count; ++i) {
        logarithm += std::log(mean / static_cast<double>(i));
    }
    return static_cast<double>(count) > mean && logarithm < std::log(kChance);
}

/// Pairs of derivations that lead to one pattern.
class SharedPatterns {
public:
    SharedPatterns(const Uses& uses, unsigned placeBits) : placeBits_(placeBits) {
        for (const Use& use : uses) ++drawnOf_[use.path.start.patternid];
        forEachRun(uses.begin(), uses.end(), sameDomainAndPattern, [&](auto first, auto) {
            patterns_.try_emplace(first->domain, placeBits)
                .first->second.add(first->context.patternid);
        });
        forEachRun(uses.begin(), uses.end(), samePattern,
                   [&](auto first, auto last) { addPairs(first, last); });
    }

    void find(Findings& findings) const {
        for (const auto& [pair, shared] : shared_) {
            const auto countOf = [this](const Derivation* domain) {
                return static_cast<double>(patterns_.at(domain).count());
            };
            const double pairs = countOf(pair.first) * countOf(pair.second);
            if (!isNoChance(shared.patterns.count(), pairs, placeBits_)) continue;
            const auto [a, b] = whereTheyMeet(pair);
            std::string names[] = {nameOf(*a), nameOf(*b)};
            std::sort(names, names + 2);
            for (const SampleCtx path : shared.paths) {
                findings.add(Fault::samePattern, names[0] + " and " + names[1] + ": one pattern",
                             path);
            }
        }
    }

private:
    using Iterator = Uses::const_iterator;
    using Pair = std::pair<const Derivation*, const Derivation*>;

    struct Shared {
        explicit Shared(unsigned placeBits) : patterns(placeBits) {}
        Patterns patterns;
        std::vector<SampleCtx> paths; ///< one of each pattern
    };

    void addPairs(Iterator first, Iterator last) {
        std::vector<std::pair<Iterator, Iterator>> domains;
        forEachRun(first, last, sameDomainAndPattern,
                   [&](Iterator begin, Iterator end) { domains.emplace_back(begin, end); });
        for (std::size_t i = 0; i < domains.size(); ++i) {
            for (std::size_t j = i + 1; j < domains.size(); ++j) {
                const Pair pair{domains[i].first->domain, domains[j].first->domain};
                if (mayBeOne(pair) && !shareSample(domains[i], domains[j])) continue;
                Shared& shared = shared_.try_emplace(pair, placeBits_).first->second;
                shared.patterns.add(first->context.patternid);
                shared.paths.push_back(
                    likelier(domains[i].first->path.start, domains[j].first->path.start));
            }
        }
    }

    /// Contexts that were overwritten lead back to a path that there is not. Few samples seem to
    /// belong to it.
    SampleCtx likelier(SampleCtx a, SampleCtx b) const {
        const auto key = [this](SampleCtx sc) {
            return std::make_pair(drawnOf_.at(sc.patternid), sc.patternid);
        };
        return key(a) < key(b) ? b : a;
    }

    /// What was derived by hand has a chain that lacks these steps. So one chain that is part of
    /// another may mean the same domain, which is no fault then unless both draw one sample.
    static bool mayBeOne(Pair pair) {
        return isPart(*pair.first, *pair.second) || isPart(*pair.second, *pair.first);
    }

    static bool isPart(const Derivation& part, const Derivation& whole) {
        const Derivation* p = &part;
        for (const Derivation* w = &whole; w && p->parent; w = w->parent) {
            if (w->scramble == p->scramble && w->split == p->split && w->parent) p = p->parent;
        }
        return !p->parent;
    }

    static bool shareSample(std::pair<Iterator, Iterator> a, std::pair<Iterator, Iterator> b) {
        while (a.first != a.second && b.first != b.second) {
            const unsigned x = a.first->context.sampleid;
            const unsigned y = b.first->context.sampleid;
            if (x == y) return true;
            ++(x < y ? a.first : b.first);
        }
        return false;
    }

    /// What derives one pattern in the same way from two others derives it from one.
    static Pair whereTheyMeet(Pair pair) {
        auto [a, b] = pair;
        while (a->parent && b->parent && a->scramble == b->scramble && a->split == b->split &&
               a->isSlotView == b->isSlotView) {
            a = a->parent;
            b = b->parent;
        }
        return {a, b};
    }

    unsigned placeBits_;
    std::map<unsigned, std::size_t> drawnOf_;        ///< samples of each pattern of paths
    std::map<const Derivation*, Patterns> patterns_; ///< those each drew from
    std::map<Pair, Shared> shared_;
};

} // namespace

void findDrawnTwice(const Uses& uses, Findings& findings, unsigned placeBits) {
    const auto isFault = [](const Use& use) { return use.isTwice() && !use.runsOver; };
    struct Drawn {
        explicit Drawn(unsigned bits) : all(bits), twice(bits) {}
        Patterns all, twice;
    };
    std::map<const Derivation*, Drawn> patterns;
    forEachRun(uses.begin(), uses.end(), sameDomainAndPattern, [&](auto first, auto last) {
        Drawn& drawn = patterns.try_emplace(first->domain, placeBits).first->second;
        drawn.all.add(first->context.patternid);
        if (std::any_of(first, last, isFault)) drawn.twice.add(first->context.patternid);
    });
    for (const Use& use : uses) {
        if (!isFault(use)) continue;
        // Patterns of one chain of bijections never coincide; those of distribution may.
        const Drawn& drawn = patterns.at(use.domain);
        const double all = static_cast<double>(drawn.all.count());
        const double pairs = use.path.base->parent ? all * all / 2 : 0.0;
        if (!isNoChance(drawn.twice.count(), pairs, placeBits)) continue;
        const bool xy = use.drawn.xy > use.pathTimes;
        const bool z = use.drawn.z > use.pathTimes;
        const char* what = xy && z ? "3D" : xy ? "2D" : "1D";
        findings.add(Fault::drawnTwice,
                     nameOf(*use.domain) + ": one " + what + " sample is drawn more than once",
                     use.path.start);
    }
}

void findSharedPatterns(const Uses& uses, Findings& findings, unsigned placeBits) {
    SharedPatterns(uses, placeBits).find(findings);
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
