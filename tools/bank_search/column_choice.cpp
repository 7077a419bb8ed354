// SPDX-License-Identifier: Apache-2.0
#include "bank_search/column_choice.h"

#include "bank_search/pair_columns.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace wellstrat::bank {
namespace {

/// What pairs cost by their columns.
class ColumnPrices {
public:
    ColumnPrices(const PartialBank& bank, std::size_t firstFree)
        : bank_(bank), firstFree_(firstFree), size_(std::size_t{1} << bank.digits()),
          prices_(bank.slots() * bank.slots()) {
        for (std::size_t d = 0; d < bank.slots(); ++d) {
            inverses_.push_back(inverted(bank.order(d)));
        }
        const PairColumns columns(bank.digits());
        tbb::parallel_for(std::size_t{0}, prices_.size(), [&](std::size_t pair) {
            const std::size_t a = pair / bank.slots(), b = pair % bank.slots();
            if (b < a && a >= firstFree) prices_[pair] = pricesOf(a, b, columns);
        });
    }

    std::size_t size() const { return size_; } ///< the number of columns that a slot can have

    double price(const std::vector<uint16_t>& column) const {
        double total = 0;
        for (std::size_t a = firstFree_; a < bank_.slots(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                total += double(of(a, b)[column[a] ^ moved(a, b, column[b])]);
            }
        }
        return total;
    }

    /// The price of each column of slot d >= firstFree beside the others.
    std::vector<float> pricesOfSlot(std::size_t d, const std::vector<uint16_t>& column) const {
        std::vector<float> prices(size_);
        for (std::size_t b = 0; b < d; ++b) {
            const std::vector<float>& pair = of(d, b);
            const unsigned other = moved(d, b, column[b]);
            for (std::size_t c = 0; c < size_; ++c) prices[c] += pair[c ^ other];
        }
        for (std::size_t a = d + 1; a < bank_.slots(); ++a) {
            const std::vector<float>& pair = of(a, d);
            for (std::size_t c = 0; c < size_; ++c) prices[c] += pair[column[a] ^ moved(a, d, c)];
        }
        return prices;
    }

private:
    const std::vector<float>& of(std::size_t a, std::size_t b) const {
        return prices_[a * bank_.slots() + b];
    }

    /// U_a U_b^-1 c.
    unsigned moved(std::size_t a, std::size_t b, std::size_t c) const {
        return bank_.order(a)[inverses_[b][c]];
    }

    /// The prices of a pair by c_a XOR U_a U_b^-1 c_b.
    std::vector<float> pricesOf(std::size_t a, std::size_t b, const PairColumns& columns) const {
        const unsigned digits = bank_.digits() + 1;
        Order relative(size_);
        for (std::size_t t = 0; t < size_; ++t) relative[t] = bank_.order(b)[inverses_[a][t]];
        std::vector<float> prices(size_);
        columns.forEachModel(relative, [&](std::size_t i, const std::vector<float>& sums) {
            const PairModel& model = pairModels()[i];
            const double padded = model.padded[digits];
            const double before = (model.apart[digits] + bank_.pairSum(a, b, i)) / padded;
            const auto scale = static_cast<float>(1 / (padded * static_cast<double>(size_)));
            const auto start = static_cast<float>(before);
            const Standard standard = standardOf(a);
            for (std::size_t c = 0; c < size_; ++c) {
                prices[c] += bank::price(model, digits, start + sums[c] * scale, standard);
            }
        });
        return prices;
    }

    const PartialBank& bank_;
    std::size_t firstFree_, size_;
    std::vector<Order> inverses_;
    std::vector<std::vector<float>> prices_;
};

/// Gives each slot in turn its cheapest column until none changes. Those not in `settled` first.
void descend(const ColumnPrices& prices, std::size_t firstFree, std::vector<uint16_t>& column,
             std::vector<bool> settled) {
    constexpr float kGain = 1e-4f; // more than rounding errors
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t d = firstFree; d < column.size(); ++d) {
            if (settled[d]) continue;
            settled[d] = true;
            const std::vector<float> ofSlot = prices.pricesOfSlot(d, column);
            const auto best = std::min_element(ofSlot.begin(), ofSlot.end());
            if (*best >= ofSlot[column[d]] - kGain) continue;
            column[d] = static_cast<uint16_t>(best - ofSlot.begin());
            settled.assign(settled.size(), false);
            settled[d] = true;
            changed = true;
        }
    }
}

} // namespace

std::vector<ColumnChoice> chooseColumns(const PartialBank& bank, const Bank& fixed,
                                        const ChoiceOptions& options, std::mt19937& random) {
    const std::size_t firstFree = fixed.size(), slots = bank.slots();
    const ColumnPrices prices(bank, firstFree);
    const auto randomColumn = [&] { return static_cast<uint16_t>(random() % prices.size()); };
    std::vector<uint16_t> current(slots);
    for (std::size_t d = 0; d < slots; ++d) {
        const bool isFree = d >= firstFree;
        current[d] = isFree ? randomColumn()
                            : static_cast<uint16_t>(fixed[d][bank.digits()] % prices.size());
    }
    descend(prices, firstFree, current, std::vector<bool>(slots));
    double currentPrice = prices.price(current);
    std::set<std::pair<double, std::vector<uint16_t>>> found{{currentPrice, current}};
    for (unsigned attempt = 0; attempt < options.attempts; ++attempt) {
        std::vector<uint16_t> column = current;
        std::vector<bool> settled(slots);
        const std::size_t moved =
            2 + random() % std::clamp<std::size_t>((slots - firstFree) / 2, 1, 4);
        for (std::size_t i = 0; i < moved; ++i) {
            const std::size_t d = firstFree + random() % (slots - firstFree);
            column[d] = randomColumn();
            settled[d] = true; // the others first
        }
        descend(prices, firstFree, column, settled);
        const double price = prices.price(column);
        found.insert({price, column});
        if (found.size() > options.kept) found.erase(std::prev(found.end()));
        // Somewhat worse ones are accepted too, so as to get away from a local minimum.
        constexpr double kExcess = 0.004;
        const double accepted = currentPrice * (1 + kExcess * double(random() >> 8) * 0x1p-24);
        if (price < accepted) {
            current = std::move(column);
            currentPrice = price;
        }
    }
    std::vector<ColumnChoice> choices;
    for (const auto& [price, column] : found) choices.push_back({column, price});
    return choices;
}

} // namespace wellstrat::bank
