// SPDX-License-Identifier: Apache-2.0
//
// Polygons fall apart into triangles that cover them, once.

#include "renderer/import/polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wellstrat::render {
namespace {

using Triangles = std::vector<std::array<uint32_t, 3>>;

Triangles trianglesOf(const std::vector<Float3>& corners) {
    Triangles triangles;
    appendTriangles(corners, triangles);
    return triangles;
}

Float3 areaOf(Float3 a, Float3 b, Float3 c) { return Cross(b - a, c - a) * 0.5f; }

/// That of the polygon: the sum over its edges does not depend on triangles.
Float3 areaOf(const std::vector<Float3>& corners) {
    Float3 sum(0.0f);
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += Cross(corners[i], corners[(i + 1) % corners.size()]) * 0.5f;
    return sum;
}

/// Triangles that all face as the polygon does and have its area cover it exactly once.
void expectCovered(const std::vector<Float3>& corners) {
    const Triangles triangles = trianglesOf(corners);
    EXPECT_EQ(triangles.size(), corners.size() - 2);
    const Float3 area = areaOf(corners);
    float sum = 0;
    for (const auto& [a, b, c] : triangles) {
        const Float3 part = areaOf(corners[a], corners[b], corners[c]);
        EXPECT_GE(Dot(part, area), 0.0f);
        sum += part.Length();
    }
    EXPECT_NEAR(sum, area.Length(), 1e-4f * area.Length());
}

/// With each corner as the first, in both orientations, and in different planes.
void expectCoveredHoweverItLies(std::vector<Float3> corners) {
    for (int plane = 0; plane < 4; ++plane) {
        for (std::size_t i = 0; i < corners.size(); ++i) {
            expectCovered(corners);
            std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        }
        std::reverse(corners.begin(), corners.end());
        expectCovered(corners);
        for (Float3& p : corners) p = {p.z + 0.3f * p.y, p.x, p.y};
    }
}

TEST(Polygons, TrianglesStay) {
    EXPECT_EQ(trianglesOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), (Triangles{{0, 1, 2}}));
}

TEST(Polygons, ConvexOnesAreFans) {
    EXPECT_EQ(trianglesOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}),
              (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

// The shorter diagonal of the second is outside.
TEST(Polygons, QuadsThatAreNotConvex) {
    expectCoveredHoweverItLies({{0, 0, 0}, {2, -1, 0}, {0.2f, 0, 0}, {2, 1, 0}});
    expectCoveredHoweverItLies({{0, 0, 0}, {2, -0.3f, 0}, {1.5f, 0, 0}, {2, 0.3f, 0}});
}

TEST(Polygons, Stars) {
    std::vector<Float3> star;
    for (int i = 0; i < 14; ++i) {
        const float angle = static_cast<float>(i) * 0.448799f; // 2 pi / 14
        const float radius = i % 2 == 0 ? 1.0f : 0.35f;
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0f);
    }
    expectCoveredHoweverItLies(star);
}

TEST(Polygons, Spirals) {
    expectCoveredHoweverItLies({{0, 0, 0},
                                {5, 0, 0},
                                {5, 5, 0},
                                {1, 5, 0},
                                {1, 2, 0},
                                {3, 2, 0},
                                {3, 3, 0},
                                {2, 3, 0},
                                {2, 4, 0},
                                {4, 4, 0},
                                {4, 1, 0},
                                {0, 1, 0}});
}

// Corners in the middle of sides, as where a side is shared with two polygons.
TEST(Polygons, CornersOnSides) {
    expectCoveredHoweverItLies({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {0, 2, 0}});
}

// Around a hole, which a pair of sides connects with the outside.
TEST(Polygons, HolesWithABridge) {
    expectCoveredHoweverItLies({{0, 0, 0},
                                {3, 0, 0},
                                {3, 3, 0},
                                {0, 3, 0},
                                {0, 0, 0},
                                {1, 1, 0},
                                {1, 2, 0},
                                {2, 2, 0},
                                {2, 1, 0},
                                {1, 1, 0}});
}

TEST(Polygons, WhateverTheyAreTheyGiveAsManyTriangles) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(trianglesOf({{0, 0, 0}, {nan, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 2, 0}}).size(), 3u);
    EXPECT_EQ(trianglesOf({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(),
              2u); // crosses itself
    EXPECT_EQ(trianglesOf(std::vector<Float3>(6, Float3(1.0f))).size(), 4u);
    EXPECT_TRUE(trianglesOf({}).empty());
    EXPECT_TRUE(trianglesOf({{0, 0, 0}, {1, 0, 0}}).empty());
}

} // namespace
} // namespace wellstrat::render
