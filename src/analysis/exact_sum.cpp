// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/exact_sum.h"

#include <cmath>
#include <stdexcept>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr int kFractionBits = 192;
constexpr int kMantissaBits = 53;

} // namespace

ExactSum& ExactSum::operator+=(double term) {
    if (!(std::fabs(term) < 0x1p31)) {
        throw std::range_error("a term of an exact sum is NaN or not below 2^31");
    }
    int exponent = 0;
    const double fraction = std::frexp(std::fabs(term), &exponent);
    auto mantissa = static_cast<uint64_t>(std::ldexp(fraction, kMantissaBits));
    int shift = exponent - kMantissaBits + kFractionBits;
    if (shift < 0) {
        mantissa = shift > -kMantissaBits ? mantissa >> -shift : 0;
        shift = 0;
    }
    ExactSum wide;
    const auto word = static_cast<unsigned>(shift) / 64, bit = static_cast<unsigned>(shift) % 64;
    wide.words_[word] = mantissa << bit;
    if (bit != 0) wide.words_[word + 1] = mantissa >> (64 - bit);
    if (term < 0) wide.negate();
    return *this += wide;
}

ExactSum& ExactSum::operator+=(const ExactSum& other) {
    uint64_t carry = 0;
    for (unsigned i = 0; i < words_.size(); ++i) {
        const uint64_t withCarry = words_[i] + carry;
        carry = withCarry < carry ? 1 : 0;
        words_[i] = withCarry + other.words_[i];
        carry += words_[i] < withCarry ? 1 : 0;
    }
    return *this;
}

void ExactSum::negate() {
    for (uint64_t& word : words_) word = ~word;
    *this += ExactSum({1, 0, 0, 0});
}

double ExactSum::value() const {
    const bool negative = words_[3] >> 63 != 0;
    ExactSum magnitude = *this;
    if (negative) magnitude.negate();
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        sum += std::ldexp(static_cast<double>(magnitude.words_[static_cast<unsigned>(i)]),
                          64 * i - kFractionBits);
    }
    return negative ? -sum : sum;
}

} // namespace stream1
} // namespace wellstrat
