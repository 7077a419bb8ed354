// SPDX-License-Identifier: Apache-2.0
//
// The integrands over given domains, before products are made of them.

#pragma once

#include "wellstrat/analysis/integrand.h"

#include <functional>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// A function and its integral.
struct IntegrandShape {
    double integral;
    std::function<double(const double*)> value;
};

/// 1 where weights . x < bound, else 0, for up to 8 coordinates.
IntegrandShape halfSpaceShape(const std::vector<double>& weights, double bound);

/// A family and the way to its members; the parameter is ignored if the family has none.
struct IntegrandRecipe {
    IntegrandFamily family;
    std::function<IntegrandShape(unsigned parameter)> make;
};

/// All of them, in the order in which they are listed.
const std::vector<IntegrandRecipe>& integrandRecipes();

} // namespace stream1
} // namespace wellstrat
