// SPDX-License-Identifier: Apache-2.0
//
// The maps of warp.h, all by the same tests: against the density, through the inverse, over strata
// and at the edges of the square.

#include "wellstrat/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

namespace {

using wellstrat::Float2;
using wellstrat::Float3;

constexpr double kPi = 3.14159265358979323846;
constexpr float kLargest = 1.0f - 0x1p-24f;

/// A parametrization of a shape by [0, 1]^2 that owes nothing to warp.h.
struct Chart {
    std::function<Float3(double u, double v)> point;
    std::function<double(double u, double v)> areaElement;
    std::function<std::array<double, 2>(Float3)> coordinates;
};

double turnOf(Float3 p) {
    const double turn = std::atan2(double(p.y), double(p.x)) / (2.0 * kPi);
    return turn < 0.0 ? turn + 1.0 : turn;
}

Float3 makeFloat3(double x, double y, double z) {
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

Chart diskChart() {
    return {[](double u, double v) {
                return makeFloat3(u * std::cos(2.0 * kPi * v), u * std::sin(2.0 * kPi * v), 0.0);
            },
            [](double u, double) { return 2.0 * kPi * u; },
            [](Float3 p) {
                return std::array{std::hypot(double(p.x), double(p.y)), turnOf(p)};
            }};
}

Chart triangleChart() {
    return {[](double u, double v) { return makeFloat3(1.0 - u, v * u, 0.0); },
            [](double u, double) { return u; },
            [](Float3 p) {
                return std::array{1.0 - p.x, p.x < 1.0f ? p.y / (1.0 - p.x) : 0.0};
            }};
}

Chart cylinderChart() {
    return {[](double u, double v) {
                return makeFloat3(std::cos(2.0 * kPi * v), std::sin(2.0 * kPi * v), u);
            },
            [](double, double) { return 2.0 * kPi; },
            [](Float3 p) {
                return std::array{double(p.z), turnOf(p)};
            }};
}

/// Directions up to an angle from the z axis.
Chart directionChart(double maxTheta) {
    return {[maxTheta](double u, double v) {
                const double s = std::sin(u * maxTheta);
                const double phi = 2.0 * kPi * v;
                return makeFloat3(s * std::cos(phi), s * std::sin(phi), std::cos(u * maxTheta));
            },
            [maxTheta](double u, double) { return 2.0 * kPi * maxTheta * std::sin(u * maxTheta); },
            [maxTheta](Float3 d) {
                const double theta = std::atan2(std::hypot(double(d.x), double(d.y)), double(d.z));
                return std::array{theta / maxTheta, turnOf(d)};
            }};
}

enum class Range { planar, directions, upperDirections };

/// One map with its parameters bound. Planar points have z = 0.
struct Warp {
    std::string name;
    Range range;
    Chart chart;
    std::function<Float3(Float2)> forward;
    std::function<Float2(Float3)> inverse;
    std::function<float(Float3)> pdf;
};

std::ostream& operator<<(std::ostream& out, const Warp& warp) { return out << warp.name; }

Warp diskWarp(const char* name, Float2 (*forward)(Float2), Float2 (*inverse)(Float2)) {
    return {name,
            Range::planar,
            diskChart(),
            [forward](Float2 xi) {
                const Float2 p = forward(xi);
                return Float3(p.x, p.y, 0.0f);
            },
            [inverse](Float3 p) {
                return inverse({p.x, p.y});
            },
            [](Float3) { return wellstrat::diskPdf(); }};
}

Warp triangleWarp() {
    return {"Triangle",
            Range::planar,
            triangleChart(),
            [](Float2 xi) {
                const Float2 p = wellstrat::squareToTriangle(xi);
                return Float3(p.x, p.y, 0.0f);
            },
            [](Float3 p) {
                return wellstrat::triangleToSquare({p.x, p.y});
            },
            [](Float3) { return wellstrat::trianglePdf(); }};
}

Warp coneWarp(const char* name, float cosThetaMax) {
    return {name,
            Range::directions,
            directionChart(std::acos(double(cosThetaMax))),
            [=](Float2 xi) { return wellstrat::squareToCone(xi, cosThetaMax); },
            [=](Float3 d) { return wellstrat::coneToSquare(d, cosThetaMax); },
            [=](Float3) { return wellstrat::conePdf(cosThetaMax); }};
}

Warp powerCosineWarp(const char* name, float exponent, double maxTheta) {
    return {name,
            Range::upperDirections,
            directionChart(maxTheta),
            [=](Float2 xi) { return wellstrat::squareToPowerCosine(xi, exponent); },
            [=](Float3 d) { return wellstrat::powerCosineToSquare(d, exponent); },
            [=](Float3 d) { return wellstrat::powerCosinePdf(d.z, exponent); }};
}

Warp ggxWarp(const char* name, Float3 view, float alphaX, float alphaY) {
    view.Normalize();
    return {
        name,
        Range::upperDirections,
        directionChart(0.5 * kPi),
        [=](Float2 xi) { return wellstrat::squareToGgxVisibleNormal(xi, view, alphaX, alphaY); },
        [=](Float3 m) { return wellstrat::ggxVisibleNormalToSquare(m, view, alphaX, alphaY); },
        [=](Float3 m) { return wellstrat::ggxVisibleNormalPdf(m, view, alphaX, alphaY); }};
}

std::vector<Warp> allWarps() {
    using namespace wellstrat;
    return {
        diskWarp("DiskPolar", squareToDiskPolar, diskToSquarePolar),
        diskWarp("DiskConcentric", squareToDiskConcentric, diskToSquareConcentric),
        triangleWarp(),
        {"Cylinder", Range::planar, cylinderChart(), squareToCylinder, cylinderToSquare,
         [](Float3) { return cylinderPdf(); }},
        {"Sphere", Range::directions, directionChart(kPi), squareToSphere, sphereToSquare,
         [](Float3) { return spherePdf(); }},
        {"Hemisphere", Range::upperDirections, directionChart(0.5 * kPi), squareToHemisphere,
         hemisphereToSquare, [](Float3) { return hemispherePdf(); }},
        coneWarp("ConeWide", -0.7f),
        coneWarp("ConeMedium", 0.5f),
        coneWarp("ConeNarrow", 0.9999f),
        {"HemisphereCosine", Range::upperDirections, directionChart(0.5 * kPi),
         squareToHemisphereCosine, hemisphereCosineToSquare,
         [](Float3 d) { return hemisphereCosinePdf(d.z); }},
        powerCosineWarp("PowerCosine0", 0.0f, 0.5 * kPi),
        powerCosineWarp("PowerCosine2", 2.5f, 0.5 * kPi),
        powerCosineWarp("PowerCosine20", 20.0f, 0.5 * kPi),
        powerCosineWarp("PowerCosine5000", 5000.0f, 0.08), // 1e-7 of it lies outside the chart
        ggxWarp("GgxFacing", {0.0f, 0.0f, 1.0f}, 0.5f, 0.5f),
        ggxWarp("GgxAnisotropic", {0.5f, -0.6f, 0.4f}, 0.2f, 0.6f),
        ggxWarp("GgxGrazing", {-1.0f, 0.3f, 0.05f}, 0.3f, 0.25f),
        ggxWarp("GgxRough", {1.0f, 1.0f, 0.5f}, 1.0f, 1.0f),
    };
}

class WarpTest : public testing::TestWithParam<Warp> {};

std::string warpName(const testing::TestParamInfo<Warp>& warp) { return warp.param.name; }

INSTANTIATE_TEST_SUITE_P(All, WarpTest, testing::ValuesIn(allWarps()), warpName);

/// A grid of cells over a chart, for comparing counts of samples with integrals of the density.
class CellGrid {
public:
    static constexpr int kCells = 24; ///< along each side

    explicit CellGrid(const Warp& warp) : warp_(warp), cells_(kCells * kCells) {}

    /// The probability of each cell, by the midpoint rule with 12 x 12 points.
    std::vector<double> probabilities() const {
        const int sub = 12;
        const double step = 1.0 / (kCells * sub);
        std::vector<double> result(cells_);
        for (int i = 0; i < kCells * sub; ++i) {
            for (int j = 0; j < kCells * sub; ++j) {
                const double u = (i + 0.5) * step;
                const double v = (j + 0.5) * step;
                result[cell(u, v)] += double(warp_.pdf(warp_.chart.point(u, v))) *
                                      warp_.chart.areaElement(u, v) * step * step;
            }
        }
        return result;
    }

    std::vector<double> counts(int samples, unsigned seed) const {
        std::mt19937 random(seed);
        const auto next = [&random] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
        std::vector<double> result(cells_);
        for (int s = 0; s < samples; ++s) {
            const float x = next();
            const auto [u, v] = warp_.chart.coordinates(warp_.forward({x, next()}));
            result[cell(u, v)] += 1.0;
        }
        return result;
    }

private:
    static std::size_t cell(double u, double v) {
        const auto index = [](double t) {
            return static_cast<std::size_t>(
                std::clamp(static_cast<int>(t * kCells), 0, kCells - 1));
        };
        return index(u) * kCells + index(v);
    }

    const Warp& warp_;
    std::size_t cells_;
};

/// Pearson's statistic as a standard normal deviate, by Wilson and Hilferty's cube root. Cells of
/// which fewer than 10 samples are expected are taken together.
double chiSquareDeviate(const std::vector<double>& counts, const std::vector<double>& probabilities,
                        int samples) {
    double statistic = 0.0, rareCount = 0.0, rareExpected = 0.0;
    int used = 0;
    const auto add = [&](double count, double expected) {
        statistic += (count - expected) * (count - expected) / expected;
        ++used;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = probabilities[i] * samples;
        if (expected >= 10.0) {
            add(counts[i], expected);
        } else {
            rareCount += counts[i];
            rareExpected += expected;
        }
    }
    if (rareExpected >= 10.0) add(rareCount, rareExpected);
    const double freedom = used - 1;
    const double variance = 2.0 / (9.0 * freedom);
    return (std::cbrt(statistic / freedom) - (1.0 - variance)) / std::sqrt(variance);
}

// The false-alarm rate is 1e-6 for each map, 2e-5 for all.
constexpr double kDeviateLimit = 4.753;
constexpr int kChiSquareSamples = 400000;

// Guards against a map that does not have the density it is said to have.
TEST_P(WarpTest, SamplesFollowTheDensity) {
    const CellGrid grid(GetParam());
    const double deviate = chiSquareDeviate(grid.counts(kChiSquareSamples, 20260401),
                                            grid.probabilities(), kChiSquareSamples);
    EXPECT_LT(deviate, kDeviateLimit);
}

// Guards against a chi-square test that passes anything: the same limit refuses densities that are
// wrong in shape by a few percent.
TEST(WarpChiSquareTest, RefusesANeighboringDensity) {
    Warp warp = powerCosineWarp("", 20.0f, 0.5 * kPi);
    warp.pdf = [](Float3 d) { return wellstrat::powerCosinePdf(d.z, 20.5f); };
    const CellGrid grid(warp);
    const double deviate = chiSquareDeviate(grid.counts(kChiSquareSamples, 20260401),
                                            grid.probabilities(), kChiSquareSamples);
    EXPECT_GT(deviate, kDeviateLimit);
}

TEST_P(WarpTest, DensityIntegratesToOne) {
    double sum = 0.0;
    for (const double probability : CellGrid(GetParam()).probabilities()) sum += probability;
    EXPECT_NEAR(sum, 1.0, 1e-3);
}

double triangleArea(Float3 a, Float3 b, Float3 c) {
    return 0.5 * double(Cross(b - a, c - a).Length());
}

/// The middle of a face of the mesh, on the shape.
Float3 middle(const Warp& warp, const Float3 (&corners)[4]) {
    Float3 sum = (corners[0] + corners[1] + corners[2] + corners[3]) / 4.0f;
    if (warp.range != Range::planar) sum.Normalize();
    return sum;
}

/// The probability of what `warp` makes of the stratum (i, j) of 8 x 8: the areas of a mesh over
/// it, weighted with the density in the middle of each face. The mesh is finer towards the ends,
/// where some maps stretch the square without limit.
double stratumProbability(const Warp& warp, int i, int j) {
    const int faces = 32;
    const auto line = [](int stratum, int k) {
        const double t = double(k) / faces;
        const double graded = t * t * t * (10.0 + t * (6.0 * t - 15.0));
        return std::min(static_cast<float>((stratum + graded) / 8.0), kLargest);
    };
    double probability = 0.0;
    for (int k = 0; k < faces; ++k) {
        for (int l = 0; l < faces; ++l) {
            const float x[] = {line(i, k), line(i, k + 1)};
            const float y[] = {line(j, l), line(j, l + 1)};
            const Float3 corners[] = {warp.forward({x[0], y[0]}), warp.forward({x[1], y[0]}),
                                      warp.forward({x[1], y[1]}), warp.forward({x[0], y[1]})};
            const double area = triangleArea(corners[0], corners[1], corners[2]) +
                                triangleArea(corners[0], corners[2], corners[3]);
            probability += area * double(warp.pdf(middle(warp, corners)));
        }
    }
    return probability;
}

// Strata of samples must become strata of equal probability, and of equal area where the density is
// constant. Guards against maps that have the right density only on average over strata, such as a
// disk that takes its radius without the square root in one sector.
TEST_P(WarpTest, StrataHaveEqualProbability) {
    for (int i = 0; i < 8; ++i) {
        for (int j = 0; j < 8; ++j) {
            EXPECT_NEAR(stratumProbability(GetParam(), i, j) * 64.0, 1.0, 0.02) << i << ' ' << j;
        }
    }
}

double distanceOnCircle(double a, double b) {
    const double d = std::fabs(a - b);
    return std::min(d, 1.0 - d);
}

// Away from the pole, where all azimuths are one point, and from the far end, where a step of the
// sample is a step of the direction's last bit.
TEST_P(WarpTest, InverseGivesTheSampleBack) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> inside(0.02f, 0.98f);
    for (int k = 0; k < 100000; ++k) {
        const float x = inside(random);
        const Float2 xi(x, inside(random));
        const Float2 back = GetParam().inverse(GetParam().forward(xi));
        ASSERT_NEAR(back.x, xi.x, 1e-4) << xi.x << ' ' << xi.y;
        ASSERT_LT(distanceOnCircle(double(back.y), double(xi.y)), 1e-4) << xi.x << ' ' << xi.y;
    }
}

std::vector<Float2> edgeSamples() {
    const float values[] = {
        0.0f, 0x1p-24f,        0x1p-23f, 0x1p-12f,        0.25f,           0.5f - 0x1p-24f,
        0.5f, 0.5f + 0x1p-24f, 0.75f,    1.0f - 0x1p-12f, 1.0f - 0x1p-23f, kLargest};
    std::vector<Float2> result;
    for (const float x : values) {
        for (const float y : values) result.emplace_back(x, y);
    }
    return result;
}

void expectInRange(const Warp& warp, Float2 xi) {
    const Float3 p = warp.forward(xi);
    ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
    if (warp.range != Range::planar) {
        ASSERT_NEAR(p.Length(), 1.0f, 3e-7f);
    }
    if (warp.range == Range::upperDirections) {
        ASSERT_GT(p.z, 0.0f);
    }
    ASSERT_TRUE(std::isfinite(warp.pdf(p)));
    const Float2 back = warp.inverse(p);
    ASSERT_TRUE(back.x >= 0.0f && back.x < 1.0f && back.y >= 0.0f && back.y < 1.0f)
        << back.x << ' ' << back.y;
    ASSERT_LT((warp.forward(back) - p).Length(), 1e-3f);
}

// Guards against NaNs, directions that are not of length 1 or lie in the surface, and inverses that
// return 1, all of which show up at the corners first.
TEST_P(WarpTest, EdgesOfTheSquareAreSafe) {
    for (const Float2 xi : edgeSamples()) {
        expectInRange(GetParam(), xi);
        if (HasFatalFailure()) FAIL() << "at " << xi.x << ' ' << xi.y;
    }
}

TEST(WarpGgxTest, ExtremeRoughnessAndViewsAreSafe) {
    for (const float alphaX : {1e-4f, 0.03f, 1.0f, 4.0f}) {
        for (const float alphaY : {1e-4f, 0.3f, 1.0f}) {
            for (const float z : {1e-6f, 1e-3f, 0.3f, 1.0f}) {
                Float3 view(0.8f * (1.0f - z), -0.6f * (1.0f - z), z);
                view.Normalize();
                for (const Float2 xi : edgeSamples()) {
                    const Float3 m = wellstrat::squareToGgxVisibleNormal(xi, view, alphaX, alphaY);
                    ASSERT_NEAR(m.Length(), 1.0f, 3e-7f);
                    ASSERT_GT(m.z, 0.0f);
                    ASSERT_GT(Dot(view, m), -1e-6f);
                    const float pdf = wellstrat::ggxVisibleNormalPdf(m, view, alphaX, alphaY);
                    ASSERT_TRUE(std::isfinite(pdf) && pdf >= 0.0f);
                }
            }
        }
    }
}

TEST(WarpDiskTest, ConcentricSquaresBecomeCircles) {
    for (const float half : {0.125f, 0.25f, 0.375f}) {
        for (const float t : {-1.0f, -0.6f, 0.0f, 0.3f, 1.0f}) {
            for (const Float2 side : {Float2(half, half * t), Float2(-half, half * t),
                                      Float2(half * t, half), Float2(half * t, -half)}) {
                const Float2 p = wellstrat::squareToDiskConcentric(side + Float2(0.5f, 0.5f));
                EXPECT_NEAR(std::hypot(p.x, p.y), 2.0f * half, 1e-6f);
            }
        }
    }
    EXPECT_EQ(wellstrat::squareToDiskConcentric({0.5f, 0.5f}), Float2(0.0f, 0.0f));
}

// A jump would tear strata apart. The polar map has one by nature, this one must have none.
TEST(WarpDiskTest, ConcentricIsContinuous) {
    const int n = 512;
    for (int i = 0; i + 1 < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const float x = static_cast<float>(i) / n;
            const float y = static_cast<float>(j) / n;
            for (const auto& [a, b] : {std::pair(Float2(x, y), Float2(x + 1.0f / n, y)),
                                       std::pair(Float2(y, x), Float2(y, x + 1.0f / n))}) {
                const Float2 step =
                    wellstrat::squareToDiskConcentric(b) - wellstrat::squareToDiskConcentric(a);
                ASSERT_LT(std::hypot(step.x, step.y), 3.0f / n);
            }
        }
    }
}

