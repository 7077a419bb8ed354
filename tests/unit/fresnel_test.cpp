// SPDX-License-Identifier: Apache-2.0
//
// Fresnel's equations, as RixShadingUtils.h has them: against the textbook's in complex double
// arithmetic, and by what must hold of them.

#include "RixShadingUtils.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Cosines from 0 to 1, dense at both ends.
std::vector<float> cosines() {
    std::vector<float> values = {0.0f, 1e-7f, 1e-5f, 1e-4f, 0.9999f, 1.0f - 0x1p-24f, 1.0f};
    for (int i = 1; i < 1000; ++i) values.push_back(static_cast<float>(i) * 1e-3f);
    return values;
}

const std::vector<float> kEtas = {0.05f,   0.18f, 0.5f, 0.75f, 0.999f, 1.0f, 1.0001f,
                                  1.3333f, 1.5f,  2.4f, 5.0f,  50.0f,  1e4f};
const std::vector<float> kKappas = {0.0f, 1e-4f, 0.3f, 1.0f, 3.42f, 10.0f, 1e3f};

/// The mean power of the two amplitudes, Born and Wolf, section 1.5.2, equation 21, with a complex
/// index n of the second medium over that of the first.
double textbook(double cosine, std::complex<double> n) {
    const std::complex<double> behind = std::sqrt(n * n - (1.0 - cosine * cosine)); // n cos(theta2)
    const std::complex<double> perpendicular = (cosine - behind) / (cosine + behind);
    const std::complex<double> parallel = (n * n * cosine - behind) / (n * n * cosine + behind);
    return 0.5 * (std::norm(perpendicular) + std::norm(parallel));
}

/// Whether light that does not vanish behind the surface leaves almost along it. There the share
/// rises to 1 like a square root, and rounding of the arguments shows.
bool nearCriticalAngle(double cosine, double eta, double kappa) {
    return kappa < 1e-2 && std::fabs(eta * eta - (1.0 - cosine * cosine)) < 5e-3;
}

TEST(FresnelConductorTest, IsTheTextbooks) {
    for (const float eta : kEtas) {
        for (const float kappa : kKappas) {
            for (const float cosine : cosines()) {
                if (cosine == 0.0f) continue; // 0 / 0 there
                const double tolerance = nearCriticalAngle(cosine, eta, kappa) ? 1e-4 : 2e-6;
                ASSERT_NEAR(RixFresnelConductor(cosine, eta, kappa), textbook(cosine, {eta, kappa}),
                            tolerance)
                    << "cosine " << cosine << ", eta " << eta << ", kappa " << kappa;
            }
        }
    }
}

TEST(FresnelDielectricTest, IsTheTextbooks) {
    for (const float eta : kEtas) {
        for (const float cosine : cosines()) {
            if (cosine == 0.0f) continue;
            const double n = 1.0 / eta;
            const double tolerance = nearCriticalAngle(cosine, n, 0.0) ? 1e-4 : 2e-6;
            ASSERT_NEAR(RixFresnelDielectric(cosine, eta), textbook(cosine, n), tolerance)
                << "cosine " << cosine << ", eta " << eta;
        }
    }
}

TEST(FresnelConductorTest, AtRightAnglesIsTheSchoolbooks) {
    for (const double n : {0.05, 0.18, 0.42, 1.0, 1.37, 2.9, 10.0}) {
        for (const double k : {0.0, 1.77, 2.35, 3.42, 6.0}) {
            const double share = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
            EXPECT_NEAR(RixFresnelConductor(1.0f, float(n), float(k)), share, 1e-6);
        }
    }
    EXPECT_NEAR(RixFresnelDielectric(1.0f, 1 / 1.5f), 0.04, 1e-7);
    EXPECT_NEAR(RixFresnelDielectric(1.0f, 1.5f), 0.04, 1e-7);
    EXPECT_NEAR(RixFresnelDielectric(1.0f, 1 / 2.42f), std::pow(1.42 / 3.42, 2), 1e-7); // diamond
}

// Values printed in textbooks: air to glass of index 1.5 at 60 degrees has amplitudes -0.4202
// and -0.0424 (perpendicular, parallel).
TEST(FresnelDielectricTest, IsRightAtKnownAngles) {
    EXPECT_NEAR(RixFresnelDielectric(0.5f, 1 / 1.5f), (0.4202 * 0.4202 + 0.0424 * 0.0424) / 2,
                1e-4);
    // At Brewster's angle, tan = n, the parallel share is 0, and the other ((n^2-1)/(n^2+1))^2.
    for (const double n : {1.1, 1.3333, 1.5, 2.4}) {
        const double perpendicular = (n * n - 1) / (n * n + 1);
        const double cosine = 1 / std::sqrt(1 + n * n);
        EXPECT_NEAR(RixFresnelDielectric(float(cosine), float(1 / n)),
                    perpendicular * perpendicular / 2, 1e-6);
    }
}

TEST(FresnelDielectricTest, ReflectsAllBeyondTheCriticalAngle) {
    for (const double eta : {1.0001, 1.3333, 1.5, 2.4, 50.0}) {
        const double sine = 1 / eta;
        for (const double step : {1e-4, 0.01, 0.3}) {
            const double inside = sine - step * sine, outside = sine + step * (1 - sine);
            EXPECT_LT(RixFresnelDielectric(float(std::sqrt(1 - inside * inside)), float(eta)),
                      1.0f);
            EXPECT_EQ(RixFresnelDielectric(float(std::sqrt(1 - outside * outside)), float(eta)),
                      1.0f);
        }
    }
}

