// SPDX-License-Identifier: Apache-2.0
//
// What wellstrat compare shows.

#pragma once

#include "common/output/html_page.h"
#include "result.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

/// The plots, none if there are no errors.
struct ComparePictures {
    std::vector<HtmlPicture> errors, spectra;
};

/// The page. `command` is what makes it again.
std::string comparePage(const Comparison& comparison, const ComparePictures& pictures,
                        const std::string& command);

} // namespace wellstrat::cli
