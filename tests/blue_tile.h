// SPDX-License-Identifier: Apache-2.0
//
// All pixels of a tile of BlueProgressive, as an integrator has them.

#pragma once

#include "RixRNG.h"
#include "wellstrat/blue.h"
#include "wellstrat/blue_lookup.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace wellstrat::test {

/// The derivation of a domain: scrambles, each with its split as in Generator::ChildOrder.
using Steps = std::vector<std::pair<Scramble, unsigned>>;

/// A domain of the 64 x 64 pixels from (64 column, 64 row) on, for sample 0 of each pixel.
class BlueTile {
public:
    BlueTile(int column, int row, unsigned seed, const Steps& steps) : contexts_(kRanks) {
        for (unsigned p = 0; p < kRanks; ++p) {
            contexts_[p] = blueContext(64 * column + static_cast<int>(p % 64),
                                       64 * row + static_cast<int>(p / 64), seed, 0);
        }
        RixRNG rng(contexts_, kRanks, &blue_);
        for (const auto& [scramble, split] : steps) {
            if (split == 0) {
                rng.NewDomainsDistrib(scramble, 0, contexts_);
            } else {
                rng.NewDomainsSplit(scramble, split, contexts_);
            }
        }
        order_ = rng.order;
        for (unsigned p = 0; p < kRanks; ++p) pixelAt_[ownPlace(p)] = p;
    }

    bool isPadded() const { return order_.slot == kJointSlots; }
    uint32_t state() const { return contexts_[0].patternid >> 12; }

    /// By scalar draws, samples first to first + count - 1 of all pixels of the block of 2^a x 2^a
    /// pixels from (x 2^a, y 2^a) of the tile's own coordinates on, sample by sample.
    std::vector<Float3> draw(unsigned a, unsigned x, unsigned y, uint32_t first,
                             uint32_t count) const {
        std::vector<Float3> xis;
        for (uint32_t s = first; s != first + count; ++s) {
            for (unsigned row = y << a; row < (y + 1) << a; ++row) {
                for (unsigned column = x << a; column < (x + 1) << a; ++column) {
                    const unsigned pattern = contexts_[pixelAt_[row << 6 | column]].patternid;
                    xis.push_back(blue_.OrderedSample3D({pattern, s}, 0, order_));
                }
            }
        }
        return xis;
    }

private:
    /// The place of pixel p in the tile as its domain has it.
    unsigned ownPlace(unsigned p) const {
        const uint32_t place = contexts_[p].patternid & detail::kPlaceBits;
        if (!isPadded()) return place;
        const uint32_t seed = detail::stateSeed(contexts_[p].patternid);
        return detail::movedPlace(place, detail::placeKey(seed));
    }

    const BlueProgressive blue_;
    std::vector<SampleCtx> contexts_;
    Order order_;
    unsigned pixelAt_[kRanks];
};

} // namespace wellstrat::test
