// SPDX-License-Identifier: Apache-2.0
//
// The optimized tile: its energy, the points of pixels, and what is left of errors after a filter.

#include "rivals/tile.h"

#include "rivals/tile_search.h"

#include "wellstrat/analysis/nets.h"
#include "wellstrat/analysis/picture_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace wellstrat::rivals {
namespace {

const PointSourcePtr kSource = tileSource();

std::vector<double> pointsOf(int x, int y, uint32_t seed, const DomainDims& domains,
                             unsigned count) {
    std::vector<double> points(std::size_t{totalDims(domains)} * count);
    kSource->draw(tilePattern(x, y, seed), domains, count, points.data());
    return points;
}

/// Errors that are made up: hashed, different in each component.
std::vector<TileErrors> someErrors() {
    std::vector<TileErrors> errors(kTilePixels);
    for (unsigned p = 0; p < kTilePixels; ++p) {
        for (unsigned e = 0; e < kTileErrors; ++e) {
            errors[p][e] = static_cast<float>(p * 31 % 17) - static_cast<float>((p + e) % 5);
        }
    }
    return errors;
}

/// The energy of error_field.h, as its comment has it.
double energyOf(const ErrorField& field) {
    double energy = 0;
    for (unsigned p = 0; p < kTilePixels; ++p) {
        for (int dy = -7; dy <= 7; ++dy) {
            for (int dx = -7; dx <= 7; ++dx) {
                if (dx == 0 && dy == 0) continue;
                const unsigned x = (p % kTileSize + static_cast<unsigned>(dx)) % kTileSize;
                const unsigned y = (p / kTileSize + static_cast<unsigned>(dy)) % kTileSize;
                double product = 0;
                for (unsigned e = 0; e < kTileErrors; ++e) {
                    product += double(field[p][e]) * double(field[y * kTileSize + x][e]);
                }
                energy += std::exp(-(dx * dx + dy * dy) / (3.5 * 3.5)) * product / 2;
            }
        }
    }
    return energy;
}

/// Guards against a search that minimizes something else. The pixels are neighbors, neighbors over
/// a side of the tile, and far apart.
TEST(Tile, RisesAreThoseOfTheEnergy) {
    for (const auto& [p, q] :
         {std::pair{100u, 102u}, {0u, kTilePixels - 1}, {63u, 64u}, {5u, 2000u}}) {
        ErrorField field(someErrors());
        const double before = energyOf(field), rise = field.riseOfSwap(p, q);
        const TileErrors atP = field[p];
        field.swap(p, q);
        EXPECT_EQ(field[q], atP);
        const double after = energyOf(field);
        EXPECT_NEAR(after - before, rise, 1e-4 * std::fabs(rise) + 1) << p << ", " << q;
        TileErrors change{};
        change[3] = 2;
        const double riseOfChange = field.rise(p, change);
        field.add(p, change);
        EXPECT_NEAR(energyOf(field) - after, riseOfChange, 1e-4 * std::fabs(riseOfChange) + 1);
    }
}

/// Each pixel has a whole net of each power of two, within and beyond what is optimized.
TEST(Tile, PixelsAreNets) {
    for (const int place : {0, 17, 63}) {
        for (const unsigned count : {4u, 64u, 256u}) {
            const std::vector<double> points = pointsOf(place, 2 * place + 1, 3, {2}, count);
            EXPECT_EQ(tValue(PointSet::fromFloats(points.data(), count, 2)), 0u);
        }
    }
}

TEST(Tile, PointsAreAPureFunctionOfAToroidalPlace) {
    const DomainDims domains{2, 3, 1};
    const std::vector<double> points = pointsOf(3, 4, 5, domains, 100);
    EXPECT_EQ(points, pointsOf(3, 4, 5, domains, 100));
    EXPECT_EQ(points, pointsOf(3 + 64, 4 - 64, 5, domains, 100));
    EXPECT_NE(points, pointsOf(4, 4, 5, domains, 100));
    EXPECT_NE(points, pointsOf(3, 5, 5, domains, 100));
    EXPECT_NE(points, pointsOf(3, 4, 6, domains, 100));
    EXPECT_THROW(kSource->check({1, 1, 1, 1, 1, 1}, 1, 1), std::invalid_argument);
}

/// After a Gaussian of 2 pixels 0.4 to 0.5 of the error of white noise, and at 3 samples less gain.
/// 8 pictures tell it to 3 %.
TEST(Tile, ErrorsOfNeighborsCancel) {
    const PointSourcePtr white = generatorSource(nullptr);
    const IntegrandPicture picture = makeIntegrandPicture("edge", 44);
    const auto rmse = [&](const PixelSource& source, std::size_t c) {
        std::vector<ErrorSums> sums(3);
        addPictureErrors(source, {&picture}, {1, 3, 4}, GaussianFilter(2), {0, 8}, sums.data());
        return estimateError(sums[c], 8).rmse;
    };
    const auto ratio = [&](std::size_t c) {
        return rmse({*kSource, tilePattern}, c) / rmse({*white, cameraPattern}, c);
    };
    EXPECT_LT(ratio(0), 0.6);
    EXPECT_GT(ratio(0), 0.35);
    EXPECT_LT(ratio(2), 0.85);
    EXPECT_GT(ratio(1), ratio(0));
}

} // namespace
} // namespace wellstrat::rivals
