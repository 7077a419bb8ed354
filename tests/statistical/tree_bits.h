// SPDX-License-Identifier: Apache-2.0
//
// Whether the random decisions of a hash are fair and independent: each decision is a column of
// bits, one bit for each of many seeds, and any set of columns must have an exclusive-or that is
// one for half of the seeds.

#pragma once

#include "statistical/statistics.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace statistical {

/// The number of ones of word(0) to word(n - 1), counted in bytes first so that compilers vectorize
/// the loop (Warren 2013, Hacker's Delight, section 5-1).
template <typename Word>
uint64_t countOnes(std::size_t n, Word word) {
    constexpr std::size_t kWordsPerByteCount = 31; // 31 * 8 fits into a byte
    uint64_t ones = 0;
    for (std::size_t i = 0; i < n; i += kWordsPerByteCount) {
        const std::size_t end = i + kWordsPerByteCount < n ? i + kWordsPerByteCount : n;
        uint64_t bytes = 0;
        for (std::size_t k = i; k < end; ++k) {
            uint64_t w = word(k);
            w -= (w >> 1) & 0x5555555555555555u;
            w = (w & 0x3333333333333333u) + ((w >> 2) & 0x3333333333333333u);
            bytes += (w + (w >> 4)) & 0x0f0f0f0f0f0f0f0fu;
        }
        for (; bytes != 0; bytes >>= 8) ones += bytes & 0xffu;
    }
    return ones;
}

/// Columns of `seeds` bits, a multiple of 64.
class BitColumns {
public:
    explicit BitColumns(std::size_t seeds) : words_(seeds / 64) {}

    std::size_t seeds() const { return words_ * 64; }
    std::size_t size() const { return bits_.size() / words_; }

    /// Adds `count` columns: bit k of decide(s) goes to the k-th of them as the bit of seed s.
    template <typename Decide>
    void add(unsigned count, Decide decide) {
        const std::size_t first = bits_.size();
        bits_.resize(first + count * words_);
        for (std::size_t word = 0; word < words_; ++word) {
            uint64_t columns[32] = {};
            for (unsigned s = 0; s < 64; ++s) {
                const uint32_t decisions = decide(word * 64 + s);
                for (unsigned k = 0; k < count; ++k) {
                    columns[k] |= static_cast<uint64_t>((decisions >> k) & 1u) << s;
                }
            }
            for (unsigned k = 0; k < count; ++k) bits_[first + k * words_ + word] = columns[k];
        }
    }

    /// By how many standard deviations the exclusive-or of these columns is off from fair.
    template <typename... Columns>
    double score(Columns... columns) const {
        const uint64_t ones =
            countOnes(words_, [&](std::size_t w) { return (bits_[columns * words_ + w] ^ ...); });
        const auto n = static_cast<double>(seeds());
        return (2 * static_cast<double>(ones) - n) / std::sqrt(n);
    }

private:
    std::size_t words_;
    std::vector<uint64_t> bits_;
};

} // namespace statistical
