// SPDX-License-Identifier: Apache-2.0
//
// Who goes on is asked once and in order, and keeps what is its own.

#include "renderer/compaction.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace wellstrat::render {
namespace {

TEST(Compaction, MovesWhatGoesOnToTheFrontInAllArrays) {
    std::vector<int> numbers{0, 1, 2, 3, 4, 5};
    std::vector<std::string> names{"a", "b", "c", "d", "e", "f"};
    const bool goesOn[] = {false, true, true, false, false, true};
    const unsigned left = compact(
        6, [&](unsigned i) { return goesOn[i]; }, numbers.data(), names.data());
    ASSERT_EQ(left, 3u);
    numbers.resize(left);
    names.resize(left);
    EXPECT_EQ(numbers, (std::vector<int>{1, 2, 5}));
    EXPECT_EQ(names, (std::vector<std::string>{"b", "c", "f"}));
}

TEST(Compaction, AllNoneAndNobody) {
    std::vector<int> numbers{7, 8, 9};
    const auto all = [](unsigned) { return true; };
    EXPECT_EQ(compact(3, all, numbers.data()), 3u);
    EXPECT_EQ(numbers, (std::vector<int>{7, 8, 9}));
    EXPECT_EQ(compact(
                  3, [](unsigned) { return false; }, numbers.data()),
              0u);
    EXPECT_EQ(compact(0, all, numbers.data()), 0u);
}

/// What `goesOn` sees and changes are the entries as they were, each once, before they move.
TEST(Compaction, AsksOnceInOrderAndBeforeItMoves) {
    std::vector<int> numbers{10, 11, 12, 13};
    std::vector<int> seen;
    const auto isOdd = [&](unsigned i) {
        seen.push_back(numbers[i]);
        numbers[i] *= 3;
        return numbers[i] % 2 == 1;
    };
    EXPECT_EQ(compact(4, isOdd, numbers.data()), 2u);
    EXPECT_EQ(seen, (std::vector<int>{10, 11, 12, 13}));
    EXPECT_EQ(numbers[0], 33);
    EXPECT_EQ(numbers[1], 39);
}

} // namespace
} // namespace wellstrat::render
