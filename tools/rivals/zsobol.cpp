// SPDX-License-Identifier: Apache-2.0

#include "zsobol.h"

#include "wellstrat/hash.h"
#include "wellstrat/owen.h"
#include "wellstrat/sobol.h"

#include <array>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace wellstrat::rivals {
namespace {

constexpr unsigned kPlaceBits = 16; ///< of a pixel in a picture of 256 x 256
constexpr std::size_t kMaxCount = std::size_t{1} << (32 - kPlaceBits);

/// Bit b of `value` at 2 b.
uint32_t spread(uint32_t value) {
    uint32_t result = 0;
    for (unsigned b = 0; b < kPlaceBits / 2; ++b) result |= (value >> b & 1u) << (2 * b);
    return result;
}

/// The base-4 `digit` under the permutation that the word `random` picks: Fisher and Yates.
uint32_t permuteDigit(uint32_t digit, uint32_t random) {
    std::array<uint32_t, 4> images{0, 1, 2, 3};
    for (uint32_t n = 4; n > 1; random /= n--) std::swap(images[n - 1], images[random % n]);
    return images[digit];
}

/// The place in the sequence of `index`, whose last digit has base 2 if the number of digits is
/// odd.
uint32_t placeOf(uint32_t index, unsigned binaryDigits, uint32_t seed) {
    uint32_t place = 0;
    unsigned below = binaryDigits;
    while (below >= 2) {
        below -= 2;
        const uint64_t above = uint64_t{index} >> (below + 2);
        const uint32_t random = hashPair(hashPair(seed, below), static_cast<uint32_t>(above));
        place |= permuteDigit(index >> below & 3u, random) << below;
    }
    if (below == 1) place |= (index ^ hashPair(hashPair(seed, 0), index >> 1)) & 1u;
    return place;
}

class ZSobolSource final : public PointSource {
public:
    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        unsigned log2 = 0;
        while (std::size_t{1} << log2 < count) ++log2;
        const uint32_t pixel = (pattern & ((1u << kPlaceBits) - 1)) << log2;
        const uint32_t picture = hashPair(0x7a736f62u, pattern >> kPlaceBits); // "zsob"
        const unsigned stride = totalDims(domains);
        for (std::size_t d = 0; d < domains.size(); points += domains[d++]) {
            for (unsigned c = 0; c < domains[d]; ++c) {
                const auto pair = static_cast<uint32_t>(2 * d + c / 2);
                const uint32_t seed = hashPair(picture, pair);
                for (std::size_t i = 0; i < count; ++i) {
                    const uint32_t place =
                        placeOf(pixel + static_cast<uint32_t>(i), kPlaceBits + log2, seed);
                    const uint32_t word =
                        owenScramble(sobolSample(matrices_[c % 2], place), hashPair(~seed, c % 2));
                    points[i * stride + c] = word * 0x1p-32;
                }
            }
        }
    }

    bool isProgressive() const override { return false; }

    void check(const DomainDims& /*domains*/, std::size_t count,
               uint64_t /*patterns*/) const override {
        if (count <= kMaxCount) return;
        throw std::invalid_argument("it has at most " + std::to_string(kMaxCount) +
                                    " samples in a pixel, not " + std::to_string(count));
    }

private:
    std::array<SobolMatrix, 2> matrices_{sobolMatrix(0), sobolMatrix(1)};
};

} // namespace

PointSourcePtr zsobolSource() { return std::make_unique<ZSobolSource>(); }

uint32_t zsobolPattern(int x, int y, uint32_t seed) {
    const auto place = spread(static_cast<uint32_t>(x)) | spread(static_cast<uint32_t>(y)) << 1;
    return seed << kPlaceBits | place;
}

} // namespace wellstrat::rivals
