// SPDX-License-Identifier: Apache-2.0
//
// RixShadingUtils.h: frames at a surface, changes of basis, spherical directions, facing normals.

#include "RixShadingUtils.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Unit vectors all over the sphere, the axes among them.
std::vector<RtVector3> directions() {
    std::vector<RtVector3> all = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                                  {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    for (int i = 0; i < 200; ++i) { // a spiral
        const float z = (static_cast<float>(i) + 0.5f) / 100.0f - 1.0f;
        const float phi = 2.4f * static_cast<float>(i);
        RtVector3 d = RixSphericalDirection(std::sqrt((1.0f - z) * (1.0f + z)), z, phi);
        d.Normalize();
        all.push_back(d);
    }
    return all;
}

void expectOrthonormal(RtVector3 x, RtVector3 y, RtVector3 z) {
    EXPECT_NEAR(x.Length(), 1.0f, 1e-6f);
    EXPECT_NEAR(y.Length(), 1.0f, 1e-6f);
    EXPECT_NEAR(Dot(x, y), 0.0f, 1e-6f);
    EXPECT_NEAR(Dot(x, z), 0.0f, 1e-6f);
    EXPECT_NEAR(Dot(y, z), 0.0f, 1e-6f);
    EXPECT_NEAR(Dot(Cross(x, y), z), 1.0f, 1e-6f) << "left-handed";
}

TEST(ShadingBasisTest, IsAnOrthonormalFrameAlongTheTangent) {
    for (const RtNormal3& normal : directions()) {
        for (const RtVector3& tangent : directions()) {
            for (const float length : {1.0f, 1e-10f, 1e10f}) {
                RtVector3 x, y;
                RixComputeShadingBasis(normal, tangent * length, x, y);
                expectOrthonormal(x, y, normal);
                const float across = Cross(normal, tangent).Length();
                if (across < 1e-3f) continue;
                EXPECT_NEAR(Dot(x, tangent), across, 1e-6f);
                EXPECT_NEAR(Dot(y, tangent), 0.0f, 1e-6f);
            }
        }
    }
}

// Where subtracting the normal's part of the tangent leaves little but rounding errors. Guards
// against frames that are not orthonormal there.
TEST(ShadingBasisTest, HoldsForTangentsThatAreAlmostTheNormal) {
    for (const RtNormal3& normal : directions()) {
        RtVector3 u, v;
        normal.CreateOrthonormalBasis(u, v);
        for (const float angle : {1e-2f, 1e-4f, 1e-5f, 1e-6f, 1e-7f, 0.0f}) {
            for (const float sign : {1.0f, -1.0f}) {
                RtVector3 x, y;
                RixComputeShadingBasis(normal, normal * sign + u * angle, x, y);
                expectOrthonormal(x, y, normal);
            }
        }
    }
}

TEST(ShadingBasisTest, TakesUselessTangents) {
    for (const RtNormal3& normal : directions()) {
        for (const RtVector3& tangent : {RtVector3(0.0f), RtVector3(kNaN), RtVector3(0, kNaN, 1)}) {
            RtVector3 x, y;
            RixComputeShadingBasis(normal, tangent, x, y);
            expectOrthonormal(x, y, normal);
        }
    }
}

TEST(ShadingBasisTest, TangentMayBeTheAxis) {
    const RtNormal3 normal(0.6f, -0.48f, 0.64f);
    const RtVector3 tangent(0.2f, 0.9f, -0.1f);
    RtVector3 x, y, same = tangent, other;
    RixComputeShadingBasis(normal, tangent, x, y);
    RixComputeShadingBasis(normal, same, same, other);
    EXPECT_EQ(same, x);
    EXPECT_EQ(other, y);
}

TEST(ChangeBasisTest, ToAndFromAreInverse) {
    const RtVector3 vector(0.3f, -2.0f, 7.0f);
    for (const RtNormal3& z : directions()) {
        RtVector3 x, y;
        z.CreateOrthonormalBasis(x, y);
        const RtVector3 local = RixChangeBasisTo(vector, x, y, z);
        EXPECT_NEAR(local.x, Dot(vector, x), 1e-6f);
        EXPECT_NEAR(local.y, Dot(vector, y), 1e-6f);
        EXPECT_NEAR(local.z, Dot(vector, z), 1e-6f);
        EXPECT_LT((RixChangeBasisFrom(local, x, y, z) - vector).Length(), 5e-6f);
        EXPECT_LT((RixChangeBasisTo(z, x, y, z) - RtVector3(0, 0, 1)).Length(), 1e-6f);
    }
}

TEST(SphericalDirectionTest, TurnsFromXTowardsY) {
    const auto near = [](RtVector3 a, RtVector3 b) { return (a - b).Length() < 1e-6f; };
    EXPECT_TRUE(near(RixSphericalDirection(0, 1, 2.0f), {0, 0, 1}));
    EXPECT_TRUE(near(RixSphericalDirection(1, 0, 0), {1, 0, 0}));
    EXPECT_TRUE(near(RixSphericalDirection(1, 0, F_PIDIV2), {0, 1, 0}));
    EXPECT_TRUE(near(RixSphericalDirection(1, 0, F_PI), {-1, 0, 0}));
    EXPECT_TRUE(near(RixSphericalDirection(0.6f, -0.8f, -F_PIDIV2), {0, -0.6f, -0.8f}));

    const RtVector3 x(0, 1, 0), y(0, 0, 1), z(1, 0, 0);
    EXPECT_TRUE(near(RixSphericalDirection(0, 1, 2.0f, x, y, z), z));
    EXPECT_TRUE(near(RixSphericalDirection(1, 0, 0, x, y, z), x));
    EXPECT_TRUE(near(RixSphericalDirection(1, 0, F_PIDIV2, x, y, z), y));
    EXPECT_TRUE(near(RixSphericalDirection(0.6f, 0.8f, F_PI, x, y, z), {0.8f, -0.6f, 0}));
}

TEST(FacingNormalTest, BackwardIsTheOtherSide) {
    const RtVector3 view(0.6f, 0.0f, 0.8f);
    const RtNormal3 up(0.0f, 0.0f, 1.0f);
    for (const RtNormal3& normal : {up, -up}) {
        RtFloat cosView = 7.0f;
        EXPECT_EQ(RixGetBackwardFacingNormal(view, normal, &cosView), -up);
        EXPECT_FLOAT_EQ(cosView, -0.8f);
        EXPECT_EQ(RixGetBackwardFacingNormal(view, normal), -up);
    }
}

} // namespace
