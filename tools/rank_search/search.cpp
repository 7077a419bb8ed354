// SPDX-License-Identifier: Apache-2.0
#include "rank_search/search.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <mutex>

namespace wellstrat::ranks {
namespace {

/// Of an annealing, which take the time of a search for a slot's columns.
constexpr double kSweepsOfColumns = 20;

/// Adds up the time that is done, in sweeps.
class Progress {
public:
    Progress(double total, const std::function<void(double)>& show) : total_(total), show_(show) {}

    void add(double sweeps) {
        const std::lock_guard<std::mutex> lock(mutex_);
        done_ += sweeps;
        show_(std::min(1.0, done_ / total_));
    }

private:
    double total_, done_ = 0;
    const std::function<void(double)>& show_;
    std::mutex mutex_;
};

} // namespace

RankTables searchRanks(const SearchOptions& options, const std::function<void(double)>& progress) {
    const double searches = static_cast<double>(options.slots - 1) * (1 + options.rounds);
    Progress done(2 * options.sweeps + kSweepsOfColumns * searches, progress);
    const auto sweep = [&done] { done.add(1); };
    const auto searched = [&done] { done.add(kSweepsOfColumns); };

    RankTables tables;
    const auto findPadded = [&] {
        std::mt19937 random(options.seed);
        const Visits visits = visitsOf(0, identityColumns());
        tables.padded =
            annealedTile(covarianceOf(sumsOfOne(), visits, visits), options.sweeps, random, sweep);
    };
    const auto findSlots = [&] {
        // Columns that are found for the tile of these ranks would be no better.
        const Weights weights = weightsOfRandomTiles();
        tables.bank = {identityColumns()};
        while (tables.bank.size() < options.slots) {
            tables.bank.push_back(bestColumns(tables.bank, tables.bank.size(), weights));
            searched();
        }
        for (unsigned round = 0; round < options.rounds; ++round) {
            improve(weights, &tables.bank, searched);
        }
        std::mt19937 random(options.seed + 1);
        tables.slots = annealedTile(covarianceOfSlots(tables.bank), options.sweeps, random, sweep);
    };
    tbb::parallel_invoke(findPadded, findSlots);
    return tables;
}

} // namespace wellstrat::ranks
