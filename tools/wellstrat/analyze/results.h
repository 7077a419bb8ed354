// SPDX-License-Identifier: Apache-2.0
//
// Measures as text and as JSON.

#pragma once

#include "measures.h"

#include <cstddef>
#include <optional>
#include <string>

namespace wellstrat::cli {

/// `subject` names what was measured.
std::string measuresText(const Measures& measures, const std::string& subject);
std::string measuresJson(const Measures& measures, const std::string& subject);

/// Coordinate `dim` of a stream of points in `dims` dimensions, such as "pattern 3 x".
std::string coordinateName(const FamilyIndependence& family, std::size_t stream, unsigned dim,
                           unsigned dims);

/// The minimum distance on the torus as a share of the largest possible one; only where that is
/// known.
std::optional<double> packing(const Measures& measures);

} // namespace wellstrat::cli
