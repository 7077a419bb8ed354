// SPDX-License-Identifier: Apache-2.0
//
// ZSobol: the theorem of its order, exactly.

#include "rivals/zsobol.h"

#include "wellstrat/analysis/nets.h"
#include "wellstrat/analysis/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace wellstrat::rivals {
namespace {

const PointSourcePtr kSource = zsobolSource();

/// The coordinates of domain `domain` of 2, of all `count` samples of the block of pixels.
std::vector<double> blockPoints(int left, int top, int width, int height, unsigned count,
                                unsigned domain, uint32_t seed) {
    std::vector<double> block, points(std::size_t{4} * count);
    for (int y = top; y < top + height; ++y) {
        for (int x = left; x < left + width; ++x) {
            kSource->draw(zsobolPattern(x, y, seed), {2, 2}, count, points.data());
            for (unsigned i = 0; i < count; ++i) {
                block.push_back(points[4 * i + 2 * domain]);
                block.push_back(points[4 * i + 2 * domain + 1]);
            }
        }
    }
    return block;
}

unsigned tOf(const std::vector<double>& points) {
    return tValue(PointSet::fromFloats(points.data(), points.size() / 2, 2));
}

/// Every aligned block with all samples is a (0,m,2)-net, also of an odd power of two; 2:1 blocks
/// of the quadtree are no runs of it.
TEST(ZSobol, AlignedBlocksAreNets) {
    for (const unsigned count : {1u, 2u, 4u, 8u, 32u}) {
        for (int side = 1; side <= 8; side *= 2) {
            for (const int block : {0, 1, 5}) {
                for (unsigned domain = 0; domain < 2; ++domain) {
                    EXPECT_EQ(tOf(blockPoints(block * side, 2 * side, side, side, count, domain,
                                              static_cast<uint32_t>(block))),
                              0u)
                        << count << " samples, side " << side << ", block " << block;
                }
            }
        }
    }
}

/// Guards against a test that would accept any points.
TEST(ZSobol, OtherBlocksAreNone) {
    EXPECT_GT(tOf(blockPoints(1, 0, 4, 4, 4, 0, 0)), 0u);
    EXPECT_GT(tOf(blockPoints(0, 2, 4, 4, 4, 0, 0)), 0u);
}

/// Pixels, domains, pictures and numbers of samples have their own points, which are the same each
/// time.
TEST(ZSobol, PointsAreAPureFunction) {
    std::set<std::vector<double>> all;
    for (const int x : {0, 1, 255}) {
        for (const int y : {0, 1, 255}) {
            for (const uint32_t seed : {0u, 1u, 65535u}) {
                for (const unsigned domain : {0u, 1u}) {
                    const auto points = blockPoints(x, y, 1, 1, 4, domain, seed);
                    EXPECT_EQ(points, blockPoints(x, y, 1, 1, 4, domain, seed));
                    all.insert(points);
                }
            }
        }
    }
    EXPECT_EQ(all.size(), 3u * 3 * 3 * 2);
    EXPECT_FALSE(kSource->isProgressive());
}

TEST(ZSobol, OtherNumbersOfSamplesAreRoundedUp) {
    std::vector<double> three = blockPoints(4, 5, 1, 1, 3, 0, 0);
    std::vector<double> four = blockPoints(4, 5, 1, 1, 4, 0, 0);
    four.resize(three.size());
    EXPECT_EQ(three, four);
    EXPECT_NO_THROW(kSource->check({2}, 65536, 1));
    EXPECT_THROW(kSource->check({2}, 65537, 1), std::invalid_argument);
}

/// What it is known for: after a Gaussian of 2 pixels about 0.4 of the error of white noise in 2D.
/// 8 pictures tell it to 3 %.
TEST(ZSobol, ErrorsOfNeighborsCancel) {
    const PointSourcePtr white = generatorSource(nullptr);
    const IntegrandPicture picture = makeIntegrandPicture("gaussian", 44);
    const auto rmse = [&](const PixelSource& source) {
        std::vector<ErrorSums> sums(1);
        addPictureErrors(source, {&picture}, {4}, GaussianFilter(2), {0, 8}, sums.data());
        return estimateError(sums[0], 8).rmse;
    };
    const double ratio = rmse({*kSource, zsobolPattern}) / rmse({*white, cameraPattern});
    EXPECT_GT(ratio, 0.28);
    EXPECT_LT(ratio, 0.45);
}

} // namespace
} // namespace wellstrat::rivals
