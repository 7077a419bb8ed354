// SPDX-License-Identifier: Apache-2.0
//
// Functions on the unit cube whose integrals are known, to measure the error of samples with.
//
//     const Integrand disk = makeIntegrand("disk");
//     disk.value(point) ... disk.integral          // 0.5
//     makeIntegrand("edge-30");                     // of a family, with its parameter
//     makeIntegrand("disk^2*linear");               // a product over three domains
//
// Names and formulas: integrandFamilies(). disk, triangle, step, gaussian and bilinear are those of
// Christensen, Kensler and Kilpatrick 2018, "Progressive Multi-Jittered Sample Sequences", section
// 2.

#pragma once

#include "wellstrat/platform.h"

#include <functional>
#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// The dimensions, each 1, 2 or 3, of the domains that a sample draws from: {2} is one 2D draw,
/// {2, 1} a 2D draw and a 1D draw from another domain.
using DomainDims = std::vector<unsigned>;

constexpr unsigned kMaxIntegrandDomains = 5;

/// The coordinates of all domains together.
WELLSTRAT_API unsigned totalDims(const DomainDims& domains);

/// A function on [0,1)^s, s = totalDims(domains).
struct Integrand {
    std::string name;
    DomainDims domains;
    double integral; ///< exact, rounded to double
    /// The value at point[0, s), the coordinates of one domain after those of another. Pure; safe
    /// in any thread.
    std::function<double(const double* point)> value;
};

/// A named integrand, or many that differ in a parameter, a whole number.
struct IntegrandFamily {
    std::string name;    ///< "disk"; with a parameter "edge-A", where A stands for the number
    DomainDims domains;  ///< the same for the whole family
    std::string formula; ///< the value, for example "1 if x < y, else 0"
    bool hasParameter;
    unsigned first, last; ///< the accepted parameters, both included
};

/// All of them, those in one dimension first.
WELLSTRAT_API std::vector<IntegrandFamily> integrandFamilies();

/// The integrand called `name`: one of integrandFamilies(), or a product of such, written with '*'
/// between factors and '^' for powers, over up to kMaxIntegrandDomains domains. Each factor has its
/// own domains. Throws std::invalid_argument, which says what is accepted, for any other name.
WELLSTRAT_API Integrand makeIntegrand(const std::string& name);

/// Names that stand for several integrands: "classic", "edges", ... with what they stand for.
struct IntegrandGroup {
    std::string name;
    std::vector<std::string> members;
};
WELLSTRAT_API std::vector<IntegrandGroup> integrandGroups();

} // namespace stream1
} // namespace wellstrat
