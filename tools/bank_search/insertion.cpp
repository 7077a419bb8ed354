// SPDX-License-Identifier: Apache-2.0
#include "bank_search/insertion.h"

#include "bank_search/walsh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

namespace wellstrat::bank {
namespace {

using Order = std::vector<uint16_t>;

constexpr unsigned kMostWidth = 64;

/// What the new slot's points are multiplied with: a function of other slots, visited in their
/// orders, and the sums so far. One for each term of each model and each partner or two.
struct Partner {
    const LevelFunction* own; ///< of the new slot
    LevelFunction other;      ///< by the index n
    float weight;
};

/// A model and one partner, or two: what has a price.
struct Encounter {
    float weight;
    float squaredMean;
    const std::array<float, kDigits + 1>* padded;
    std::vector<Partner> partners;
};

LevelFunction visited(const LevelFunction& function, const Order& order) {
    LevelFunction result(kPoints);
    for (unsigned n = 0; n < kPoints; ++n) result[n] = function[order[n]];
    return result;
}

std::vector<Encounter> encountersWith(const std::vector<Order>& others) {
    std::vector<Encounter> encounters;
    for (const Order& order : others) {
        for (const PairModel& model : pairModels()) {
            Encounter encounter{model.weight, model.squaredMean, &model.padded, {}};
            for (const Product& term : model.terms) {
                encounter.partners.push_back(
                    {&term.first, visited(term.second, order), term.weight});
            }
            encounters.push_back(std::move(encounter));
        }
    }
    for (const TripleModel& model : tripleModels()) {
        const float weight = model.weight / static_cast<float>(others.size());
        for (std::size_t a = 0; a < others.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                Encounter encounter{weight, model.squaredMean, &model.padded, {}};
                for (const TripleProduct& term : model.terms) {
                    LevelFunction both(kPoints);
                    for (unsigned n = 0; n < kPoints; ++n) {
                        both[n] = term.second[others[a][n]] * term.third[others[b][n]];
                    }
                    encounter.partners.push_back({&term.first, std::move(both), term.weight});
                }
                encounters.push_back(std::move(encounter));
            }
        }
    }
    return encounters;
}

/// A slot whose first columns are chosen.
struct PartialSlot {
    Columns columns{};
    Order order{0};
    std::vector<float> sums; ///< of each encounter, over the n so far
    double price = 0;
};

/// A slot with one column more, still to be made.
struct Candidate {
    double rank; ///< the price, with disorder
    double price;
    std::size_t parent;
    uint16_t column;

    bool operator<(const Candidate& other) const {
        return std::tie(rank, parent, column) < std::tie(other.rank, other.parent, other.column);
    }
};

/// The transforms of the new slot's functions over n in [2^k, 2^(k+1)).
using OwnTransforms = std::unordered_map<const LevelFunction*, std::vector<float>>;

class ColumnSearch {
public:
    explicit ColumnSearch(const std::vector<Encounter>& encounters) : encounters_(encounters) {}

    OwnTransforms ownTransforms(unsigned k) const {
        OwnTransforms transforms;
        for (const Encounter& encounter : encounters_) {
            for (const Partner& partner : encounter.partners) {
                std::vector<float>& own = transforms[partner.own];
                if (!own.empty()) continue;
                own.assign(partner.own->begin() + (1 << k), partner.own->begin() + (2 << k));
                walshTransform(own);
            }
        }
        return transforms;
    }

    /// The price of each column k of `slot`, by its bits below k.
    std::vector<float> prices(const PartialSlot& slot, unsigned k,
                              const OwnTransforms& transforms) const {
        const unsigned size = 1u << k;
        std::vector<uint16_t> inverse(size);
        for (unsigned i = 0; i < size; ++i) inverse[slot.order[i]] = static_cast<uint16_t>(i);
        std::vector<float> prices(size);
        std::vector<float> other(size), sums(size);
        const float count = static_cast<float>(2 * size);
        for (std::size_t e = 0; e < encounters_.size(); ++e) {
            const Encounter& encounter = encounters_[e];
            std::fill(sums.begin(), sums.end(), 0.0f);
            for (const Partner& partner : encounter.partners) {
                const float* values = partner.other.data() + size;
                for (unsigned t = 0; t < size; ++t) other[t] = values[inverse[t]];
                walshTransform(other);
                const std::vector<float>& own = transforms.at(partner.own);
                for (unsigned t = 0; t < size; ++t) sums[t] += partner.weight * own[t] * other[t];
            }
            walshTransform(sums);
            const float before = slot.sums[e], scale = 1 / static_cast<float>(size);
            const float padded = (*encounter.padded)[k + 1];
            for (unsigned c = 0; c < size; ++c) {
                const float variance = (before + sums[c] * scale) / count - encounter.squaredMean;
                prices[c] += encounter.weight * price(variance / padded);
            }
        }
        return prices;
    }

