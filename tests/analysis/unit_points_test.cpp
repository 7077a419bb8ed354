// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/unit_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace wellstrat {
namespace {

/// What making the points throws, or nothing.
std::string complaint(const std::vector<double>& values, std::size_t count, unsigned dims) {
    try {
        const UnitPoints points(values.data(), count, dims);
    } catch (const PointError& error) {
        return error.what();
    }
    return "";
}

TEST(UnitPoints, KeepsPointsByCoordinate) {
    const std::vector<double> values{0.0, 0.1, 0.2, 0.3, 0.4, std::nextafter(1.0, 0.0)};
    const UnitPoints points(values.data(), 3, 2);
    ASSERT_EQ(points.count(), 3u);
    ASSERT_EQ(points.dims(), 2u);
    for (std::size_t i = 0; i < 3; ++i) {
        for (unsigned d = 0; d < 2; ++d) EXPECT_EQ(points.coordinate(d)[i], values[i * 2 + d]);
    }
    const UnitPoints swapped = points.projection({1, 0, 1});
    ASSERT_EQ(swapped.dims(), 3u);
    EXPECT_EQ(swapped.coordinate(0)[1], 0.3);
    EXPECT_EQ(swapped.coordinate(1)[1], 0.2);
    EXPECT_EQ(swapped.coordinate(2)[1], 0.3);
}

TEST(UnitPoints, NamesTheBadValue) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {1.0, -1e-300, 2.0, std::nan(""), infinity, -infinity}) {
        const std::string text = complaint({0.5, 0.5, 0.5, bad}, 2, 2);
        EXPECT_NE(text.find("coordinate 1 of point 1"), std::string::npos) << bad << ": " << text;
        EXPECT_NE(text.find("[0, 1)"), std::string::npos);
    }
    EXPECT_NE(complaint({1.0}, 1, 1).find(" 1;"), std::string::npos);
    EXPECT_NE(complaint({std::nan("")}, 1, 1).find("nan"), std::string::npos);
}

TEST(UnitPoints, RejectsOtherSizes) {
    EXPECT_NE(complaint({}, 0, 1), "");
    EXPECT_NE(complaint({}, 1, 0), "");
    EXPECT_NE(complaint(std::vector<double>(65), 1, 65), "");
    EXPECT_EQ(complaint(std::vector<double>(64), 1, 64), "");
    const std::vector<double> values{0.5, 0.25};
    const UnitPoints points(values.data(), 1, 2);
    EXPECT_THROW(points.projection({2}), PointError);
    EXPECT_THROW(points.projection({}), PointError);
}

} // namespace
} // namespace wellstrat
