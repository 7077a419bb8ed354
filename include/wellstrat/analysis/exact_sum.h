// SPDX-License-Identifier: Apache-2.0
//
// A sum of doubles that does not depend on the order of its terms, so that work may be split over
// threads and machines in any way and still give the same bits.
//
// It is a fixed-point number wide enough that no addition rounds: the idea of Kulisch's long
// accumulator (Kulisch 2013, "Computer Arithmetic and Validity", chapter 8), cut down to the range
// that errors of integrals need.

#pragma once

#include "wellstrat/platform.h"

#include <array>
#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

/// A number of 256 bits in two's complement, in units of 2^-192. 32 bytes, trivially copyable.
class WELLSTRAT_API ExactSum {
public:
    /// Starts at 0.
    ExactSum() = default;
    /// The sum with these words, as `words` gives them.
    explicit ExactSum(const std::array<uint64_t, 4>& words) : words_(words) {}

    /// Adds a term. What it has below 2^-192 is dropped, from each term by itself, so the sum still
    /// does not depend on their order. Throws std::range_error unless |term| < 2^31. At most 2^32
    /// terms.
    ExactSum& operator+=(double term);
    ExactSum& operator+=(const ExactSum& other);

    /// The sum as a double, within two units in its last place.
    double value() const;
    /// The bits, the lowest word first: to store a sum, to send it, and to compare two.
    const std::array<uint64_t, 4>& words() const { return words_; }

private:
    void negate();

    std::array<uint64_t, 4> words_{};
};

} // namespace stream1
} // namespace wellstrat
