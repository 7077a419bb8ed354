// SPDX-License-Identifier: Apache-2.0
//
// The types of RiTypesHelper.h and the small arithmetic of RixShadingUtils.h.

#include "RiTypesHelper.h"
#include "RixShadingUtils.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <type_traits>

namespace {

TEST(VectorTest, AbsDotIsTheSizeOfDot) {
    const RtVector3 a(1, 2, 3), b(-4, 5, 0.5f), c(0, 0, -1), e(1, 0, 0);
    EXPECT_EQ(AbsDot(a, b), 7.5f);
    EXPECT_EQ(a.AbsDot(-b), 7.5f);
    EXPECT_EQ(AbsDot(a, c), 3.0f);
    EXPECT_EQ(a.Dot(c), -3.0f);
    EXPECT_EQ(AbsDot(c, e), 0.0f);
    EXPECT_FALSE(std::signbit(c.AbsDot(RtVector3(0, 0, 0)))); // -0 would make 1 / AbsDot negative
}

TEST(VectorTest, ProductsAreByComponents) {
    const RtVector3 a(1, -2, 3), b(4, 5, -6);
    EXPECT_EQ(a * b, RtVector3(4, -10, -18));
    RtVector3 c = a;
    c *= b;
    EXPECT_EQ(c, a * b);
    c = a;
    c *= -1.f;
    EXPECT_EQ(c, -a);
    EXPECT_EQ(RtFloat2(2, -3) * RtFloat2(0.5f, 4), RtFloat2(1, -12));
}

TEST(ColorTest, QuotientsAreByChannels) {
    const RtColorRGB a(1, 2, 3), b(4, 0.5f, -3);
    EXPECT_EQ(a / b, RtColorRGB(0.25f, 4, -1));
    RtColorRGB c = a;
    c /= b;
    EXPECT_EQ(c, a / b);
    EXPECT_EQ(RtColorRGB(1.f) / b, RtColorRGB(0.25f, 2, 1 / -3.0f));
    EXPECT_EQ(a / 2, RtColorRGB(0.5f, 1, 1.5f));
}

TEST(ColorTest, Constants) {
    EXPECT_TRUE(RixConstants::k_ZeroRGB.IsBlack());
    EXPECT_EQ(RixConstants::k_OneRGB, RtColorRGB(1, 1, 1));
    using namespace RixConstants; // as published plug-ins do
    EXPECT_EQ(k_OneRGB - k_OneRGB, k_ZeroRGB);
}

TEST(ShadingUtilsTest, ConstantsAreTheNearestFloats) {
    const double pi = 3.14159265358979323846;
    EXPECT_EQ(F_PI, float(pi));
    EXPECT_EQ(F_TWOPI, float(2 * pi));
    EXPECT_EQ(F_FOURPI, float(4 * pi));
    EXPECT_EQ(F_PIDIV2, float(pi / 2));
    EXPECT_EQ(F_PIDIV4, float(pi / 4));
    EXPECT_EQ(F_INVPI, float(1 / pi));
    EXPECT_EQ(F_INVTWOPI, float(1 / (2 * pi)));
    EXPECT_EQ(F_INVFOURPI, float(1 / (4 * pi)));
    EXPECT_FLOAT_EQ(RixDegreesToRadians(180.0f), F_PI);
    EXPECT_FLOAT_EQ(RixDegreesToRadians(-45.0f), -F_PIDIV4);
}

TEST(ShadingUtilsTest, Clamp) {
    EXPECT_EQ(RixClamp(0.5f, 0.f, 1.f), 0.5f);
    EXPECT_EQ(RixClamp(-2.f, 0.f, 1.f), 0.f);
    EXPECT_EQ(RixClamp(2.f, 0.f, 1.f), 1.f);
    EXPECT_EQ(RixClamp(2.f, 1.f, 1.f), 1.f);
    EXPECT_EQ(RixClamp(7, -3, 3), 3);
    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(RixClamp(-infinity, -1.f, 1.f), -1.f);
    EXPECT_TRUE(std::isnan(RixClamp(std::numeric_limits<float>::quiet_NaN(), 0.f, 1.f)));
}

// Exact at both ends, whatever the values: 1e8 + (0.1 - 1e8) is 0 in float.
TEST(ShadingUtilsTest, MixIsExactAtItsEnds) {
    for (const float a : {0.1f, 1e8f, -3.0f}) {
        for (const float b : {0.1f, 1e8f, -3.0f}) {
            EXPECT_EQ(RixMix(a, b, 0.0f), a);
            EXPECT_EQ(RixMix(a, b, 1.0f), b);
        }
    }
    EXPECT_EQ(RixMix(1.0f, 5.0f, 0.25f), 2.0f);
    EXPECT_EQ(RixMix(0.5, 4.5, 0.25f), 1.5); // double
    EXPECT_EQ(RixMix(RtColorRGB(0, 1, 2), RtColorRGB(4, 5, 6), 0.5f), RtColorRGB(2, 3, 4));
    EXPECT_EQ(RixMix(RtVector3(0, 1, 2), RtVector3(4, 5, 6), 0.5f), RtVector3(2, 3, 4));
}

int ignore(int used, const char* unused) {
    PIXAR_ARGUSED(unused); // or -Wunused-parameter is an error
    return used;
}

TEST(PluginMarksTest, ArgusedIsAStatement) {
    EXPECT_EQ(ignore(3, "hint"), 3);
    int evaluated = 0;
    if (evaluated == 0)
        PIXAR_ARGUSED(evaluated);
    else
        evaluated = 1;
    EXPECT_EQ(evaluated, 0);
}

} // namespace
