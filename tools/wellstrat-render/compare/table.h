// SPDX-License-Identifier: Apache-2.0
//
// What wellstrat compare prints.

#pragma once

#include "result.h"

#include <string>

namespace wellstrat::cli {

/// A line for each image and, of several generators, the errors relative to those of the baseline.
std::string compareTable(const Comparison& comparison);

} // namespace wellstrat::cli
