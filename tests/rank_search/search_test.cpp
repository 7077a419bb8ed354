// SPDX-License-Identifier: Apache-2.0
//
// What a whole search gives.

#include "rank_search/search.h"

#include "rank_search/judge.h"

#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace rank_tests {
namespace {

using namespace wellstrat::ranks;

SearchOptions shortSearch() {
    SearchOptions options;
    options.sweeps = 4;
    options.rounds = 1;
    options.slots = 3;
    return options;
}

RankTables searchWith(std::size_t threads, const SearchOptions& options) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return searchRanks(options, [](double) {});
}

TEST(RankSearch, AnyNumberOfThreadsGivesTheSame) {
    const RankTables one = searchWith(1, shortSearch()), two = searchWith(2, shortSearch());
    EXPECT_EQ(one.bank, two.bank);
    EXPECT_EQ(one.padded, two.padded);
    EXPECT_EQ(one.slots, two.slots);
    EXPECT_EQ(one.bank.size(), 3u);
}

TEST(RankSearch, SeedsDifferAndProgressGrows) {
    SearchOptions options = shortSearch();
    options.slots = 2;
    double last = 0;
    const RankTables tables = searchRanks(options, [&](double done) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        last = done;
    });
    EXPECT_NEAR(last, 1, 1e-9);
    options.seed = 7;
    EXPECT_NE(searchRanks(options, [](double) {}).padded, tables.padded);
}

TEST(RankJudge, HasEveryModelAndAgreesWithTheMerit) {
    SearchOptions options = shortSearch();
    const RankTables tables = searchRanks(options, [](double) {});
    const std::vector<Judgement> rows = judge(tables);
    EXPECT_EQ(rows.size(), 3 * modelsOfOne().size() + 2 * modelsOfPairs().size());
    const Visits visits = visitsOf(0, identityColumns());
    for (const Model& model : modelsOfOne()) {
        const auto row = std::find_if(rows.begin(), rows.end(), [&](const Judgement& r) {
            return r.what == "padded" && r.model == model.name;
        });
        ASSERT_NE(row, rows.end());
        const Covariance covariance = covarianceOf(sumsOf(model, 4), visits, visits);
        const double squared = merit(weightsOf(tables.padded, 0), covariance);
        EXPECT_NEAR(row->ratios[4] * row->ratios[4], squared, 1e-9);
    }
    for (const Judgement& row : rows) {
        for (const double ratio : row.ratios) EXPECT_GT(ratio, 0) << row.model;
    }
}

} // namespace
} // namespace rank_tests