// Rounding must not push a point out of the triangle.
TEST(WarpTriangleTest, BarycentricCoordinatesAreNotNegative) {
    std::mt19937 random(3);
    std::vector<Float2> samples = edgeSamples();
    for (int k = 0; k < 1000000; ++k) {
        const float x = static_cast<float>(random() >> 8) * 0x1p-24f;
        samples.emplace_back(x, static_cast<float>(random() >> 8) * 0x1p-24f);
    }
    for (const Float2 xi : samples) {
        const Float2 p = wellstrat::squareToTriangle(xi);
        ASSERT_TRUE(p.x >= 0.0f && p.y >= 0.0f && 1.0f - p.x - p.y >= 0.0f) << xi.x << ' ' << xi.y;
    }
}

TEST(WarpTriangleTest, PointsLieInTheGivenTriangle) {
    const Float3 a(1.0f, 2.0f, 3.0f), b(3.0f, 2.0f, 3.0f), c(1.0f, 5.0f, 3.0f);
    EXPECT_FLOAT_EQ(wellstrat::trianglePdf(a, b, c), 1.0f / 3.0f);
    const Float3 middle = (a + b + c) / 3.0f;
    const Float2 xi = wellstrat::triangleToSquare({1.0f / 3.0f, 1.0f / 3.0f});
    EXPECT_LT((wellstrat::squareToTriangle(xi, a, b, c) - middle).Length(), 1e-6f);
    EXPECT_EQ(wellstrat::squareToTriangle({0.0f, 0.0f}, a, b, c), c);
}