// A boundary reflects as much of the light that comes from behind along the refracted direction.
TEST(FresnelDielectricTest, IsTheSameFromBothSides) {
    for (const double n : {1.01, 1.3333, 1.5, 2.4, 4.0}) {
        for (const float cosine : cosines()) {
            if (cosine < 0.05f) continue; // rounded directions show more and more
            const double behind = std::sqrt(1 - (1 - double(cosine) * cosine) / (n * n));
            ASSERT_NEAR(RixFresnelDielectric(cosine, float(1 / n)),
                        RixFresnelDielectric(float(behind), float(n)), 1e-4)
                << "cosine " << cosine << ", n " << n;
        }
    }
}

TEST(FresnelConductorTest, WithoutAbsorptionIsTheDielectric) {
    for (const float eta : {0.5f, 0.8f, 1.3333f, 1.5f, 4.0f}) {
        for (const float cosine : cosines()) {
            if (nearCriticalAngle(cosine, eta, 0.0)) continue;
            ASSERT_NEAR(RixFresnelConductor(cosine, eta, 0.0f),
                        RixFresnelDielectric(cosine, 1 / eta), 2e-6)
                << "cosine " << cosine << ", eta " << eta;
        }
    }
}

TEST(FresnelTest, SharesAreInTheUnitInterval) {
    for (const float eta : kEtas) {
        for (const float cosine : cosines()) {
            const float dielectric = RixFresnelDielectric(cosine, eta);
            ASSERT_TRUE(dielectric >= 0.0f && dielectric <= 1.0f) << cosine << ' ' << eta;
            for (const float kappa : kKappas) {
                const float conductor = RixFresnelConductor(cosine, eta, kappa);
                ASSERT_TRUE(conductor >= 0.0f && conductor <= 1.0f)
                    << cosine << ' ' << eta << ' ' << kappa;
            }
        }
    }
}

// Grazing light, an empty medium, equal media, the ends of the ranges, cosines of either sign and
// above 1 by rounding, NaN.
TEST(FresnelTest, LimitsAreDefined) {
    for (const float eta : {0.0f, 0.5f, 1.0f, 1.5f, 1e9f}) {
        for (const float kappa : {0.0f, 3.0f, 1e9f}) {
            EXPECT_EQ(RixFresnelConductor(0.0f, eta, kappa), 1.0f) << eta << ' ' << kappa;
            EXPECT_LE(RixFresnelConductor(0.5f, eta, kappa), 1.0f) << eta << ' ' << kappa;
        }
    }
    for (const float eta : {1e-9f, 0.5f, 1.0f, 1.5f, 1e9f}) {
        EXPECT_EQ(RixFresnelDielectric(0.0f, eta), 1.0f) << eta;
    }
    for (const float cosine : {0.0f, 0.5f, 1.0f}) {
        EXPECT_EQ(RixFresnelConductor(cosine, 0.0f, 0.0f), 1.0f);
    }
    for (const float cosine : {1e-6f, 1e-3f, 0.5f, 1.0f}) {
        EXPECT_NEAR(RixFresnelDielectric(cosine, 1.0f), 0.0f, 1e-12f);
        EXPECT_NEAR(RixFresnelConductor(cosine, 1.0f, 0.0f), 0.0f, 1e-12f);
    }
    EXPECT_EQ(RixFresnelDielectric(-0.3f, 1.5f), RixFresnelDielectric(0.3f, 1.5f));
    EXPECT_EQ(RixFresnelConductor(-0.3f, 0.2f, 3.0f), RixFresnelConductor(0.3f, 0.2f, 3.0f));
    const float aboveOne = 1.0f + 0x1p-22f;
    EXPECT_NEAR(RixFresnelDielectric(aboveOne, 1 / 1.5f), 0.04, 1e-6);
    EXPECT_NEAR(RixFresnelConductor(aboveOne, 1.5f, 0.0f), 0.04, 1e-6);
    EXPECT_TRUE(std::isnan(RixFresnelDielectric(kNaN, 1.5f)));
    EXPECT_TRUE(std::isnan(RixFresnelDielectric(0.5f, kNaN)));
    EXPECT_TRUE(std::isnan(RixFresnelConductor(0.5f, 1.5f, kNaN)));
}

// Channels are independent, and the value that is returned is the one that is written.
TEST(FresnelTest, ColorsAndResultsByPointer) {
    const RtColorRGB eta(0.18f, 0.42f, 1.37f), kappa(3.42f, 2.35f, 1.77f);
    RtColorRGB written(0.0f);
    const RtColorRGB returned = RixFresnelConductor(0.7f, eta, kappa, &written);
    EXPECT_EQ(written, returned);
    // Compilers round constants in another way than at run time.
    EXPECT_FLOAT_EQ(returned.r, RixFresnelConductor(0.7f, 0.18f, 3.42f));
    EXPECT_FLOAT_EQ(returned.g, RixFresnelConductor(0.7f, 0.42f, 2.35f));
    EXPECT_FLOAT_EQ(returned.b, RixFresnelConductor(0.7f, 1.37f, 1.77f));
    RtFloat share = -1.0f;
    EXPECT_EQ(RixFresnelConductor(0.7f, 0.18f, 3.42f, &share), share);
    EXPECT_FLOAT_EQ(share, written.r);
    EXPECT_EQ(RixFresnelDielectric(0.7f, 1.5f, &share), share);
    EXPECT_GT(share, 0.0f);
}

} // namespace
