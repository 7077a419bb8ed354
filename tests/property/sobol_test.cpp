// SPDX-License-Identifier: Apache-2.0
//
// The Sobol' sequence against published numbers, and the quality that its theory states.

#include "wellstrat/bits.h"
#include "wellstrat/sobol.h"

#include "property/point_sets.h"

#include <gtest/gtest.h>

namespace wellstrat::test {
namespace {

// The odd integers m_k from which direction number k is m_k / 2^k; Joe and Kuo 2008, equation 2,
// with their coefficients. Integers of k bits, not the fractions that sobol.h works with.
std::vector<uint64_t> directionIntegers(unsigned degree, unsigned coefficients,
                                        std::vector<uint64_t> m) {
    for (std::size_t k = m.size(); k < 32; ++k) {
        uint64_t next = m[k - degree] ^ (m[k - degree] << degree);
        for (unsigned i = 1; i < degree; ++i) {
            if ((coefficients >> (degree - 1 - i)) & 1u) next ^= m[k - i] << i;
        }
        m.push_back(next);
    }
    return m;
}

void expectColumns(const SobolMatrix& matrix, const std::vector<uint64_t>& m) {
    for (unsigned k = 0; k < 32; ++k)
        EXPECT_EQ(matrix.column[k], m[k] << (31 - k)) << "column " << k;
}

// Guards against any flipped bit of a matrix.
TEST(Sobol, MatricesFollowJoeAndKuo) {
    expectColumns(sobolMatrix(0), std::vector<uint64_t>(32, 1));
    const std::vector<uint64_t> second = directionIntegers(1, 0, {1});
    const std::vector<uint64_t> third = directionIntegers(2, 1, {1, 3});
    expectColumns(sobolMatrix(1), second);
    expectColumns(sobolMatrix(2), third);
    // The first ones as literature prints them.
    EXPECT_EQ(std::vector<uint64_t>(second.begin(), second.begin() + 8),
              (std::vector<uint64_t>{1, 3, 5, 15, 17, 51, 85, 255}));
    EXPECT_EQ(std::vector<uint64_t>(third.begin(), third.begin() + 8),
              (std::vector<uint64_t>{1, 3, 3, 9, 29, 23, 71, 197}));
}

// The first eight points as common programs print them, which visit them in Gray code order
// (Antonov and Saleev 1979).
TEST(Sobol, FirstPointsAreThePublishedOnes) {
    constexpr double kExpected[8][3] = {
        {0, 0, 0},
        {0.5, 0.5, 0.5},
        {0.75, 0.25, 0.25},
        {0.25, 0.75, 0.75},
        {0.375, 0.375, 0.625},
        {0.875, 0.875, 0.125},
        {0.625, 0.125, 0.875},
        {0.125, 0.625, 0.375},
    };
    for (uint32_t i = 0; i < 8; ++i) {
        for (unsigned d = 0; d < 3; ++d) {
            EXPECT_EQ(sobolSample(sobolMatrix(d), i ^ (i >> 1)) * 0x1p-32, kExpected[i][d]);
        }
    }
}

TEST(Sobol, SampleIsLinearOverGF2AndTakesAllIndexBits) {
    for (unsigned d = 0; d < kSobolDimensions; ++d) {
        const SobolMatrix matrix = sobolMatrix(d);
        for (unsigned k = 0; k < 32; ++k) EXPECT_EQ(sobolSample(matrix, 1u << k), matrix.column[k]);
        for (uint32_t i = 0; i < 4096; ++i) {
            const uint32_t a = mixBits(i), b = mixBits(~i);
            ASSERT_EQ(sobolSample(matrix, a ^ b), sobolSample(matrix, a) ^ sobolSample(matrix, b));
        }
    }
}

// The two products without loops, whose digits stand in opposite order.
TEST(Sobol, ProductsAreTheMatrices) {
    const SobolMatrix second = sobolMatrix(1), third = sobolMatrix(2);
    for (uint32_t i = 0; i < 4096; ++i) {
        for (const uint32_t index : {i, 1u << i % 32, mixBits(i)}) {
            ASSERT_EQ(reverseBits(pascalTimes(index)), sobolSample(second, index)) << index;
            ASSERT_EQ(reverseBits(trinomialTimes(index)), sobolSample(third, index)) << index;
            ASSERT_EQ(pascalTimes(pascalTimes(index)), index);
        }
    }
}

// Joe and Kuo's property: every aligned block, of up to 2^14 points here, is a (1,m,3)-net, and a
// (0,m,2)-net in the first two dimensions.
TEST(Sobol, AlignedBlocksAreNets) {
    const PointSet points = sobolPoints(14).set();
    EXPECT_EQ(checkSequence(points.projection({0, 1}), 0).firstViolation, "");
    EXPECT_EQ(checkSequence(points, 1).firstViolation, "");
    EXPECT_EQ(checkSequence(points, 0, NetBase::four).firstViolation, "");
    EXPECT_FALSE(checkSequence(points, 0).holds());
}

} // namespace
} // namespace wellstrat::test
