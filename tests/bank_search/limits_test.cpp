// SPDX-License-Identifier: Apache-2.0
//
// What no bank can have with 64 points (docs/decisions/0027-no-bad-pair.md), by trying all orders.

#include "bank_search/judge.h"
#include "lab.h"

#include "wellstrat/sobol.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace bank_tests {
namespace {

using namespace wellstrat::bank;

constexpr unsigned kFewDigits = 6;
constexpr unsigned kOrders = 1u << 14; ///< of 64 points, with 2 for the second column

/// The order of a number: its bits are those above the diagonal, from the third column on. The
/// second column of an order or of its swapped one is 2, and the two are the same slot.
Columns orderNumber(unsigned number) {
    Columns columns{1, 2};
    for (unsigned k = 2; k < kDigits; ++k) {
        columns[k] = static_cast<uint16_t>(1u << k | (number & ((1u << k) - 1)));
        number >>= k;
    }
    return columns;
}

unsigned numberOf(const Columns& columns) {
    unsigned number = 0, shift = 0;
    for (unsigned k = 2; k < kFewDigits; shift += k, ++k) {
        number |= (columns[k] & ((1u << k) - 1)) << shift;
    }
    return number;
}

/// U V^-1, or V U^-1: what the error of a pair depends on.
unsigned quotient(unsigned one, unsigned other) {
    const auto first = orderOf(orderNumber(one), kFewDigits);
    const auto second = orderOf(orderNumber(other), kFewDigits);
    Columns result{};
    for (unsigned k = 0; k < kFewDigits; ++k) {
        const auto place = std::find(second.begin(), second.end(), 1u << k) - second.begin();
        result[k] = first[static_cast<std::size_t>(place)];
    }
    return numberOf(result);
}

/// The worst ratio over all products with 64 points, by the order of the second slot.
std::vector<double> worstRatios(const std::vector<std::string>& names) {
    const Judge judge(judgedLab(names), kFewDigits);
    std::vector<double> worst;
    for (unsigned number = 0; number < kOrders; ++number) {
        double most = 0;
        for (const ByDigits& ratios : judge.ratios(orderNumber(0), orderNumber(number))) {
            most = std::max(most, ratios[kFewDigits]);
        }
        worst.push_back(most);
    }
    return worst;
}

/// The first digits of x, y, and of z in the orders U and P U, as sums of bits of the index.
std::array<unsigned, 4> firstDigits(const Columns& columns) {
    std::array<unsigned, 4> sums{};
    for (unsigned k = 0; k < kFewDigits; ++k) {
        const uint32_t swapped = wellstrat::pascalTimes(columns[k]);
        const auto digit = [](unsigned dimension, uint32_t index) {
            return wellstrat::sobolSample(wellstrat::sobolMatrix(dimension), index) >> 31;
        };
        sums[0] |= digit(0, columns[k]) << k;
        sums[1] |= digit(1, columns[k]) << k;
        sums[2] |= digit(2, columns[k]) << k;
        sums[3] |= digit(2, swapped) << k;
    }
    return sums;
}

/// A slot has four first digits, and with 64 points there are 32. So 9 slots or more have two that
/// share one, and 16 slots two that share one of z: 32 of those leave none to the other 32.
TEST(BankLimits, SlotsThatShareAFirstDigitAreBad) {
    const std::vector<double> worst = worstRatios(plainLab());
    const auto own = firstDigits(orderNumber(0));
    for (unsigned i = 0; i < 4; ++i) {
        EXPECT_EQ(own[i] & 1u, 1u);
        EXPECT_EQ(std::count(own.begin(), own.end(), own[i]), 1);
    }
    double least = 9, leastOfZ = 9;
    for (unsigned number = 0; number < kOrders; ++number) {
        const auto other = firstDigits(orderNumber(number));
        for (unsigned i = 0; i < 4; ++i) {
            for (unsigned j = 0; j < 4; ++j) {
                if (own[i] != other[j]) continue;
                least = std::min(least, worst[number]);
                if (i >= 2 || j >= 2) leastOfZ = std::min(leastOfZ, worst[number]);
            }
        }
    }
    EXPECT_NEAR(least, 2.38, 0.01);
    EXPECT_NEAR(leastOfZ, 2.53, 0.01);
}

/// Slots of which no pair is worse than `limit`, beside slot 0: orders that are good for it, and of
/// which all quotients are.
class GoodSlots {
public:
    GoodSlots(const std::vector<double>& worst, double limit) {
        std::vector<unsigned> good;
        for (unsigned number = 0; number < kOrders; ++number) {
            if (worst[number] <= limit) good.push_back(number);
        }
        std::vector<std::vector<unsigned>> later(good.size());
        for (unsigned a = 0; a < good.size(); ++a) {
            for (unsigned b = a + 1; b < good.size(); ++b) {
                if (worst[quotient(good[a], good[b])] <= limit) later[a].push_back(b);
            }
        }
        std::vector<unsigned> all(good.size());
        for (unsigned a = 0; a < all.size(); ++a) all[a] = a;
        extend(later, all, 1);
    }

    std::size_t most() const { return most_; }

private:
    void extend(const std::vector<std::vector<unsigned>>& later, const std::vector<unsigned>& left,
                std::size_t slots) {
        most_ = std::max(most_, slots);
        for (const unsigned a : left) {
            std::vector<unsigned> common;
            std::set_intersection(left.begin(), left.end(), later[a].begin(), later[a].end(),
                                  std::back_inserter(common));
            extend(later, common, slots + 1);
        }
    }

    std::size_t most_ = 0;
};

TEST(BankLimits, NotManySlotsAreGoodForAllOfTheLab) {
    const std::vector<double> worst = worstRatios(wholeLab());
    EXPECT_EQ(GoodSlots(worst, 1.15).most(), 2u);
    EXPECT_EQ(GoodSlots(worst, 1.35).most(), 4u);
    EXPECT_EQ(GoodSlots(worst, 1.45).most(), 5u);
}

} // namespace
} // namespace bank_tests
