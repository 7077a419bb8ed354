// SPDX-License-Identifier: Apache-2.0
//
// How much the statistical tests do.

#pragma once

#include <cstdlib>
#include <cstring>

namespace statistical {

/// Whether WELLSTRAT_NIGHTLY=1 asks for the long variants.
inline bool nightly() {
    const char* value = std::getenv("WELLSTRAT_NIGHTLY");
    return value != nullptr && std::strcmp(value, "1") == 0;
}

} // namespace statistical
