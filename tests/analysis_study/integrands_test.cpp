// SPDX-License-Identifier: Apache-2.0
//
// The integrands: every integral against quadrature, and the names.

#include "quadrature.h"
#include "wellstrat/analysis/integrands.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <vector>

namespace wellstrat {
namespace {

/// How finely each axis is cut, and how far the result may then be off, for 1 to 4 dimensions.
struct Accuracy {
    unsigned cells;
    double tolerance;
};
constexpr Accuracy kAccuracies[]{{0, 0}, {100, 1e-9}, {50, 3e-5}, {24, 1e-4}, {8, 2e-4}};

/// Any angles, but only waves, cells and boxes that are not finer than the quadrature.
std::vector<std::string> membersOf(const IntegrandFamily& family) {
    if (!family.hasParameter) return {family.name};
    std::vector<std::string> members;
    for (const unsigned parameter : {0u, 1u, 2u, 3u, 7u, 45u, 90u, 91u, 180u, 270u, 300u}) {
        const unsigned last = family.name == "edge-A" ? family.last : 3;
        if (parameter < family.first || parameter > last) continue;
        members.push_back(family.name.substr(0, family.name.size() - 1) +
                          std::to_string(parameter));
    }
    return members;
}

/// Guards against a wrong constant or sign in any of the closed forms.
TEST(Integrands, IntegralsAgreeWithQuadrature) {
    unsigned checked = 0;
    for (const IntegrandFamily& family : integrandFamilies()) {
        for (const std::string& name : membersOf(family)) {
            const Integrand integrand = makeIntegrand(name);
            EXPECT_EQ(integrand.domains, family.domains) << name;
            const auto [cells, tolerance] = kAccuracies[totalDims(family.domains)];
            std::vector<double> point(totalDims(family.domains));
            EXPECT_NEAR(integrand.integral, integrate(integrand.value, cells, point), tolerance)
                << name;
            ++checked;
        }
    }
    EXPECT_GT(checked, 50u);
}

TEST(Integrands, ClassicIntegralsAreThePublishedOnes) {
    EXPECT_EQ(makeIntegrand("disk").integral, 0.5);
    EXPECT_EQ(makeIntegrand("triangle").integral, 0.5);
    EXPECT_NEAR(makeIntegrand("step").integral, 0.318310, 1e-6);
    EXPECT_NEAR(makeIntegrand("gaussian").integral, 0.557746, 1e-6);
    EXPECT_EQ(makeIntegrand("bilinear").integral, 0.25);
}

TEST(Integrands, ProductsMultiplyOverDomainsOfTheirOwn) {
    const Integrand product = makeIntegrand("bilinear^2*linear*trilinear");
    EXPECT_EQ(product.domains, (DomainDims{2, 2, 1, 3}));
    EXPECT_EQ(product.integral, 0.25 * 0.25 * 0.5 * 0.125);
    const double point[]{0.5, 0.25, 0.75, 0.5, 0.125, 0.5, 0.5, 0.25};
    EXPECT_EQ(product.value(point), 0.125 * 0.375 * 0.125 * 0.0625);
    EXPECT_EQ(makeIntegrand("soft-shadow*linear^1").domains, (DomainDims{2, 2, 1}));
}

TEST(Integrands, UnknownNamesAreRejected) {
    for (const char* name : {"",
                             "dis",
                             "disk2",
                             "Disk",
                             "disk ",
                             "edge",
                             "edge-",
                             "edge-360",
                             "edge--1",
                             "edge-07",
                             "edge-1.5",
                             "edge-A",
                             "sine-0",
                             "sine-1025",
                             "box-1000000",
                             "box-9999999999",
                             "disk^0",
                             "disk^6",
                             "disk^",
                             "^2",
                             "disk^2^2",
                             "disk*",
                             "*disk",
                             "disk**step",
                             "disk^3*step^3",
                             "soft-shadow^3",
                             "disk^-1"}) {
        EXPECT_THROW(makeIntegrand(name), std::invalid_argument) << name;
    }
}

TEST(Integrands, GroupsNameIntegrands) {
    std::set<std::string> names;
    for (const IntegrandGroup& group : integrandGroups()) {
        EXPECT_TRUE(names.insert(group.name).second) << group.name;
        EXPECT_THROW(makeIntegrand(group.name), std::invalid_argument) << group.name;
        EXPECT_FALSE(group.members.empty());
        for (const std::string& member : group.members) {
            EXPECT_NO_THROW(makeIntegrand(member)) << member;
        }
    }
}

} // namespace
} // namespace wellstrat
