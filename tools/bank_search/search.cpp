// SPDX-License-Identifier: Apache-2.0
#include "bank_search/search.h"

#include <algorithm>
#include <numeric>

namespace wellstrat::bank {
namespace {

constexpr float kDisorder = 0.02f;
constexpr std::size_t kMostMoved = 4;

Columns identity() {
    Columns columns{};
    for (unsigned k = 0; k < kDigits; ++k) columns[k] = static_cast<uint16_t>(1u << k);
    return columns;
}

/// What the slots from `first` on cost, each beside those before it.
double priceFrom(const Bank& bank, std::size_t first) {
    double total = 0;
    for (std::size_t i = first; i < bank.size(); ++i) {
        const auto end = bank.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        total += slotPrice({bank.begin(), end}, i);
    }
    return total;
}

/// What a pair of slots costs.
double pairPrice(const Columns& first, const Columns& second) {
    const auto firstOrder = orderOf(first), secondOrder = orderOf(second);
    double total = 0;
    for (const PairModel& model : pairModels()) {
        const auto ratios = squaredRatios(model, firstOrder, secondOrder);
        for (unsigned m = kFirstDigits; m <= kDigits; ++m) {
            total += double(model.weight * price(static_cast<float>(ratios[m])));
        }
    }
    return total;
}

/// The slot from `first` on that has the most expensive pair.
std::size_t worstSlot(const Bank& bank, std::size_t first) {
    std::size_t worst = first;
    double highest = 0;
    for (std::size_t i = first; i < bank.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const double price = pairPrice(bank[i], bank[j]);
            if (price > highest) {
                highest = price;
                worst = i;
            }
        }
    }
    return worst;
}

/// The numbers from `first` to `end` in random order.
std::vector<std::size_t> shuffled(std::size_t first, std::size_t end, std::mt19937& random) {
    std::vector<std::size_t> numbers(end - first);
    std::iota(numbers.begin(), numbers.end(), first);
    for (std::size_t i = numbers.size(); i > 1; --i)
        std::swap(numbers[i - 1], numbers[random() % i]);
    return numbers;
}

/// Takes some slots from `first` on out, every other time that with the worst pair among them, and
/// looks for better ones in their place.
void improve(Bank& bank, std::size_t first, unsigned width, std::mt19937& random) {
    std::vector<std::size_t> moved = shuffled(first, bank.size(), random);
    if (random() % 2 == 0) {
        std::swap(*std::find(moved.begin(), moved.end(), worstSlot(bank, first)), moved.front());
    }
    moved.resize(1 + random() % std::min(kMostMoved, moved.size()));
    Bank kept;
    for (std::size_t i = 0; i < bank.size(); ++i) {
        if (std::find(moved.begin(), moved.end(), i) == moved.end()) kept.push_back(bank[i]);
    }
    Bank before = kept, after = kept;
    for (const std::size_t number : moved) {
        before.push_back(bank[number]);
        after.push_back(bestSlot(after, static_cast<unsigned>(number), {width, kDisorder}, random));
    }
    if (priceFrom(after, kept.size()) >= priceFrom(before, kept.size())) return;
    for (std::size_t i = 0; i < moved.size(); ++i) bank[moved[i]] = after[kept.size() + i];
}

/// The time of a round grows with the square of the number of slots. `last` is the largest number.
double shareDone(std::size_t before, std::size_t size, std::size_t last, double shareOfSize) {
    const auto squared = [](std::size_t count) { return static_cast<double>(count * count); };
    return (squared(before) + shareOfSize * (squared(size) - squared(before))) / squared(last);
}

} // namespace

Bank searchBank(const SearchOptions& options, const std::function<void(double)>& progress) {
    std::mt19937 random(options.seed);
    Bank bank{identity()};
    std::size_t last = 2;
    while (last < options.slots) last *= 2;
    for (std::size_t size = 2; size <= last; size *= 2) {
        const std::size_t first = bank.size();
        while (bank.size() < size) {
            const auto number = static_cast<unsigned>(bank.size());
            bank.push_back(bestSlot(bank, number, {options.width, 0}, random));
        }
        for (unsigned round = 0; round < options.rounds; ++round) {
            improve(bank, first, options.width, random);
            progress(shareDone(first, size, last, (round + 1.0) / options.rounds));
        }
    }
    bank.resize(options.slots);
    return bank;
}

} // namespace wellstrat::bank
