// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/tables.h"

#include "wellstrat/owen.h"
#include "wellstrat/sobol.h"

#include <memory>
#include <mutex>

namespace wellstrat {
namespace {

constexpr unsigned kCoordinates = 3;

/// The first 12 digits of the Sobol' points, one array a coordinate.
struct SobolStrata {
    uint16_t stratum[kCoordinates][kTableSize];

    SobolStrata() {
        for (unsigned c = 0; c < kCoordinates; ++c) {
            const SobolMatrix matrix = sobolMatrix(c);
            for (unsigned i = 0; i < kTableSize; ++i) {
                stratum[c][i] =
                    static_cast<uint16_t>(sobolSample(matrix, i) >> (32 - kTableSizeLog2));
            }
        }
    }
};

/// Where nested uniform scrambling takes each of the 4096 strata: owenScramble of all values with
/// 12 digits at once, grown from the root of the tree. The permutation of 2^d strata gives that of
/// 2^(d+1): the two halves of a stratum follow it, in the order that its node's bit says.
void owenPermutation(uint32_t seed, uint16_t* permuted) {
    uint32_t bits[kTableSize / 32];
    for (unsigned word = 0; word < kTableSize / 32; ++word) bits[word] = owenNodeBits(seed, word);
    permuted[0] = 0;
    for (unsigned count = 1; count < kTableSize; count *= 2) {
        for (unsigned i = count; i-- > 0;) {
            const unsigned node = count + i;
            const unsigned bit = (bits[node / 32] >> (node % 32)) & 1u;
            const unsigned parent = permuted[i] * 2u;
            permuted[2 * i] = static_cast<uint16_t>(parent + bit);
            permuted[2 * i + 1] = static_cast<uint16_t>(parent + (bit ^ 1u));
        }
    }
}

struct Storage {
    std::unique_ptr<uint32_t[]> xy{new uint32_t[kTableCount * kTableSize]};
    std::unique_ptr<uint32_t[]> z{new uint32_t[kTableCount * kTableSize]};
    TableData data{xy.get(), z.get()};

    Storage() {
        const SobolStrata sobol;
        uint16_t permuted[kCoordinates][kTableSize];
        for (unsigned table = 0; table < kTableCount; ++table) {
            for (unsigned c = 0; c < kCoordinates; ++c) {
                owenPermutation(tableSeed(table, static_cast<Coordinate>(c)), permuted[c]);
            }
            for (unsigned i = 0; i < kTableSize; ++i) {
                const uint32_t offset = tableOffset(table, i);
                const uint32_t x = permuted[0][sobol.stratum[0][i]];
                const uint32_t y = permuted[1][sobol.stratum[1][i]];
                xy[offset] = (x << 20) | (y << 8);
                const uint32_t stratum = permuted[2][sobol.stratum[2][i]];
                z[offset] = (stratum << 20) | ((mixBits(offset) >> 12) & 0x000fff00u);
            }
        }
    }
};

} // namespace

namespace detail {
std::atomic<const TableData*> tableData{nullptr};
} // namespace detail

const TableData& buildTables() {
    // Never destroyed: a thread may still draw while the program ends.
    static const Storage* const storage = new Storage;
    detail::tableData.store(&storage->data, std::memory_order_release);
    return storage->data;
}

uint32_t tableValue(unsigned table, unsigned index, Coordinate coordinate) {
    const TableData& data = tables();
    const uint32_t offset = tableOffset(table, index);
    switch (coordinate) {
    case Coordinate::x: return tableX(data.xy[offset], leafBits(offset));
    case Coordinate::y: return tableY(data.xy[offset], leafBits(offset));
    default: return data.z[offset];
    }
}

std::size_t tableBytes() { return std::size_t{kTableCount} * kTableSize * 2 * sizeof(uint32_t); }

} // namespace wellstrat
