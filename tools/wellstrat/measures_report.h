// SPDX-License-Identifier: Apache-2.0
//
// Measures as text and as JSON.

#pragma once

#include "measures.h"

#include <string>

namespace wellstrat::cli {

/// `subject` names what was measured.
std::string measuresText(const Measures& measures, const std::string& subject);
std::string measuresJson(const Measures& measures, const std::string& subject);

} // namespace wellstrat::cli
