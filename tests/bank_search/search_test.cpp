// SPDX-License-Identifier: Apache-2.0
//
// The beam search against plain sums, and what a search gives.

#include "bank_search/search.h"

#include "banks.h"

#include "bank_search/walsh.h"

#include <gtest/gtest.h>

#include <bitset>
#include <cmath>
#include <set>
#include <vector>

namespace bank_tests {
namespace {

double triplePrice(const TripleModel& model, const std::vector<uint16_t>& first,
                   const std::vector<uint16_t>& second, const std::vector<uint16_t>& third) {
    double sum = 0, total = 0;
    for (unsigned m = 0, n = 0; m <= kDigits; ++m) {
        for (; n < 1u << m; ++n) {
            for (const TripleProduct& term : model.terms) {
                sum += double(term.weight * term.first[first[n]] * term.second[second[n]] *
                              term.third[third[n]]);
            }
        }
        if (m < kFirstDigits) continue;
        const double variance = std::ldexp(sum, -static_cast<int>(m)) - double(model.squaredMean);
        total += double(price(static_cast<float>(variance) / model.padded[m]));
    }
    return total;
}

/// The price of a slot beside others, straight from the definition.
double plainPrice(const Bank& bank, std::size_t number) {
    const auto order = orderOf(bank[number]);
    double total = 0;
    for (std::size_t i = 0; i < bank.size(); ++i) {
        if (i == number) continue;
        for (const PairModel& model : pairModels()) {
            const auto ratios = squaredRatios(model, order, orderOf(bank[i]));
            for (unsigned m = kFirstDigits; m <= kDigits; ++m) {
                total += double(model.weight * price(static_cast<float>(ratios[m])));
            }
        }
    }
    for (const TripleModel& model : tripleModels()) {
        for (std::size_t a = 0; a < bank.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                if (a == number || b == number) continue;
                total += double(model.weight) *
                         triplePrice(model, order, orderOf(bank[a]), orderOf(bank[b])) /
                         static_cast<double>(bank.size() - 1);
            }
        }
    }
    return total;
}

TEST(BankSearch, WalshTransformTurnsConvolutionsIntoProducts) {
    std::vector<float> f{1, 2, 3, 4, 0, -1, 5, 2}, g{2, 0, 1, 3, 1, 1, -2, 4}, plain(8);
    for (unsigned c = 0; c < 8; ++c) {
        for (unsigned i = 0; i < 8; ++i) plain[c] += f[i] * g[i ^ c];
    }
    walshTransform(f);
    walshTransform(g);
    for (unsigned i = 0; i < 8; ++i) f[i] *= g[i];
    walshTransform(f);
    for (unsigned c = 0; c < 8; ++c) EXPECT_EQ(f[c], 8 * plain[c]);
}

TEST(BankSearch, SlotPriceIsWhatTheDefinitionSays) {
    const Bank bank = randomBank(4, 7);
    for (const std::size_t number : {0u, 3u}) {
        const double plain = plainPrice(bank, number);
        EXPECT_NEAR(slotPrice(bank, number), plain, 5e-3 * plain) << number; // single precision
    }
}

TEST(BankSearch, BestSlotIsBetterThanRandomOnes) {
    std::mt19937 random(1);
    Bank bank{orderedAsIs()};
    bank.push_back(bestSlot(bank, 1, {}, random));
    bank.push_back(bestSlot(bank, 2, {}, random));
    const double found = slotPrice(bank, 2);
    for (unsigned attempt = 0; attempt < 50; ++attempt) {
        bank[2] = randomColumns(random);
        EXPECT_LT(found, slotPrice(bank, 2));
    }
}

TEST(BankSearch, SlotsAreUpperTriangularAndTheFirstIsTheIdentity) {
    SearchOptions options;
    options.slots = 5;
    options.rounds = 2;
    double last = 0;
    const Bank bank = searchBank(options, [&](double done) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        last = done;
    });
    ASSERT_EQ(bank.size(), 5u);
    for (const Columns& columns : bank) {
        for (unsigned k = 0; k < kDigits; ++k) EXPECT_EQ(columns[k] >> k, 1);
    }
    for (unsigned k = 0; k < kDigits; ++k) EXPECT_EQ(bank[0][k], 1u << k);
}

/// Of all pairs of slots, how many agree in the function of the first `digits` index bits that
/// `functional` has.
template <typename Functional>
unsigned agreeing(const Bank& bank, unsigned digits, Functional functional) {
    std::set<std::vector<unsigned>> different;
    for (const Columns& columns : bank) {
        std::vector<unsigned> bits;
        for (unsigned k = 0; k < digits; ++k) bits.push_back(functional(columns[k]));
        different.insert(bits);
    }
    return static_cast<unsigned>(bank.size() - different.size());
}

TEST(BankSearch, FirstDigitsDifferAsFarAsTheyCan) {
    SearchOptions options;
    options.rounds = 0;
    const Bank bank = searchBank(options, [](double) {});
    const auto x = [](unsigned column) { return column & 1u; };
    const auto y = [](unsigned column) { return std::bitset<16>(column).count() % 2; };
    const auto sum = [&](unsigned column) { return x(column) ^ static_cast<unsigned>(y(column)); };
    const auto both = [&](unsigned column) {
        return x(column) + 2 * static_cast<unsigned>(y(column));
    };
    EXPECT_EQ(agreeing(bank, 6, x), 0u);
    EXPECT_EQ(agreeing(bank, 6, [&](unsigned c) { return static_cast<unsigned>(y(c)); }), 0u);
    EXPECT_EQ(agreeing(bank, 6, sum), 0u);
    EXPECT_EQ(agreeing(bank, 4, both), 0u);
    const Bank four(bank.begin(), bank.begin() + 4);
    EXPECT_EQ(agreeing(four, 4, x), 0u);
    EXPECT_EQ(agreeing(four, 4, sum), 0u);
}

TEST(BankSearch, FewerSlotsAreTheFirstOnesOfMore) {
    SearchOptions options;
    options.rounds = 3;
    options.slots = 2;
    const Bank two = searchBank(options, [](double) {});
    options.slots = 4;
    const Bank four = searchBank(options, [](double) {});
    EXPECT_EQ(two, Bank(four.begin(), four.begin() + 2));
    EXPECT_EQ(four, searchBank(options, [](double) {}));
}

TEST(BankSearch, SeedsDiffer) {
    SearchOptions options;
    options.slots = 8;
    options.rounds = 3;
    const Bank bank = searchBank(options, [](double) {});
    options.seed = 2;
    EXPECT_NE(searchBank(options, [](double) {}), bank);
}

} // namespace
} // namespace bank_tests
