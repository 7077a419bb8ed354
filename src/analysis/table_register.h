// SPDX-License-Identifier: Apache-2.0
//
// Which table do these points come from? Answered from the points alone.

#pragma once

#include "wellstrat/hash.h"
#include "wellstrat/tables.h"

#include <array>
#include <cstdint>
#include <unordered_map>

namespace wellstrat {
inline namespace stream1 {

/// x, y and z as fractions of 2^32.
using PointBits = std::array<uint32_t, 3>;

inline PointBits tablePoint(unsigned table, unsigned index) {
    return {tableValue(table, index, Coordinate::x), tableValue(table, index, Coordinate::y),
            tableValue(table, index, Coordinate::z)};
}

/// Tells tables apart by the first 256 points, given in any nested order and under any digital
/// shift: the points 2k and 2k + 1 of the sequence stay neighbours in every nested order, and a
/// shift leaves the XOR of two points as it is. `point(i)` gives the bits of point i.
template <class Point>
uint64_t fingerprint(const Point& point) {
    uint64_t sum = 0;
    for (unsigned i = 0; i < kGroupSize; i += 2) {
        const PointBits a = point(i);
        const PointBits b = point(i + 1);
        const uint32_t xy = hashPair(a[0] ^ b[0], a[1] ^ b[1]);
        sum += uint64_t{xy} * hashPair(xy, a[2] ^ b[2]);
    }
    return sum;
}

/// The tables by fingerprint. Tables that are the same share an entry: that of the first.
class TableRegister {
public:
    TableRegister(unsigned first, unsigned last) {
        for (unsigned table = first; table <= last; ++table) {
            const uint64_t print = fingerprint([&](unsigned i) { return tablePoint(table, i); });
            tables_.emplace(print, table);
        }
    }

    /// The number of the table with this fingerprint, or kTableCount.
    unsigned find(uint64_t print) const {
        const auto entry = tables_.find(print);
        return entry == tables_.end() ? kTableCount : entry->second;
    }

private:
    std::unordered_map<uint64_t, unsigned> tables_;
};

} // namespace stream1
} // namespace wellstrat
