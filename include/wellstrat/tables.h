// SPDX-License-Identifier: Apache-2.0
//
// The tables: 384 sequences of 4096 three-dimensional points each, the first three Sobol'
// dimensions, each with its own nested uniform scrambling (owen.h).
//
// x and y of a point are one word of 32 bits, so that one load gives a 2D point and few lines of
// the cache are needed; z is another. The first 12 binary digits of a coordinate decide everything
// about the stratification of 4096 points. The scrambling of the digits after them is one
// independent random bit for each point, since no two points share 12 digits of a coordinate; 8 of
// 24 such bits of x and y have room in the word. They are not cut out of it: the word is one of
// those, some 256, whose product with a constant has the 12 digits of x on top of its lower half
// and those of y on top of its upper half, and one multiplication gives 24 digits and more of each.
//
//     bit               63 .......... 52 51 ... 32 31 .......... 20 19 .... 0
//     word * constant   y, 12 digits     more      x, 12 digits     more
//     z word                                       z, 12 digits     hash
//
// Order in memory: the same 256 samples of all tables lie side by side, since a renderer draws
// about the same sampleid from all tables at a time; within such a group the sample with the
// index i stands at the place with the bits of i in opposite order, which is the order that the
// shuffle in lookup.h produces. Figures for this layout and others are in
// docs/decisions/0002-table-layout.md.

#pragma once

#include "wellstrat/bits.h"
#include "wellstrat/coordinate.h"
#include "wellstrat/hash.h"

#include <atomic>
#include <cstddef>
#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

constexpr unsigned kTableCount = 384;
constexpr unsigned kTableSizeLog2 = 12;
constexpr unsigned kTableSize = 1u << kTableSizeLog2;
/// The order of samples is shuffled within aligned groups of this many.
constexpr unsigned kGroupSize = 256;
/// Of this many samples in a row each pattern takes from tables, every block of 4096 from another
/// one; samples beyond are unstratified.
constexpr unsigned kStratifiedSamples = 48 * kTableSize;

/// The points of all tables. In memory: their xy words, then their z words.
constexpr uint32_t kTablePoints = kTableCount * kTableSize;

/// Where the xy word of sample `index` in [0, kTableSize) of `table` in [0, kTableCount) lies; the
/// z word lies kTablePoints further on.
WELLSTRAT_HOST_DEVICE constexpr uint32_t tableOffset(uint32_t table, uint32_t index) {
    return ((index / kGroupSize) * kTableCount + table) * kGroupSize + reverseByte(index);
}

/// By how much x falls from one xy word to the next. 17.0005 of these steps are a stratum of x, so
/// 17 words in a row have its 12 digits (docs/decisions/0013-cheaper-draws.md).
constexpr uint32_t kWordStep = 61679;

/// What an xy word is multiplied with.
constexpr uint32_t kPairMultiplier = 0u - kWordStep;

/// x (lower half) and y of a point as fractions of 2^32, from its xy word.
WELLSTRAT_HOST_DEVICE constexpr uint64_t tableXY(uint32_t word) {
    return uint64_t{word} * kPairMultiplier;
}

namespace detail {

/// Null until the tables are built. `tables()` is how to read it.
extern WELLSTRAT_API std::atomic<const uint32_t*> tableWords;

/// The same, to be read by threads that have seen the tables built.
extern WELLSTRAT_API const uint32_t* builtTables;

} // namespace detail

/// Builds the tables if that has not been done, which takes some milliseconds, and returns them.
/// Call it at start-up to keep that time out of the first use. Any number of threads may call at
/// once; all return when the tables are ready. Throws std::bad_alloc without memory (12 MiB).
WELLSTRAT_API const uint32_t* buildTables();

/// The 2 * kTablePoints words of the tables, which the first call builds. Read-only, and valid
/// until the program ends. Safe in any thread.
inline const uint32_t* tables() {
    const uint32_t* words = detail::tableWords.load(std::memory_order_acquire);
    return words != nullptr ? words : buildTables();
}

/// The same for threads that have called it or `buildTables()` before: without a check, and so that
/// compilers may keep it in a register over a loop of draws.
inline const uint32_t* builtTables() { return detail::builtTables; }

/// One coordinate of sample `index` in [0, kTableSize) of `table` in [0, kTableCount), as a
/// fraction of 2^32 and a multiple of 2^-24. Out of range is undefined.
WELLSTRAT_API uint32_t tableValue(unsigned table, unsigned index, Coordinate coordinate);

/// The memory that the tables take once they are built, in bytes.
WELLSTRAT_API std::size_t tableBytes();

/// The seed of the nested uniform scrambling of one coordinate of a table. The constant makes the
/// 384 tables together as good as infinitely many (docs/decisions/0009-table-seed.md).
WELLSTRAT_HOST_DEVICE constexpr uint32_t tableSeed(unsigned table, Coordinate coordinate) {
    return hashPair(0xbaa6bad2u, table * 4 + static_cast<unsigned>(coordinate));
}

} // namespace stream1
} // namespace wellstrat
