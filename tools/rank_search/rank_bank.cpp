// SPDX-License-Identifier: Apache-2.0
#include "rank_search/rank_bank.h"

#include "bank_search/slot_order.h"
#include "bank_search/walsh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace wellstrat::ranks {
namespace {

/// What functions of one slot count for a tile, where those of two count 1.
constexpr double kShareOfOne = 4;

double squareOf(double x) { return x * x; }
double cubeOf(double x) { return x * x * x; }

Visits visitsOf(const RankBank& bank, std::size_t slot) {
    return ranks::visitsOf(static_cast<unsigned>(slot), bank[slot]);
}

/// Another slot beside the one that is looked at.
struct Partner {
    Visits visits;
    double share; ///< of all partners
    double merit; ///< of the pair, if the bank has the slot; 1 if not
};

std::vector<Partner> partnersOf(const RankBank& bank, std::size_t slot, const Weights& weights) {
    std::vector<Partner> partners;
    double total = 0;
    for (std::size_t d = 0; d < bank.size(); ++d) {
        if (d == slot) continue;
        partners.push_back({visitsOf(bank, d), weightForColumns(d), 1});
        total += weightForColumns(d);
        if (slot >= bank.size()) continue;
        partners.back().merit = merit(
            weights, covarianceOf(sumsOfPairs(), visitsOf(bank, slot), partners.back().visits));
    }
    for (Partner& partner : partners) partner.share /= total;
    return partners;
}

/// What each function of the slot is multiplied with, element n * kRanks + r, to give the price.
using Factors = std::vector<std::vector<double>>;

void addFactors(const Sums& sums, double share, const Visits& other, const Weights& weights,
                Factors* factors) {
    for (const Sums::Term& term : sums.terms) {
        std::vector<double>& factor = (*factors)[term.first];
        factor.resize(std::size_t{kRun} * kRanks);
        for (std::size_t n = 0; n < kRun; ++n) {
            const double* const g = rowOf(functions()[term.second], other, n);
            double* const sum = factor.data() + n * kRanks;
            for (std::size_t r = 0; r < kRanks; ++r) {
                sum[r] += share * term.weight[n] * weights[r] * g[other.images[r]];
            }
        }
    }
}

/// Of the price to first order around that of the slot's present columns, but for a constant.
Factors factorsOf(const RankBank& bank, std::size_t slot, const Weights& weights) {
    Factors factors(functions().size());
    for (const Partner& partner : partnersOf(bank, slot, weights)) {
        addFactors(sumsOfPairs(), 3 * squareOf(partner.merit) * partner.share, partner.visits,
                   weights, &factors);
    }
    return factors;
}

/// A slot whose first columns are chosen.
struct PartialSlot {
    RankColumns columns{};
    std::vector<uint16_t> images{0};
    double price = 0;
};

struct Candidate {
    double price;
    std::size_t parent;
    uint16_t column;

    bool operator<(const Candidate& other) const {
        return std::tie(price, parent, column) < std::tie(other.price, other.parent, other.column);
    }
};

/// The search for column k of a slot.
class ColumnSearch {
public:
    ColumnSearch(std::size_t slot, const Factors& factors, unsigned k)
        : factors_(factors), k_(k), size_(std::size_t{4} << (k / 2 * 2)), own_(factors.size()) {
        const Visits visits = ranks::visitsOf(static_cast<unsigned>(slot), identityColumns());
        for (std::size_t f = 0; f < factors_.size(); ++f) {
            if (factors_[f].empty()) continue;
            for (std::size_t n = 0; n < kRun; ++n) {
                const double* const row = rowOf(functions()[f], visits, n);
                own_[f].emplace_back(row, row + size_);
                bank::walshTransform(own_[f].back());
            }
        }
    }

    /// What each column, in [0, size()), adds to the price.
    std::vector<double> prices(const PartialSlot& slot) const {
        std::vector<double> sums(size_), other(size_);
        const std::size_t half = slot.images.size();
        for (std::size_t f = 0; f < factors_.size(); ++f) {
            if (factors_[f].empty()) continue;
            for (std::size_t n = 0; n < kRun; ++n) {
                const double* const values = factors_[f].data() + n * kRanks + half;
                std::fill(other.begin(), other.end(), 0.0);
                for (std::size_t t = 0; t < half; ++t) other[slot.images[t]] = values[t];
                bank::walshTransform(other);
                const std::vector<double>& own = own_[f][n];
                for (std::size_t i = 0; i < size_; ++i) sums[i] += own[i] * other[i];
            }
        }
        bank::walshTransform(sums);
        for (double& sum : sums) sum /= static_cast<double>(size_);
        return sums;
    }

