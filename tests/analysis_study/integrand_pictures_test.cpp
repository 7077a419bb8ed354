// SPDX-License-Identifier: Apache-2.0
//
// The integrands of pictures: every integral against quadrature, that they vary slowly, and the
// names.

#include "wellstrat/analysis/integrand_pictures.h"

#include "quadrature.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace wellstrat {
namespace {

/// How finely each axis is cut, and how far the result may then be off, for 1 to 4 dimensions.
struct Accuracy {
    unsigned cells;
    double tolerance;
};
constexpr Accuracy kAccuracies[]{{0, 0}, {100, 1e-9}, {50, 3e-5}, {24, 1e-4}, {5, 1e-3}};

/// Guards against a wrong constant or sign in any of the closed forms.
TEST(IntegrandPictures, IntegralsAgreeWithQuadrature) {
    for (const IntegrandPictureKind& kind : integrandPictureKinds()) {
        const IntegrandPicture picture = makeIntegrandPicture(kind.name, 128);
        EXPECT_EQ(picture.name, kind.name);
        EXPECT_EQ(picture.domains, kind.domains);
        const auto [cells, tolerance] = kAccuracies[totalDims(kind.domains)];
        for (const auto& [x, y] : {std::pair{60u, 3u}, {0u, 0u}, {7u, 100u}, {127u, 127u}}) {
            const Integrand& integrand = picture.at(x, y);
            EXPECT_EQ(integrand.domains, kind.domains);
            std::vector<double> point(totalDims(kind.domains));
            EXPECT_NEAR(integrand.integral, integrate(integrand.value, cells, point), tolerance)
                << kind.name << " at " << x << ", " << y;
            if (point.size() == 4) break; // some seconds each
        }
    }
}

/// Neighbors differ by little, the sides of a window by much, and no integral is that of an empty
/// or full cube. The tolerance is 2 % of the range of a value for a pixel.
TEST(IntegrandPictures, IntegralsVarySlowly) {
    for (const IntegrandPictureKind& kind : integrandPictureKinds()) {
        const IntegrandPicture picture = makeIntegrandPicture(kind.name, 76);
        double low = picture.pixels[0].integral, high = low, largest = 0;
        for (unsigned y = 0; y < picture.size; ++y) {
            for (unsigned x = 0; x < picture.size; ++x) {
                const double here = picture.at(x, y).integral;
                low = std::min(low, here);
                high = std::max(high, here);
                if (x > 0) {
                    largest = std::max(largest, std::fabs(here - picture.at(x - 1, y).integral));
                }
            }
        }
        EXPECT_GT(low, 0.02) << kind.name;
        EXPECT_GT(high - low, 0.05) << kind.name;
        EXPECT_LT(largest, 0.05 * (high - low)) << kind.name;
    }
}

TEST(IntegrandPictures, PixelsDoNotDependOnTheSize) {
    const IntegrandPicture small = makeIntegrandPicture("exponential", 10);
    const IntegrandPicture large = makeIntegrandPicture("exponential", kMaxPictureSize);
    EXPECT_EQ(small.pixels.size(), 100u);
    EXPECT_EQ(small.at(9, 3).integral, large.at(9, 3).integral);
    EXPECT_NE(small.at(9, 3).integral, small.at(3, 9).integral);
}

TEST(IntegrandPictures, GroupsShareAllNames) {
    std::multiset<std::string> inGroups, names;
    for (const IntegrandGroup& group : integrandPictureGroups()) {
        inGroups.insert(group.members.begin(), group.members.end());
    }
    for (const IntegrandPictureKind& kind : integrandPictureKinds()) names.insert(kind.name);
    EXPECT_EQ(inGroups, names);
}

TEST(IntegrandPictures, OthersAreRejected) {
    for (const char* name : {"", "disk", "edge^3", "Edge", "2d"}) {
        EXPECT_THROW(makeIntegrandPicture(name, 8), std::invalid_argument) << name;
    }
    EXPECT_THROW(makeIntegrandPicture("edge", 0), std::invalid_argument);
    EXPECT_THROW(makeIntegrandPicture("edge", kMaxPictureSize + 1), std::invalid_argument);
}

} // namespace
} // namespace wellstrat
