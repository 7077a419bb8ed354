// SPDX-License-Identifier: Apache-2.0
//
// Integrands by name, to measure the error of samples with.
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

#include "wellstrat/analysis/integrand.h"
#include "wellstrat/platform.h"

#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

constexpr unsigned kMaxIntegrandDomains = 5;

/// The coordinates of all domains together.
WELLSTRAT_API unsigned totalDims(const DomainDims& domains);

/// All that have names, those in one dimension first.
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
