// SPDX-License-Identifier: Apache-2.0
//
// What wellstrat compare shows.

#pragma once

#include "result.h"

#include <string>

namespace wellstrat::cli {

/// The bytes of the plots, empty if there are no errors.
struct CompareFigures {
    std::string errors, spectra;
};

/// The page. `command` is what makes it again.
std::string comparePage(const Comparison& comparison, const CompareFigures& figures,
                        const std::string& command);

} // namespace wellstrat::cli
