// SPDX-License-Identifier: Apache-2.0

#include "run.h"

#include "common/command_line/interrupt.h"
#include "common/command_line/progress.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>

namespace wellstrat::cli {
namespace {

/// Integrands that take the same points: one draw serves them all.
struct Group {
    std::size_t source;
    std::vector<std::size_t> indices; ///< of the integrands
    std::vector<const IntegrandPicture*> integrands;
};

std::vector<Group> groupsOf(const StudyPlan& plan) {
    std::vector<Group> groups;
    for (std::size_t source = 0; source < plan.sources.size(); ++source) {
        std::map<DomainDims, Group> byDomains;
        for (std::size_t k = 0; k < plan.integrands.size(); ++k) {
            Group& group = byDomains[plan.integrands[k].domains];
            group.source = source;
            group.indices.push_back(k);
            group.integrands.push_back(&plan.integrands[k]);
        }
        for (auto& [domains, group] : byDomains) groups.push_back(std::move(group));
    }
    return groups;
}

/// The patterns of one process in one round, cut into tasks.
class Round {
public:
    Round(const StudyPlan& plan, const std::vector<Group>& groups)
        : plan_(plan), groups_(groups), locks_(groups.size()), sums_(plan.cells()) {}

    /// Calls done(share of the tasks) after each task. False if it was interrupted.
    template <typename Done>
    bool run(PatternRange patterns, Done done) {
        const uint64_t chunk = plan_.filter ? 1 : 4; ///< patterns in a task
        const uint64_t chunks = (patterns.end - patterns.begin + chunk - 1) / chunk;
        const uint64_t tasks = chunks * groups_.size();
        std::atomic<uint64_t> finished{0};
        tbb::parallel_for(uint64_t{0}, tasks, [&](uint64_t task) {
            if (InterruptGuard::interrupted) return;
            const uint64_t begin = patterns.begin + task / groups_.size() * chunk;
            add(task % groups_.size(), {begin, std::min(begin + chunk, patterns.end)});
            done(static_cast<double>(++finished) / static_cast<double>(tasks));
        });
        return finished == tasks;
    }

    std::vector<ErrorSums>& sums() { return sums_; }

private:
    void measure(const Group& group, PatternRange patterns, ErrorSums* sums) const {
        const StudySource& source = plan_.sources[group.source];
        if (plan_.filter) {
            addPictureErrors({*source.source, source.patternOf}, group.integrands, plan_.counts,
                             *plan_.filter, patterns, sums);
            return;
        }
        std::vector<const Integrand*> integrands;
        for (const IntegrandPicture* picture : group.integrands) {
            integrands.push_back(&picture->pixels[0]);
        }
        addErrors(*source.source, integrands, plan_.counts, patterns, sums);
    }

    void add(std::size_t g, PatternRange patterns) {
        const Group& group = groups_[g];
        const std::size_t counts = plan_.counts.size();
        std::vector<ErrorSums> sums(group.integrands.size() * counts);
        measure(group, patterns, sums.data());
        const std::lock_guard<std::mutex> lock(locks_[g]);
        for (std::size_t k = 0; k < group.indices.size(); ++k) {
            ErrorSums* const to = &sums_[plan_.firstCell(group.source, group.indices[k])];
            for (std::size_t c = 0; c < counts; ++c) to[c] += sums[k * counts + c];
        }
    }

    const StudyPlan& plan_;
    const std::vector<Group>& groups_;
    std::vector<std::mutex> locks_;
    std::vector<ErrorSums> sums_;
};

/// How many patterns a round takes, so that it lasts about as long as is bearable to lose.
class RoundLength {
public:
    explicit RoundLength(unsigned ranks) : patterns_(16 * ranks) {}
    uint64_t patterns() const { return patterns_; }
    void adapt(double seconds) {
        constexpr double kShort = 1, kLong = 4;
        if (seconds < kShort) patterns_ *= 2;
        if (seconds > kLong) patterns_ = std::max<uint64_t>(1, patterns_ / 2);
    }

private:
    uint64_t patterns_;
};

} // namespace

void runStudy(const StudyPlan& plan, const Ranks& ranks, StudyResult& result,
              const std::function<void()>& save) {
    using Clock = std::chrono::steady_clock;
    const InterruptGuard guard;
    const std::vector<Group> groups = groupsOf(plan);
    const auto all = static_cast<double>(plan.patterns);
    RoundLength length(ranks.size());
    ProgressBar progress("study", static_cast<double>(result.patterns) / all);
    for (uint64_t begin = ranks.fromRoot(result.patterns); begin < plan.patterns;) {
        const Clock::time_point start = Clock::now();
        const uint64_t count = std::min(ranks.fromRoot(length.patterns()), plan.patterns - begin);
        const PatternRange part{begin + count * ranks.rank() / ranks.size(),
                                begin + count * (ranks.rank() + 1) / ranks.size()};
        Round round(plan, groups);
        const bool complete = round.run(part, [&](double share) {
            const double patterns = static_cast<double>(begin) + share * double(count);
            if (ranks.isRoot()) progress.show(patterns / all);
        });
        if (ranks.any(!complete)) return;
        ranks.sumAtRoot(round.sums());
        begin += count;
        if (ranks.isRoot()) {
            for (std::size_t i = 0; i < result.sums.size(); ++i) {
                result.sums[i] += round.sums()[i];
            }
            result.patterns = begin;
            save();
        }
        length.adapt(std::chrono::duration<double>(Clock::now() - start).count());
    }
}

} // namespace wellstrat::cli
