// SPDX-License-Identifier: Apache-2.0
#include "bank_search/partial_bank.h"

#include "bank_search/pair_columns.h"

#include <cmath>

namespace wellstrat::bank {
namespace {

/// Over n from `begin` on.
double sumOfProducts(const PairModel& model, const Order& first, const Order& second,
                     std::size_t begin) {
    double sum = 0;
    for (const Product& term : model.terms) {
        const float* const f = levelFunctions()[term.first].varying.data();
        const float* const g = levelFunctions()[term.second].varying.data();
        double products = 0;
        for (std::size_t n = begin; n < first.size(); ++n) {
            products += double(f[first[n]] * g[second[n]]);
        }
        sum += term.weight * products;
    }
    return sum;
}

/// The values of a level function for the indices from `begin` on.
std::vector<double> visited(std::size_t function, const Order& order, std::size_t begin) {
    const LevelFunction& f = levelFunctions()[function];
    std::vector<double> values;
    for (std::size_t n = begin; n < order.size(); ++n) {
        values.push_back(f.squaredMean + double(f.varying[order[n]]));
    }
    return values;
}

double sumOfProducts(const std::vector<double>& f, const std::vector<double>& g,
                     const std::vector<double>& h) {
    double sum = 0;
    for (std::size_t n = 0; n < f.size(); ++n) sum += f[n] * g[n] * h[n];
    return sum;
}

/// Calls visit(a, b, c) for all a > b > c.
template <typename Visit>
void forEachTriple(std::size_t slots, Visit visit) {
    for (std::size_t a = 0; a < slots; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            for (std::size_t c = 0; c < b; ++c) visit(a, b, c);
        }
    }
}

} // namespace

PartialBank::PartialBank(std::size_t slots)
    : bank_(slots), orders_(slots, Order{0}),
      pairSums_(slots * (slots - 1) / 2 * pairModels().size()),
      tripleSums_(slots * (slots - 1) * (slots - 2) / 6 * tripleModels().size()) {
    addSums(0);
}

PartialBank PartialBank::extended(const std::vector<uint16_t>& column) const {
    PartialBank next = *this;
    for (std::size_t d = 0; d < slots(); ++d) {
        next.bank_[d][digits_] = static_cast<uint16_t>(1u << digits_ | column[d]);
        appendColumn(next.orders_[d], next.bank_[d][digits_]);
    }
    ++next.digits_;
    next.addSums(1u << digits_);
    return next;
}

void PartialBank::addSums(unsigned begin) {
    double* pairSum = pairSums_.data();
    for (std::size_t a = 0; a < slots(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            for (const PairModel& model : pairModels()) {
                *pairSum++ += sumOfProducts(model, orders_[a], orders_[b], begin);
            }
        }
    }
    // What a triple is made of, by slot and level function.
    std::vector<std::vector<std::vector<double>>> values(slots());
    for (std::size_t d = 0; d < slots(); ++d) {
        values[d].resize(levelFunctions().size());
        for (const TripleModel& model : tripleModels()) {
            for (const TripleProduct& term : model.terms) {
                for (const std::size_t f : {term.first, term.second, term.third}) {
                    if (values[d][f].empty()) values[d][f] = visited(f, orders_[d], begin);
                }
            }
        }
    }
    double* tripleSum = tripleSums_.data();
    forEachTriple(slots(), [&](std::size_t a, std::size_t b, std::size_t c) {
        for (const TripleModel& model : tripleModels()) {
            for (const TripleProduct& term : model.terms) {
                *tripleSum +=
                    term.weight * sumOfProducts(values[a][term.first], values[b][term.second],
                                                values[c][term.third]);
            }
            ++tripleSum;
        }
    });
}

double PartialBank::price() const {
    double total = 0;
    for (std::size_t a = 0; a < slots(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
            for (std::size_t i = 0; i < pairModels().size(); ++i) {
                const PairModel& model = pairModels()[i];
                const double variance = model.apart[digits_] + pairSum(a, b, i);
                const auto ratio = static_cast<float>(variance / model.padded[digits_]);
                total += double(bank::price(model, digits_, ratio, standardOf(a)));
            }
        }
    }
    const double* tripleSum = tripleSums_.data();
    // As many triples as pairs, whatever the number of slots.
    const auto others = static_cast<float>(slots() - 2) / 3;
    forEachTriple(slots(), [&](std::size_t a, std::size_t, std::size_t) {
        for (const TripleModel& model : tripleModels()) {
            const double mean = std::ldexp(model.squaredMean, static_cast<int>(digits_));
            const auto ratio = static_cast<float>((*tripleSum++ - mean) / model.padded[digits_]);
            total += double(model.weight * bank::price(ratio, standardOf(a)) / others);
        }
    });
    return total;
}

} // namespace wellstrat::bank
