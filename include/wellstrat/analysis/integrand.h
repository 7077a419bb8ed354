// SPDX-License-Identifier: Apache-2.0
//
// A function on the unit cube whose integral is known. integrands.h names some.

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

} // namespace stream1
} // namespace wellstrat
