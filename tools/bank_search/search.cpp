// SPDX-License-Identifier: Apache-2.0
#include "bank_search/search.h"

#include "bank_search/column_choice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <utility>

namespace wellstrat::bank {
namespace {

struct Ranked {
    double price; ///< of all columns
    PartialBank bank;
};

/// A bank with one column more, still to be made.
struct Candidate {
    double price;
    std::size_t parent;
    std::vector<uint16_t> column;
};

/// How many banks are kept with so many columns: the same for all up to 64 points, as early columns
/// decide most, then half for each column more, but not too few while 4096 points are to come.
std::size_t widthOf(std::size_t width, unsigned digits) {
    if (digits > kTableSizeLog2) return 8;
    const unsigned halvings = digits > 6 ? digits - 6 : 0;
    return std::max<std::size_t>(width >> halvings, width / 16 + 2);
}

/// Drops those that cost the same as one before: other ways to write the same bank.
void keepCheapest(std::vector<Candidate>& candidates, std::size_t count) {
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.price < b.price; });
    constexpr double kSame = 1e-6;
    const auto end = std::unique(
        candidates.begin(), candidates.end(),
        [](const Candidate& a, const Candidate& b) { return b.price - a.price < kSame * a.price; });
    candidates.erase(end, candidates.end());
    if (candidates.size() > count) candidates.resize(count);
}

std::vector<Ranked> withNextColumn(const std::vector<Ranked>& beam, const Bank& fixed,
                                   const SearchOptions& options, std::size_t width,
                                   std::mt19937& random) {
    const unsigned digits = beam[0].bank.digits() + 1;
    if (digits <= 2) { // no choice: the other second column is that of P U
        return {{0, beam[0].bank.extended(std::vector<uint16_t>(beam[0].bank.slots()))}};
    }
    const double weight = double(weightOfDigits(digits));
    const std::size_t kept = std::max<std::size_t>(2, 2 * width / beam.size());
    std::vector<uint32_t> seeds;
    for (std::size_t i = 0; i < beam.size(); ++i) seeds.push_back(static_cast<uint32_t>(random()));
    std::vector<std::vector<ColumnChoice>> choices(beam.size());
    tbb::parallel_for(std::size_t{0}, beam.size(), [&](std::size_t i) {
        std::mt19937 own(seeds[i]);
        choices[i] = chooseColumns(beam[i].bank, fixed, {options.attempts, kept}, own);
    });
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < beam.size(); ++i) {
        for (ColumnChoice& choice : choices[i]) {
            candidates.push_back(
                {beam[i].price + weight * choice.price, i, std::move(choice.column)});
        }
    }
    keepCheapest(candidates, width);
    std::vector<Ranked> next(candidates.size(), {0, PartialBank(0)});
    tbb::parallel_for(std::size_t{0}, next.size(), [&](std::size_t i) {
        const Ranked& parent = beam[candidates[i].parent];
        PartialBank bank = parent.bank.extended(candidates[i].column);
        next[i] = {parent.price + weight * bank.price(), std::move(bank)};
    });
    std::stable_sort(next.begin(), next.end(),
                     [](const Ranked& a, const Ranked& b) { return a.price < b.price; });
    return next;
}

Bank identity() {
    Bank bank(1);
    for (unsigned k = 0; k < kDigits; ++k) bank[0][k] = static_cast<uint16_t>(1u << k);
    return bank;
}

/// The time that a step takes grows with the square of the number of slots. `last` is the largest.
double shareDone(std::size_t before, std::size_t size, std::size_t last, double shareOfStep) {
    const auto squared = [](std::size_t count) { return static_cast<double>(count * count); };
    return (squared(before) + shareOfStep * (squared(size) - squared(before))) / squared(last);
}

} // namespace

Bank searchBank(const SearchOptions& options, const std::function<void(double)>& progress) {
    const std::size_t last = *std::lower_bound(kSteps.begin(), kSteps.end(), options.slots);
    Bank bank = identity();
    for (std::size_t step = 0; bank.size() < options.slots; ++step) {
        std::mt19937 random(options.seed);
        const std::size_t width = std::max(1u, options.width >> 2 * step);
        std::vector<Ranked> beam{{0, PartialBank(kSteps[step])}};
        for (unsigned digits = 1; digits <= options.digits; ++digits) {
            beam = withNextColumn(beam, bank, options, widthOf(width, digits), random);
            progress(shareDone(step == 0 ? 0 : bank.size(), kSteps[step], last,
                               double(digits) / options.digits));
        }
        bank = beam[0].bank.bank();
    }
    bank.resize(options.slots);
    return bank;
}

} // namespace wellstrat::bank
