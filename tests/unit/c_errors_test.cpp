// SPDX-License-Identifier: Apache-2.0
//
// The interface in C says what is wrong with bad input, in the thread that gave it, and writes
// nothing.

#include "wellstrat/analysis/c.h"
#include "wellstrat/analysis/discrepancy.h"
#include "wellstrat/c.h"
#include "wellstrat/hash.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace wellstrat::test {
namespace {

constexpr wellstrat_domain kCamera = {WELLSTRAT_JOINT, WELLSTRAT_NO_SLOT, 1};
constexpr std::size_t kHuge = std::numeric_limits<std::size_t>::max(); // -1 of other languages

class CErrors : public testing::Test {
protected:
    wellstrat_context contexts[4] = {};
    wellstrat_domain child = kCanary;
    wellstrat_context children[4] = {{77, 77}, {77, 77}, {77, 77}, {77, 77}};
    float xi[12] = {7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7};
    uint32_t words[12] = {7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7};

    void TearDown() override {
        EXPECT_EQ(std::memcmp(&child, &kCanary, sizeof child), 0);
        for (const wellstrat_context& context : children) EXPECT_EQ(context.patternid, 77u);
        for (const float value : xi) EXPECT_EQ(value, 7.0f);
        for (const uint32_t word : words) EXPECT_EQ(word, 7u);
    }

