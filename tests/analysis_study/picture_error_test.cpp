// SPDX-License-Identifier: Apache-2.0
//
// The filter on what is known, and the errors of pictures whose errors are known.

#include "wellstrat/analysis/picture_error.h"

#include "wellstrat/camera.h"
#include "wellstrat/random_generator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace wellstrat {
namespace {

const RandomGenerator kRandom;

/// The sum of the squared weights: what is left of the variance of independent pixels.
double squaredWeights(const GaussianFilter& filter) {
    const unsigned reach = filter.border(), size = 4 * reach + 1;
    std::vector<double> picture(std::size_t{size} * size);
    picture[std::size_t{2 * reach} * size + 2 * reach] = 1;
    double sum = 0;
    for (const double weight : filter.apply(picture, size)) sum += weight * weight;
    return sum;
}

TEST(GaussianFilter, ADeltaBecomesTheGaussian) {
    for (const double sigma : {0.5, 1.0, 2.0}) {
        const GaussianFilter filter(sigma);
        EXPECT_EQ(filter.border(), static_cast<unsigned>(std::ceil(3 * sigma)));
        const unsigned reach = filter.border(), size = 4 * reach + 1, inner = 2 * reach + 1;
        std::vector<double> picture(std::size_t{size} * size);
        picture[std::size_t{2 * reach} * size + 2 * reach] = 3;
        const std::vector<double> filtered = filter.apply(picture, size);
        ASSERT_EQ(filtered.size(), std::size_t{inner} * inner);
        double sum = 0;
        for (unsigned y = 0; y < inner; ++y) {
            for (unsigned x = 0; x < inner; ++x) {
                const double dx = double(x) - reach, dy = double(y) - reach;
                const double value = filtered[std::size_t{y} * inner + x];
                EXPECT_NEAR(value / filtered[std::size_t{reach} * inner + reach],
                            std::exp(-(dx * dx + dy * dy) / (2 * sigma * sigma)), 1e-12);
                sum += value;
            }
        }
        EXPECT_NEAR(sum, 3, 1e-12);
    }
}

/// Guards against rows for columns, and against the wrong inner pixels.
TEST(GaussianFilter, InnerPixelsStayInPlace) {
    const GaussianFilter filter(1);
    const unsigned size = 11, inner = size - 2 * filter.border();
    std::vector<double> ramp;
    for (unsigned y = 0; y < size; ++y) {
        for (unsigned x = 0; x < size; ++x) ramp.push_back(x + 100.0 * y);
    }
    const std::vector<double> filtered = filter.apply(ramp, size);
    ASSERT_EQ(filtered.size(), std::size_t{inner} * inner);
    EXPECT_NEAR(filtered[1 * inner + 2], (2 + 3) + 100.0 * (1 + 3), 1e-9);
}

TEST(GaussianFilter, SigmaZeroChangesNothing) {
    const std::vector<double> picture{1, -2, 3, 4};
    EXPECT_EQ(GaussianFilter(0).apply(picture, 2), picture);
}

TEST(GaussianFilter, OtherSigmasAreRejected) {
    for (const double sigma : {-0.1, 16.1, std::nan("")}) {
        EXPECT_THROW(GaussianFilter{sigma}, std::invalid_argument) << sigma;
    }
}

std::vector<ErrorSums> errorsOf(const PixelSource& source, const char* name, unsigned size,
                                const std::vector<uint32_t>& counts, double sigma,
                                PatternRange seeds) {
    const IntegrandPicture picture = makeIntegrandPicture(name, size);
    std::vector<ErrorSums> sums(counts.size());
    addPictureErrors(source, {&picture}, counts, GaussianFilter(sigma), seeds, sums.data());
    return sums;
}

/// Independent errors of known variance leave that variance times the sum of the squared weights. A
/// step of integral V has the variance V (1 - V) / N. The band of estimateError has 1.96 standard
/// errors to each side; a test of 4.5 fails by chance in less than 1 of 100,000 cases, and the
/// pictures are fixed.
TEST(PictureErrors, WhiteNoiseIsAveragedAsIndependentNumbers) {
    constexpr unsigned kSize = 40;
    constexpr uint64_t kPictures = 30;
    const PointSourcePtr source = generatorSource(&kRandom);
    const IntegrandPicture step = makeIntegrandPicture("step", kSize);
    for (const double sigma : {0.0, 1.0, 2.0}) {
        const GaussianFilter filter(sigma);
        std::vector<double> variances;
        for (const Integrand& pixel : step.pixels) {
            variances.push_back(pixel.integral * (1 - pixel.integral));
        }
        // The variance varies slowly: the mean over the inner pixels is that of what they see, to
        // much less than the noise here.
        double variance = 0;
        const std::vector<double> inner = filter.apply(variances, kSize);
        for (const double value : inner) variance += value / double(inner.size());
        for (const uint32_t count : {1u, 4u}) {
            const ErrorSums sums = errorsOf({*source, cameraPattern}, "step", kSize, {count}, sigma,
                                            {0, kPictures})[0];
            const ErrorEstimate error = estimateError(sums, kPictures);
            const double expected = std::sqrt(variance * squaredWeights(filter) / count);
            const double standardError = std::log(error.high / error.low) / (2 * 1.96);
            EXPECT_LT(std::fabs(std::log(error.rmse / expected)), 4.5 * standardError)
                << sigma << ", " << count;
            EXPECT_LT(standardError, 0.05);
        }
    }
}

/// The padded tables are white: two sets of pictures agree, and a filter leaves of their errors
/// what it leaves of random ones'. 4.5 standard errors, as above.
TEST(PictureErrors, PaddedTablesAreWhite) {
    constexpr uint64_t kPictures = 20;
    const PointSourcePtr source = generatorSource(nullptr);
    const PixelSource pixels{*source, cameraPattern};
    const auto estimate = [&](double sigma, uint64_t first) {
        return estimateError(
            errorsOf(pixels, "edge", 52, {4}, sigma, {first, first + kPictures})[0], kPictures);
    };
    const ErrorEstimate plain = estimate(0, 0), a = estimate(2, 0), b = estimate(2, kPictures);
    const double noise = std::log(a.high / a.low) / (2 * 1.96);
    EXPECT_LT(std::fabs(std::log(a.rmse / b.rmse)), 4.5 * std::sqrt(2.0) * noise);
    // The picture without a filter has a wider border, whose errors are about as large.
    const double expected = plain.rmse * std::sqrt(squaredWeights(GaussianFilter(2)));
    EXPECT_LT(std::fabs(std::log(b.rmse / expected)), 4.5 * noise + 0.03);
}

/// A source whose only coordinate is the same for all points of a pixel: 0 in pattern 0, else 1/2.
class Chosen final : public PointSource {
public:
    void draw(uint32_t pattern, const DomainDims& /*domains*/, std::size_t count,
              double* points) const override {
        for (std::size_t i = 0; i < count; ++i) points[i] = pattern == 0 ? 0 : 0.5;
    }
};

/// Guards against patterns of other pixels, and against sums of other powers.
TEST(PictureErrors, SumsAreOfPictures) {
    const Chosen points;
    const PixelPattern patternOf = [](int x, int y, uint32_t seed) {
        return static_cast<uint32_t>(x == 1 && y == 0 && seed == 7 ? 0 : 1);
    };
    const IntegrandPicture picture = makeIntegrandPicture("exponential", 2);
    const ErrorSums sums = errorsOf({points, patternOf}, "exponential", 2, {3}, 0, {7, 8})[0];
    double mean = 0, square = 0;
    for (unsigned y = 0; y < 2; ++y) {
        for (unsigned x = 0; x < 2; ++x) {
            const double point = x == 1 && y == 0 ? 0 : 0.5;
            const double error = picture.at(x, y).value(&point) - picture.at(x, y).integral;
            mean += error / 4;
            square += error * error / 4;
        }
    }
    EXPECT_NEAR(sums.first.value(), mean, 1e-15);
    EXPECT_NEAR(sums.second.value(), square, 1e-15);
    EXPECT_NEAR(sums.fourth.value(), square * square, 1e-15);
}

TEST(PictureErrors, SplitsOfThePicturesChangeNoBit) {
    const PointSourcePtr source = generatorSource(nullptr);
    const PixelSource pixels{*source, cameraPattern};
    const std::vector<uint32_t> counts{1, 3, 4};
    std::vector<ErrorSums> whole = errorsOf(pixels, "gaussian^2", 16, counts, 1, {2, 6});
    std::vector<ErrorSums> parts = errorsOf(pixels, "gaussian^2", 16, counts, 1, {5, 6});
    const std::vector<ErrorSums> head = errorsOf(pixels, "gaussian^2", 16, counts, 1, {2, 5});
    for (std::size_t c = 0; c < counts.size(); ++c) {
        parts[c] += head[c];
        EXPECT_EQ(parts[c].second.words(), whole[c].second.words());
        EXPECT_EQ(parts[c].first.words(), whole[c].first.words());
    }
}

TEST(PictureErrors, PixelsHaveTheContextsOfTheCamera) {
    EXPECT_EQ(cameraPattern(3, -2, 9), cameraContext(3, -2, 0, 5, 9).patternid);
}

TEST(PictureErrors, BadArgumentsAreRejected) {
    const PointSourcePtr source = generatorSource(nullptr);
    const IntegrandPicture small = makeIntegrandPicture("edge", 12);
    const IntegrandPicture large = makeIntegrandPicture("edge", 13);
    const IntegrandPicture other = makeIntegrandPicture("step", 13);
    std::vector<ErrorSums> sums(4);
    const auto add = [&](const std::vector<const IntegrandPicture*>& pictures,
                         const std::vector<uint32_t>& counts) {
        addPictureErrors({*source, cameraPattern}, pictures, counts, GaussianFilter(2), {0, 1},
                         sums.data());
    };
    EXPECT_NO_THROW(add({&large}, {1}));
    EXPECT_NO_THROW(add({}, {1}));
    EXPECT_THROW(add({&small}, {1}), std::invalid_argument);
    EXPECT_THROW(add({&large, &small}, {1}), std::invalid_argument);
    EXPECT_THROW(add({&large, &other}, {1}), std::invalid_argument);
    EXPECT_THROW(add({&large}, {0}), std::invalid_argument);
    EXPECT_THROW(add({&large}, {2, 2}), std::invalid_argument);
}

} // namespace
} // namespace wellstrat
