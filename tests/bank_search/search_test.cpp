// SPDX-License-Identifier: Apache-2.0
//
// The search against plain sums, and what a search gives.

#include "bank_search/search.h"

#include "banks.h"

#include "bank_search/column_choice.h"
#include "bank_search/pair_columns.h"
#include "bank_search/walsh.h"
#include "wellstrat/sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

namespace bank_tests {
namespace {

using wellstrat::pascalTimes;

PartialBank partial(const Bank& bank, unsigned digits) {
    PartialBank result(bank.size());
    for (unsigned k = 0; k < digits; ++k) {
        std::vector<uint16_t> column;
        for (const Columns& slot : bank) {
            column.push_back(static_cast<uint16_t>(slot[k] ^ (1u << k)));
        }
        result = result.extended(column);
    }
    return result;
}

double triplePrice(const TripleModel& model, const Bank& bank, std::size_t a, std::size_t b,
                   std::size_t c, unsigned digits) {
    const Order first = orderOf(bank[a]), second = orderOf(bank[b]), third = orderOf(bank[c]);
    const auto value = [](std::size_t f, unsigned n) {
        return levelFunctions()[f].squaredMean + double(levelFunctions()[f].varying[n]);
    };
    double sum = 0;
    for (unsigned n = 0; n < 1u << digits; ++n) {
        for (const TripleProduct& term : model.terms) {
            sum += term.weight * value(term.first, first[n]) * value(term.second, second[n]) *
                   value(term.third, third[n]);
        }
    }
    const double variance = sum - std::ldexp(model.squaredMean, int(digits));
    return double(model.weight *
                  price(static_cast<float>(variance / model.padded[digits]), standardOf(a)));
}

/// The price of all pairs, straight from the definition.
double pairPrices(const Bank& bank, unsigned digits) {
    double total = 0;
    for (std::size_t a = 0; a < bank.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            for (const PairModel& model : pairModels()) {
                const ByDigits ratios =
                    squaredRatios(model, orderOf(bank[a], digits), orderOf(bank[b], digits));
                total +=
                    double(price(model, digits, static_cast<float>(ratios[digits]), standardOf(a)));
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

TEST(BankSearch, PriceIsWhatTheDefinitionSays) {
    const Bank bank = randomBank(4, 7);
    constexpr unsigned kCount = 6;
    double plain = pairPrices(bank, kCount);
    for (const TripleModel& model : tripleModels()) {
        for (const auto& [a, b, c] : {std::array{2, 1, 0}, {3, 1, 0}, {3, 2, 0}, {3, 2, 1}}) {
            plain += triplePrice(model, bank, std::size_t(a), std::size_t(b), std::size_t(c),
                                 kCount) *
                     1.5; // as many as pairs
        }
    }
    EXPECT_NEAR(partial(bank, kCount).price(), plain, 1e-4 * plain);
}

/// Nothing to the limit, then steeply more, for lower slots sooner; not with less than 64 points.
TEST(BankSearch, ProductsOfIntegrandsHaveALimit) {
    std::size_t integrands = 0;
    for (const PairModel& model : pairModels()) {
        if (model.weight > 0) continue;
        ++integrands;
        for (const std::size_t slot : {1u, 5u, 12u}) {
            const Standard standard = standardOf(slot);
            const float limit = standard.limit;
            EXPECT_EQ(price(model, 6, 0.99f * limit * limit, standard), 0) << model.name;
            EXPECT_GT(price(model, 6, 1.69f * limit * limit, standard),
                      price(model, 6, 1.44f * limit * limit, standard) * 1.5f);
            EXPECT_EQ(price(model, 5, 9, standard), 0);
        }
    }
    EXPECT_GT(integrands, 100u);
    EXPECT_LT(standardOf(1).limit, standardOf(2).limit);
    EXPECT_GT(standardOf(1).weight, standardOf(2).weight);
    EXPECT_LT(standardOf(3).limit, standardOf(4).limit);
    EXPECT_LT(standardOf(7).limit, standardOf(8).limit);
}

/// Each model that is not symmetric has both directions.
TEST(BankSearch, NoDirectionOfAPairIsHidden) {
    const Bank bank = randomBank(2, 5);
    const std::string suffix = ", exchanged";
    std::string name;
    ByDigits before{}; // of the model of that name
    std::size_t unlike = 0;
    for (const PairModel& model : pairModels()) {
        const ByDigits there = squaredRatios(model, orderOf(bank[0]), orderOf(bank[1]));
        const ByDigits back = squaredRatios(model, orderOf(bank[1]), orderOf(bank[0]));
        if (model.name == name + suffix) {
            for (const unsigned m : {4u, 6u}) EXPECT_NEAR(back[m], before[m], 1e-5) << name;
        } else {
            EXPECT_EQ(model.name.find(suffix), std::string::npos) << model.name << " alone";
        }
        if (std::abs(there[6] - back[6]) > 1e-3) ++unlike;
        name = model.name;
        before = there;
    }
    EXPECT_GT(unlike, 50u);
    for (const unsigned digits : {4u, 6u}) {
        const double total = pairPrices(bank, digits);
        EXPECT_NEAR(pairPrices({bank[1], bank[0]}, digits), total, 1e-4 * total);
    }
}

/// Half of all patterns have the order P U, so that U and P U are the same slot.
TEST(BankSearch, SlotsAreKnownButForTheSwap) {
    const Bank bank = randomBank(2, 9);
    Columns swapped{};
    for (unsigned k = 0; k < kDigits; ++k) {
        swapped[k] = static_cast<uint16_t>(pascalTimes(bank[1][k]));
    }
    EXPECT_NE(swapped[1], bank[1][1]);
    for (const PairModel& model : pairModels()) {
        const ByDigits one = squaredRatios(model, orderOf(bank[0]), orderOf(bank[1]));
        const ByDigits other = squaredRatios(model, orderOf(bank[0]), orderOf(swapped));
        for (const unsigned m : {4u, 8u, 12u, 16u}) EXPECT_NEAR(one[m], other[m], 1e-5) << m;
    }
}

TEST(BankSearch, ColumnsOfAPairArePricedAtOnce) {
    constexpr unsigned kColumn = 5;
    const Bank bank = randomBank(2, 2);
    const Order one = orderOf(bank[0], kColumn), other = orderOf(bank[1], kColumn);
    const Order inverse = inverted(one), otherInverse = inverted(other);
    Order relative;
    for (const uint16_t t : inverse) relative.push_back(other[t]);
    const PairColumns columns(kColumn);
    columns.forEachModel(relative, [&](std::size_t i, const std::vector<float>& sums) {
        if (i % 7 != 0) return;
        for (const auto& [c, d] : {std::pair(0u, 0u), std::pair(11u, 0u), std::pair(6u, 29u)}) {
            double plain = 0;
            for (unsigned t = 0; t < 32; ++t) {
                for (const Product& term : pairModels()[i].terms) {
                    plain += term.weight *
                             double(levelFunctions()[term.first].varying[32 + (one[t] ^ c)]) *
                             double(levelFunctions()[term.second].varying[32 + (other[t] ^ d)]);
                }
            }
            const unsigned moved = one[otherInverse[d]];
            EXPECT_NEAR(double(sums[c ^ moved]) / 32, plain, 1e-5) << i << ' ' << c << ' ' << d;
        }
    });
}

TEST(BankSearch, ChosenColumnsCostWhatTheySayAndLessThanRandomOnes) {
    const PartialBank bank = partial(randomBank(3, 4), 6);
    std::mt19937 random(1);
    const auto choices = chooseColumns(bank, Bank(1), {20, 5}, random);
    ASSERT_FALSE(choices.empty());
    const auto priceOf = [&](const std::vector<uint16_t>& column) {
        return pairPrices(bank.extended(column).bank(), 7);
    };
    for (const ColumnChoice& choice : choices) {
        EXPECT_EQ(choice.column[0], 0);
        EXPECT_NEAR(choice.price, priceOf(choice.column), 1e-3 * choice.price);
        EXPECT_GE(choice.price, choices[0].price);
    }
    for (unsigned attempt = 0; attempt < 8; ++attempt) {
        const std::vector<uint16_t> column{0, static_cast<uint16_t>(random() % 64),
                                           static_cast<uint16_t>(random() % 64)};
        EXPECT_GE(priceOf(column), choices[0].price - 1e-3);
    }
}

SearchOptions quickSearch() {
    SearchOptions options;
    options.digits = 8;
    options.width = 4;
    options.attempts = 5;
    options.slots = 8;
    return options;
}

TEST(BankSearch, SlotsAreUpperTriangularAndTheFirstIsTheIdentity) {
    SearchOptions options = quickSearch();
    options.slots = 5;
    double last = 0;
    const Bank bank = searchBank(options, [&](double done) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        last = done;
    });
    EXPECT_EQ(last, 1);
    ASSERT_EQ(bank.size(), 5u);
    for (const Columns& columns : bank) {
        for (unsigned k = 0; k < options.digits; ++k) EXPECT_EQ(columns[k] >> k, 1);
    }
    for (unsigned k = 0; k < options.digits; ++k) EXPECT_EQ(bank[0][k], 1u << k);
}

TEST(BankSearch, IsReproducibleAndSeedsDiffer) {
    SearchOptions options = quickSearch();
    const Bank bank = searchBank(options, [](double) {});
    EXPECT_EQ(searchBank(options, [](double) {}), bank);
    ++options.seed;
    EXPECT_NE(searchBank(options, [](double) {}), bank);
}

TEST(BankSearch, IsBetterThanRandom) {
    const SearchOptions options = quickSearch();
    const double found = pairPrices(searchBank(options, [](double) {}), 8);
    for (uint32_t seed = 1; seed <= 2; ++seed) {
        EXPECT_LT(found, 0.5 * pairPrices(randomBank(8, seed), 8));
    }
}

} // namespace
} // namespace bank_tests