    static void expectInvalid(int status, const std::string& text) {
        EXPECT_EQ(status, WELLSTRAT_INVALID);
        EXPECT_EQ(wellstrat_last_error(), text);
    }

private:
    static constexpr wellstrat_domain kCanary = {77, 7, 7};
};

TEST_F(CErrors, NullPointers) {
    expectInvalid(wellstrat_camera_domain(WELLSTRAT_BLUE, nullptr),
                  "wellstrat_camera_domain: domain is null; it must point to a value");
    expectInvalid(wellstrat_draw_sample_2d(kCamera, contexts[0], nullptr),
                  "wellstrat_draw_sample_2d: xi is null; it must point to a value");
    expectInvalid(wellstrat_draw_samples_2d(kCamera, 4, nullptr, xi),
                  "wellstrat_draw_samples_2d: contexts is null; it must be an array for n = 4");
    expectInvalid(wellstrat_draw_samples_3d(kCamera, 4, contexts, nullptr),
                  "wellstrat_draw_samples_3d: xis is null; it must be an array for n = 4");
    expectInvalid(wellstrat_draw_words({WELLSTRAT_LONG, 0, 1}, 4, contexts, nullptr),
                  "wellstrat_draw_words: words is null; it must be an array for n = 4");
    expectInvalid(wellstrat_new_domains(kCamera, 5, 4, contexts, nullptr, children),
                  "wellstrat_new_domains: child is null; it must point to a value");
    expectInvalid(wellstrat_new_domains_split(kCamera, 5, 2, 4, nullptr, &child, children),
                  "wellstrat_new_domains_split: parents is null; it must be an array for n = 4");
    expectInvalid(wellstrat_new_domain_distrib(kCamera, 5, 0, contexts[0], &child, nullptr),
                  "wellstrat_new_domain_distrib: newcontext is null; it must point to a value");
    uint32_t chosen = 0;
    EXPECT_EQ(wellstrat_choose_of_two_and_remap(0.5f, nullptr, &chosen), WELLSTRAT_INVALID);
    EXPECT_EQ(wellstrat_choose_of_two_and_remap(0.5f, xi, nullptr), WELLSTRAT_INVALID);
    EXPECT_EQ(wellstrat_choose_and_remap(nullptr, 3, xi, &chosen, nullptr), WELLSTRAT_INVALID);
    EXPECT_EQ(wellstrat_choose_and_remap(xi + 1, 3, xi, nullptr, nullptr), WELLSTRAT_INVALID);
}

TEST_F(CErrors, DomainsThatNobodyDerives) {
    expectInvalid(
        wellstrat_camera_domain(5, &child),
        "wellstrat_camera_domain: generator 5 does not exist; accepted are 0 (pmj) to 4 (random)");
    expectInvalid(wellstrat_draw_samples_1d({77, 16, 1}, 0, nullptr, nullptr),
                  "wellstrat_draw_samples_1d: generator 77 does not exist; accepted are 0 (pmj) to "
                  "4 (random)");
    expectInvalid(
        wellstrat_draw_samples_2d({WELLSTRAT_LONG, 17, 1}, 4, contexts, xi),
        "wellstrat_draw_samples_2d: slot 17 does not exist; accepted are 0 to 15, and 16 for none");
    expectInvalid(wellstrat_draw_sample_3d({WELLSTRAT_BLUE, 3, 0}, contexts[0], xi),
                  "wellstrat_draw_sample_3d: the splits of the domain are 0; accepted are 1 to 256 "
                  "in a slot");
    expectInvalid(wellstrat_new_domains({WELLSTRAT_PMJ, 16, 257}, 5, 4, contexts, &child, children),
                  "wellstrat_new_domains: the splits of the domain are 257; accepted are 0 to 256 "
                  "without a slot");
    for (const uint32_t generator : {WELLSTRAT_PMJ, WELLSTRAT_JOINT, WELLSTRAT_RANDOM}) {
        EXPECT_EQ(wellstrat_draw_words({generator, 16, 1}, 4, contexts, words), WELLSTRAT_INVALID);
    }
    EXPECT_STREQ(wellstrat_last_error(),
                 "wellstrat_draw_words: samples of generator 4 have 24 bits; accepted are 2 (long) "
                 "and 3 (blue)");
}

TEST_F(CErrors, StructsOfZerosAreNoDomains) {
    const wellstrat_domain zeros{}; // a slot under no splits
    expectInvalid(
        wellstrat_new_domain(zeros, 5, contexts[0], &child, children),
        "wellstrat_new_domain: the splits of the domain are 0; accepted are 1 to 256 in a "
        "slot");
    if (HasFailure()) return; // or the draw would end the program
    EXPECT_EQ(wellstrat_draw_sample_1d(zeros, contexts[0], xi), WELLSTRAT_INVALID);
}

TEST_F(CErrors, CountsThatOverflow) {
    const std::string text = "n is " + std::to_string(kHuge) + "; accepted are 0 to 4294967295";
    expectInvalid(wellstrat_draw_samples_1d(kCamera, kHuge, contexts, xi),
                  "wellstrat_draw_samples_1d: " + text);
    for (const std::size_t n : {kHuge, kHuge / 12 + 1, std::size_t{1} << 32}) {
        EXPECT_EQ(wellstrat_draw_samples_2d(kCamera, n, contexts, xi), WELLSTRAT_INVALID);
        EXPECT_EQ(wellstrat_draw_samples_3d(kCamera, n, contexts, xi), WELLSTRAT_INVALID);
        EXPECT_EQ(wellstrat_draw_words({WELLSTRAT_BLUE, 16, 1}, n, contexts, words),
                  WELLSTRAT_INVALID);
        EXPECT_EQ(wellstrat_new_domains(kCamera, 5, n, contexts, &child, children),
                  WELLSTRAT_INVALID);
        EXPECT_EQ(wellstrat_new_domains_split(kCamera, 5, 2, n, contexts, &child, children),
                  WELLSTRAT_INVALID);
        EXPECT_EQ(wellstrat_new_domains_distrib(kCamera, 5, 0, n, contexts, &child, children),
                  WELLSTRAT_INVALID);
        uint32_t chosen = 0;
        EXPECT_EQ(wellstrat_choose_and_remap(xi + 1, n, xi, &chosen, nullptr), WELLSTRAT_INVALID);
    }
}

TEST(CLastError, IsOfTheThread) {
    ASSERT_EQ(wellstrat_camera_domain(99, nullptr), WELLSTRAT_INVALID);
    const std::string here = wellstrat_last_error();
    std::string before = "?", there;
    std::thread([&] {
        before = wellstrat_last_error();
        wellstrat_draw_sample_1d({98, 0, 1}, {0, 0}, nullptr);
        there = wellstrat_last_error();
    }).join();
    EXPECT_EQ(before, "");
    EXPECT_NE(there.find("generator 98"), std::string::npos);
    EXPECT_EQ(wellstrat_last_error(), here);
    wellstrat_domain domain{};
    ASSERT_EQ(wellstrat_camera_domain(WELLSTRAT_PMJ, &domain), WELLSTRAT_OK);
    EXPECT_EQ(wellstrat_last_error(), here); // as successes leave it
}

TEST(CDiscrepancy, IsTheLibrarys) {
    constexpr unsigned kPoints = 50;
    std::vector<double> points(kPoints * 4);
    for (unsigned i = 0; i < points.size(); ++i) points[i] = hashPair(i, 3) * 0x1p-32;
    for (const unsigned dims : {1u, 2u, 3u, 4u}) {
        const UnitPoints set(points.data(), kPoints, dims);
        for (const L2Kind kind : {L2Kind::star, L2Kind::centered, L2Kind::wrapAround,
                                  L2Kind::mixture, L2Kind::modified}) {
            double discrepancy = 0;
            ASSERT_EQ(wellstrat_l2_discrepancy(static_cast<uint32_t>(kind), points.data(), kPoints,
                                               dims, &discrepancy),
                      WELLSTRAT_OK);
            EXPECT_EQ(discrepancy, l2Discrepancy(set, kind));
        }
    }
}

TEST(CDiscrepancy, RefusesWhatIsNoPointSet) {
    const double points[] = {0.5, 0.25, 0.5, 1.0};
    const double nan[] = {std::numeric_limits<double>::quiet_NaN()};
    double discrepancy = 7;
    const auto expectText = [](int status, const std::string& text) {
        EXPECT_EQ(status, WELLSTRAT_INVALID);
        EXPECT_EQ(wellstrat_last_error(), "wellstrat_l2_discrepancy: " + text);
    };
    expectText(wellstrat_l2_discrepancy(5, points, 2, 2, &discrepancy),
               "kind 5 does not exist; accepted are 0 (star) to 4 (modified)");
    expectText(wellstrat_l2_discrepancy(WELLSTRAT_L2_STAR, points, 2, 2, &discrepancy),
               "coordinate 1 of point 1 is 1; accepted are values in [0, 1)");
    expectText(wellstrat_l2_discrepancy(WELLSTRAT_L2_STAR, nan, 1, 1, &discrepancy),
               "coordinate 0 of point 0 is nan; accepted are values in [0, 1)");
    expectText(wellstrat_l2_discrepancy(WELLSTRAT_L2_STAR, points, 0, 2, &discrepancy),
               "there are no points; accepted are one or more");
    expectText(wellstrat_l2_discrepancy(WELLSTRAT_L2_STAR, points, 1, 65, &discrepancy),
               "the number of dimensions is 65; accepted are 1 to 64");
    expectText(wellstrat_l2_discrepancy(WELLSTRAT_L2_STAR, points, kHuge, 1, &discrepancy),
               "n is 18446744073709551615; accepted are 1 to 36028797018963967");
    expectText(wellstrat_l2_discrepancy(WELLSTRAT_L2_STAR, nullptr, 2, 1, &discrepancy),
               "points is null; it must be an array for n = 2");
    expectText(wellstrat_l2_discrepancy(WELLSTRAT_L2_STAR, points, 2, 1, nullptr),
               "discrepancy is null; it must point to a value");
    EXPECT_EQ(discrepancy, 7);
}

} // namespace
} // namespace wellstrat::test