// Where two densities must be the same function: independent formulas, so one mends the other.
TEST(WarpDensityTest, LobesAgreeWhereTheyCoincide) {
    const Float3 up(0.0f, 0.0f, 1.0f);
    for (const float cosine : {0.01f, 0.3f, 0.8f, 1.0f}) {
        const Float3 d(std::sqrt(1.0f - cosine * cosine), 0.0f, cosine);
        const float expected = wellstrat::hemisphereCosinePdf(cosine);
        EXPECT_FLOAT_EQ(wellstrat::powerCosinePdf(cosine, 1.0f), expected);
        EXPECT_NEAR(wellstrat::ggxVisibleNormalPdf(d, up, 1.0f, 1.0f), expected, 1e-6f);
        EXPECT_FLOAT_EQ(wellstrat::powerCosinePdf(cosine, 0.0f), wellstrat::hemispherePdf());
    }
    EXPECT_FLOAT_EQ(wellstrat::conePdf(0.0f), wellstrat::hemispherePdf());
    EXPECT_FLOAT_EQ(wellstrat::conePdf(-1.0f), wellstrat::spherePdf());
}

TEST(WarpDensityTest, LobesHaveNoDensityBelowTheSurface) {
    const Float3 down(0.6f, 0.0f, -0.8f), view(0.6f, 0.0f, 0.8f), away(-0.9f, 0.0f, 0.43588989f);
    EXPECT_EQ(wellstrat::hemisphereCosinePdf(-0.5f), 0.0f);
    EXPECT_EQ(wellstrat::powerCosinePdf(-0.5f, 3.0f), 0.0f);
    EXPECT_EQ(wellstrat::ggxVisibleNormalPdf(down, view, 0.5f, 0.5f), 0.0f);
    EXPECT_EQ(wellstrat::ggxVisibleNormalPdf(away, view, 0.5f, 0.5f), 0.0f);
}

} // namespace
