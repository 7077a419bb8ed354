// SPDX-License-Identifier: Apache-2.0
//
// What a comparison comes to.

#pragma once

#include "result.h"

#include <string>

namespace wellstrat::cli {

/// One sentence: how much error the best generator leaves of the baseline's at the largest number
/// of samples, and how many samples of the baseline would do the same. A difference within two
/// standard errors, where these are known, is called none.
std::string verdictOf(const Comparison& comparison);

} // namespace wellstrat::cli
