// SPDX-License-Identifier: Apache-2.0
//
// The yardstick: two-dimensional samples as DESIGN describes them, but with the order of samples
// shuffled over all 12 levels of the index, each swap by its own fully hashed bit. An independent
// transcription; it shares no code with the library.

#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace statistical {

struct Point2 {
    float x, y;
};

/// The output function of SplitMix64 (Steele, Lea and Flood 2014, "Fast splittable pseudorandom
/// number generators"), whose constants are Stafford's variant 13.
inline uint64_t hash64(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// A nested random permutation of [0, 4096): Owen 1995, section 3, in base 2. Every node of the
/// binary tree over the numbers decides with its own bit whether its halves change places.
class NestedPermutation {
public:
    static constexpr unsigned kSize = 4096;

    /// Of the first `known` numbers, an even number, the image can be asked.
    explicit NestedPermutation(uint64_t seed, unsigned known = kSize) : image_(known) {
        for (unsigned count = 1; count < kSize; count *= 2) {
            for (unsigned i = std::min(count, known / 2); i-- > 0;) {
                const unsigned node = count + i;
                const uint64_t word = hash64(seed + 0x9e3779b97f4a7c15u * (node / 64 + 1));
                const unsigned bit = (word >> (node % 64)) & 1u;
                const unsigned image = image_[i];
                image_[2 * i] = static_cast<uint16_t>(2 * image + bit);
                image_[2 * i + 1] = static_cast<uint16_t>(2 * image + 1 - bit);
            }
        }
    }
    unsigned operator()(unsigned i) const { return image_[i]; }

private:
    std::vector<uint16_t> image_;
};

/// The first two Sobol' dimensions with nested uniform scrambling, 384 times.
class ExactTables {
public:
    static constexpr unsigned kCount = 384;

    ExactTables() {
        for (uint64_t table = 0; table < kCount; ++table) {
            const NestedPermutation scrambleX(hash64(2 * table + 1000)),
                scrambleY(hash64(2 * table + 1001));
            for (unsigned i = 0; i < NestedPermutation::kSize; ++i) {
                // Digits 13 to 24: no two points share 12 digits, so each has bits of its own.
                const uint64_t leaf = hash64((table << 12 | i) * 0x9e3779b97f4a7c15u);
                points_.push_back({scrambleX(vanDerCorput(i)) << 12 | (leaf & 0xfffu),
                                   scrambleY(pascal(i)) << 12 | (leaf >> 52)});
            }
        }
    }

    struct Bits2 {
        uint64_t x, y; ///< 24 binary digits
    };
    const Bits2& point(unsigned table, unsigned i) const {
        return points_[table * NestedPermutation::kSize + i];
    }

private:
    /// The binary digits of i in opposite order.
    static unsigned vanDerCorput(unsigned i) {
        unsigned reversed = 0;
        for (unsigned k = 0; k < 12; ++k) reversed |= ((i >> k) & 1u) << (11 - k);
        return reversed;
    }
    /// Digit r of the second dimension is the sum of the index bits c with odd binomial(c, r),
    /// which are those where r has no bit that c lacks (Lucas).
    static unsigned pascal(unsigned i) {
        unsigned value = 0;
        for (unsigned r = 0; r < 12; ++r) {
            for (unsigned c = r; c < 12; ++c) {
                if ((c & r) == r) value ^= ((i >> c) & 1u) << (11 - r);
            }
        }
        return value;
    }

    std::vector<Bits2> points_;
};

/// The first `samples` samples of one pattern: a table, an order and a digital shift.
class ExactPattern {
public:
    ExactPattern(const ExactTables& tables, uint64_t seed, unsigned samples)
        : tables_(tables), table_(static_cast<unsigned>(hash64(seed ^ 1) % ExactTables::kCount)),
          order_(hash64(seed ^ 2), samples), shiftX_(hash64(seed ^ 3) >> 40),
          shiftY_(hash64(seed ^ 4) >> 40) {}

    Point2 operator()(unsigned i) const {
        const ExactTables::Bits2& point = tables_.point(table_, order_(i));
        return {static_cast<float>(point.x ^ shiftX_) * 0x1p-24f,
                static_cast<float>(point.y ^ shiftY_) * 0x1p-24f};
    }

private:
    const ExactTables& tables_;
    unsigned table_;
    NestedPermutation order_;
    uint64_t shiftX_, shiftY_;
};

} // namespace statistical
