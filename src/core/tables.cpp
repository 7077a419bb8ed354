// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/tables.h"

#include "wellstrat/owen.h"
#include "wellstrat/sobol.h"

#include <algorithm>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace wellstrat {
inline namespace stream1 {
namespace {

/// The stratum, of 4096, in which each Sobol' point lies before scrambling; points in the order in
/// which a table has them in memory.
struct SobolStrata {
    uint16_t x[kTableSize], y[kTableSize], z[kTableSize];

    SobolStrata() {
        fill(sobolMatrix(0), x);
        fill(sobolMatrix(1), y);
        fill(sobolMatrix(2), z);
    }

    static void fill(const SobolMatrix& matrix, uint16_t* strata) {
        uint16_t byIndex[kTableSize] = {0};
        for (unsigned digit = 0; digit < kTableSizeLog2; ++digit) {
            const unsigned count = 1u << digit;
            const unsigned column = matrix.column[digit] >> (32 - kTableSizeLog2);
            for (unsigned i = 0; i < count; ++i) {
                byIndex[count + i] = static_cast<uint16_t>(byIndex[i] ^ column);
            }
        }
        for (unsigned i = 0; i < kTableSize; ++i) {
            strata[i] = byIndex[(i & ~(kGroupSize - 1)) | reverseByte(i)];
        }
    }
};

/// Nested uniform scrambling of 12-digit numbers, the same as owenScramble. Whether a digit is
/// flipped depends on the digits before it, so a number and its neighbor, which differ in the last
/// digit, have the same flips.
class StratumScrambling {
public:
    explicit StratumScrambling(uint32_t seed) {
        // From the flips of d digits, for each start of d - 1 digits, to those of d + 1: one flip
        // more, that of the node at which two longer starts part. Downwards, so that no entry is
        // overwritten before it is used. First the nodes whose bits are all in word 0.
        const uint32_t root = owenNodeBits(seed, 0);
        flips_[0] = root >> 1 & 1u;
        for (unsigned count = 2; count < 32; count *= 2) {
            for (unsigned start = count; start-- > 0;) {
                flips_[start] = withFlip(flips_[start / 2], root >> (count + start) & 1u);
            }
        }
        for (unsigned count = 32; count < kTableSize; count *= 2) {
            for (unsigned start = count; start > 0;) {
                start -= 32;
                append(start, owenNodeBits(seed, (count + start) / 32));
            }
        }
    }

    uint32_t operator()(unsigned stratum) const { return stratum ^ flips_[stratum / 2]; }

private:
    static uint16_t withFlip(unsigned flips, unsigned bit) {
        return static_cast<uint16_t>(flips * 2 + bit);
    }

    /// The flips of 32 starts, by the bits of their nodes. In steps that compilers turn into vector
    /// code.
    void append(unsigned start, uint32_t bits) {
        uint16_t parents[16];
        std::copy_n(&flips_[start / 2], 16, parents);
        uint16_t* flips = &flips_[start];
        for (unsigned i = 0; i < 16; ++i) flips[2 * i] = flips[2 * i + 1] = parents[i];
        for (unsigned half = 0; half < 2; ++half) {
            const auto word = static_cast<uint16_t>(bits >> 16 * half);
            for (unsigned i = 0; i < 16; ++i) {
                uint16_t& entry = flips[16 * half + i];
                entry = withFlip(entry, (word & static_cast<uint16_t>(1u << i)) != 0);
            }
        }
    }

    uint16_t flips_[kTableSize / 2];
};

/// Chosen like the constant of tableSeed (docs/decisions/0009-table-seed.md).
constexpr uint32_t kDigitKey = 0xcae2957eu;

/// One of the words whose product with kPairMultiplier has these first 12 digits in its lower half
/// (x) and in its upper half (y), all equally likely, by random digits. The upper half is the word
/// less a 70,000th of it, so the word's own upper half decides y, but for a borrow: 17 such halves
/// may have this y. From a word to the next, x falls by kWordStep: of the words of one half, 17 in
/// a row have this x, if any.
uint32_t wordXY(uint32_t x, uint32_t y, uint32_t digits) {
    constexpr uint32_t kHalves = 17, kChoices = (1u << 20) / kWordStep;
    constexpr uint32_t kReach = (0x10000u - kChoices) * kWordStep;
    for (;; digits = mixBits(digits + detail::kGolden)) {
        const uint32_t half = (y << 4) + (((digits & 0xfffu) * kHalves) >> 12);
        const uint32_t first = half << 16;
        const uint32_t fall = 0u - first * kWordStep - (x << 20) - 0xfffffu; // to the first such x
        if (fall > kReach) continue;
        const uint32_t choice = ((digits >> 12) * kChoices) >> 20;
        const uint32_t word = first + (fall + kWordStep - 1) / kWordStep + choice;
        if (tableXY(word) >> 52 == y && (tableXY(word) >> 20 & 0xfffu) == x) return word;
    }
}

void fillTable(unsigned table, const SobolStrata& sobol, uint32_t* words) {
    const StratumScrambling scrambleX(tableSeed(table, Coordinate::x));
    const StratumScrambling scrambleY(tableSeed(table, Coordinate::y));
    const StratumScrambling scrambleZ(tableSeed(table, Coordinate::z));
    for (unsigned first = 0; first < kTableSize; first += kGroupSize) {
        const uint32_t offset = tableOffset(table, first);
        for (unsigned i = 0; i < kGroupSize; ++i) {
            const uint32_t x = scrambleX(sobol.x[first + i]), z = scrambleZ(sobol.z[first + i]);
            const uint32_t y = scrambleY(sobol.y[first + i]);
            const uint32_t digits = mixBits(mixBits(offset + i) ^ kDigitKey);
            words[offset + i] = wordXY(x, y, digits);
            words[kTablePoints + offset + i] = z << 20 | mixBits(~digits) >> 20 << 8;
        }
    }
}

/// Memory for the tables, if possible in pages of 2 MiB: samples are looked up all over them, and
/// six pages are in every processor's list of pages, 3072 are not.
uint32_t* allocateTables() {
    constexpr std::size_t kBytes = (2 * kTablePoints + 1) * sizeof(uint32_t);
#if defined(__linux__)
    constexpr std::align_val_t kLargePage{1u << 21};
    void* memory = ::operator new(kBytes, kLargePage);
    static_cast<void>(madvise(memory, kBytes, MADV_HUGEPAGE)); // without it, just slower
#else
    // Not aligned: the allocator of WebAssembly would take twice as much.
    void* memory = ::operator new (kBytes, std::align_val_t{alignof(uint64_t)});
#endif
    return static_cast<uint32_t*>(memory);
}

const uint32_t* makeTables() {
    uint32_t* const words = allocateTables();
    const SobolStrata sobol;
    for (unsigned table = 0; table < kTableCount; ++table) fillTable(table, sobol, words);
    return words;
}

} // namespace

namespace detail {
std::atomic<const uint32_t*> tableWords{nullptr};
const uint32_t* builtTables = nullptr;
} // namespace detail

const uint32_t* buildTables() {
    // Never freed: a thread may still draw while the program ends.
    static const uint32_t* const words = detail::builtTables = makeTables();
    detail::tableWords.store(words, std::memory_order_release);
    return words;
}

uint32_t tableValue(unsigned table, unsigned index, Coordinate coordinate) {
    constexpr uint32_t digits1To24 = 0xffffff00u;
    const uint32_t offset = tableOffset(table, index);
    const uint64_t point = tableXY(tables()[offset]);
    const auto lower = static_cast<uint32_t>(point), upper = static_cast<uint32_t>(point >> 32);
    switch (coordinate) {
    case Coordinate::x: return lower & digits1To24;
    case Coordinate::y: return upper & digits1To24;
    default: return tables()[kTablePoints + offset] & digits1To24;
    }
}

std::size_t tableBytes() { return std::size_t{2} * kTablePoints * sizeof(uint32_t); }

} // namespace stream1
} // namespace wellstrat
