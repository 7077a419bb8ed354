// SPDX-License-Identifier: Apache-2.0
//
// What a report comes to.

#pragma once

#include "sections.h"

#include <string>

namespace wellstrat::cli {

/// One sentence: which generator has the least error of integrals at the largest power of two
/// points that was measured, over that of random points or, without these, of the last generator.
std::string verdictOf(const ReportContents& contents);

} // namespace wellstrat::cli