    /// Whether the block on the diagonal stays invertible with this column.
    bool fits(const PartialSlot& slot, unsigned column) const {
        const unsigned level = k_ / 2, digit = column >> (2 * level);
        return digit != 0 &&
               (k_ % 2 == 0 || digit != unsigned{slot.columns[k_ - 1]} >> (2 * level));
    }

    std::size_t size() const { return size_; }

private:
    const Factors& factors_;
    unsigned k_;
    std::size_t size_;
    std::vector<std::vector<std::vector<double>>> own_; ///< transforms, by function and n
};

/// Of the beam: early columns decide most, late ones take the time.
std::size_t widthAfter(unsigned k) { return std::clamp(1024u >> k, 4u, 64u); }

} // namespace

double weightForColumns(std::size_t slot) { return std::exp2(-static_cast<double>(slot) / 8); }
double weightForTile(std::size_t slot) { return std::exp2(-static_cast<double>(slot) / 2); }

Covariance covarianceOfSlots(const RankBank& bank) {
    std::vector<Visits> visits;
    for (std::size_t d = 0; d < bank.size(); ++d) visits.push_back(visitsOf(bank, d));
    Covariance result(kRanks);
    double ofSlots = 0, ofPairs = 0;
    for (std::size_t a = 0; a < bank.size(); ++a) {
        ofSlots += weightForTile(a);
        for (std::size_t b = 0; b < a; ++b) ofPairs += weightForTile(a) * weightForTile(b);
    }
    const auto add = [&](double weight, const Covariance& covariance) {
        for (std::size_t r = 0; r < kRanks; ++r) result[r] += weight * covariance[r];
    };
    for (std::size_t a = 0; a < bank.size(); ++a) {
        add(kShareOfOne * weightForTile(a) / ofSlots,
            covarianceOf(sumsOfOne(), visits[a], visits[a]));
        for (std::size_t b = 0; b < a; ++b) {
            add(weightForTile(a) * weightForTile(b) / ofPairs,
                covarianceOf(sumsOfPairs(), visits[a], visits[b]));
        }
    }
    return result;
}

double slotPrice(const RankBank& bank, std::size_t slot, const Weights& weights) {
    double price = 0;
    for (const Partner& partner : partnersOf(bank, slot, weights)) {
        price += partner.share * cubeOf(partner.merit);
    }
    return price;
}

RankColumns bestColumns(const RankBank& bank, std::size_t slot, const Weights& weights) {
    const Factors factors = factorsOf(bank, slot, weights);
    std::vector<PartialSlot> beam{PartialSlot{}};
    for (unsigned k = 0; k < kRankDigits; ++k) {
        const ColumnSearch search(slot, factors, k);
        std::vector<std::vector<double>> prices(beam.size());
        tbb::parallel_for(std::size_t{0}, beam.size(),
                          [&](std::size_t i) { prices[i] = search.prices(beam[i]); });
        std::vector<Candidate> candidates;
        for (std::size_t i = 0; i < beam.size(); ++i) {
            for (unsigned c = 0; c < search.size(); ++c) {
                if (!search.fits(beam[i], c)) continue;
                candidates.push_back({beam[i].price + prices[i][c], i, static_cast<uint16_t>(c)});
            }
        }
        const std::size_t kept = std::min(widthAfter(k), candidates.size());
        std::partial_sort(candidates.begin(),
                          candidates.begin() + static_cast<std::ptrdiff_t>(kept), candidates.end());
        std::vector<PartialSlot> next;
        for (std::size_t i = 0; i < kept; ++i) {
            next.push_back(beam[candidates[i].parent]);
            next.back().columns[k] = candidates[i].column;
            bank::appendColumn(next.back().images, candidates[i].column);
            next.back().price = candidates[i].price;
        }
        beam = std::move(next);
    }
    return beam.front().columns;
}

void improve(const Weights& weights, RankBank* bank, const std::function<void()>& searched) {
    for (std::size_t slot = 1; slot < bank->size(); ++slot) {
        RankBank changed = *bank;
        changed[slot] = bestColumns(*bank, slot, weights);
        if (slotPrice(changed, slot, weights) < slotPrice(*bank, slot, weights)) *bank = changed;
        searched();
    }
}

} // namespace wellstrat::ranks