    PartialSlot extended(const PartialSlot& slot, unsigned k, uint16_t column) const {
        PartialSlot next = slot;
        next.columns[k] = column;
        appendColumn(next.order, column);
        for (std::size_t e = 0; e < encounters_.size(); ++e) {
            float sum = 0;
            for (const Partner& partner : encounters_[e].partners) {
                float products = 0;
                for (unsigned n = 1u << k; n < 2u << k; ++n) {
                    products += (*partner.own)[next.order[n]] * partner.other[n];
                }
                sum += partner.weight * products;
            }
            next.sums[e] += sum;
        }
        return next;
    }

private:
    const std::vector<Encounter>& encounters_;
};

PartialSlot startOf(const std::vector<Encounter>& encounters) {
    PartialSlot slot;
    for (const Encounter& encounter : encounters) {
        float sum = 0;
        for (const Partner& partner : encounter.partners) {
            sum += partner.weight * (*partner.own)[0] * partner.other[0];
        }
        slot.sums.push_back(sum);
    }
    return slot;
}

/// A number in [0, 1) that is the same with every C++ library.
float uniform(std::mt19937& random) { return static_cast<float>(random() >> 8) * 0x1p-24f; }

/// The exclusive or of the bits of `value`.
unsigned parity(unsigned value) {
    for (unsigned shift = 8; shift > 0; shift /= 2) value ^= value >> shift;
    return value & 1u;
}

/// w times b in the field of four elements 0, 1, w, w + 1, numbered 0 to 3.
unsigned timesW(unsigned b) { return (b << 1 & 2u) ^ (b & 2u ? 3u : 0u); }

/// Whether a column is in the design of the first digits of x and y that insertion.h describes.
bool hasFirstDigits(uint16_t column, unsigned k, unsigned number) {
    if (k == 0 || k > 5) return true;
    const unsigned x = column & 1u, y = parity(column);
    if (k == 1) return x == 0;
    const unsigned low = number & 3u, high = number >> 2, bit = k & 1u;
    const unsigned sum = k < 4 ? low : high;
    const unsigned wanted = k < 4 ? timesW(low) ^ high : timesW(high);
    return x == (wanted >> bit & 1u) && (x ^ y) == 1 - (sum >> bit & 1u);
}

/// Twice as many for each column earlier, which takes the same time: early choices decide most.
unsigned widthOf(const BeamOptions& options, unsigned k) {
    return std::max(options.width, std::min(options.width << (kDigits - 1 - k), kMostWidth));
}

} // namespace

Columns bestSlot(const Bank& others, unsigned number, const BeamOptions& options,
                 std::mt19937& random) {
    std::vector<Order> orders;
    for (const Columns& columns : others) orders.push_back(orderOf(columns));
    const std::vector<Encounter> encounters = encountersWith(orders);
    const ColumnSearch search(encounters);
    std::vector<PartialSlot> beam{startOf(encounters)};
    for (unsigned k = 0; k < kDigits; ++k) {
        const OwnTransforms transforms = search.ownTransforms(k);
        std::vector<std::vector<float>> prices(beam.size());
        tbb::parallel_for(std::size_t{0}, beam.size(), [&](std::size_t i) {
            prices[i] = search.prices(beam[i], k, transforms);
        });
        std::vector<Candidate> candidates;
        for (std::size_t i = 0; i < beam.size(); ++i) {
            for (unsigned c = 0; c < prices[i].size(); ++c) {
                const auto column = static_cast<uint16_t>(1u << k | c);
                if (!hasFirstDigits(column, k, number)) continue;
                const double added = k + 1 < kFirstDigits ? 0 : double(prices[i][c]);
                const double total = beam[i].price + added;
                const float noise = options.disorder * uniform(random);
                candidates.push_back({total + added * double(noise), total, i, column});
            }
        }
        const std::size_t kept = std::min<std::size_t>(widthOf(options, k), candidates.size());
        std::partial_sort(candidates.begin(),
                          candidates.begin() + static_cast<std::ptrdiff_t>(kept), candidates.end());
        std::vector<PartialSlot> next(kept);
        tbb::parallel_for(std::size_t{0}, kept, [&](std::size_t i) {
            next[i] = search.extended(beam[candidates[i].parent], k, candidates[i].column);
            next[i].price = candidates[i].price;
        });
        beam = std::move(next);
    }
    return std::min_element(
               beam.begin(), beam.end(),
               [](const PartialSlot& a, const PartialSlot& b) { return a.price < b.price; })
        ->columns;
}

double slotPrice(const Bank& bank, std::size_t number) {
    std::vector<Order> others;
    for (std::size_t i = 0; i < bank.size(); ++i) {
        if (i != number) others.push_back(orderOf(bank[i]));
    }
    const std::vector<Encounter> encounters = encountersWith(others);
    const ColumnSearch search(encounters);
    PartialSlot slot = startOf(encounters);
    double total = 0;
    for (unsigned k = 0; k < kDigits; ++k) {
        slot = search.extended(slot, k, bank[number][k]);
        if (k + 1 < kFirstDigits) continue;
        for (std::size_t e = 0; e < encounters.size(); ++e) {
            const float variance =
                std::ldexp(slot.sums[e], -static_cast<int>(k) - 1) - encounters[e].squaredMean;
            total +=
                double(encounters[e].weight * price(variance / (*encounters[e].padded)[k + 1]));
        }
    }
    return total;
}

} // namespace wellstrat::bank
