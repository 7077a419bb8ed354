// SPDX-License-Identifier: Apache-2.0
//
// Bytes into open files, by their descriptors.

#pragma once

#include <string_view>

namespace wellstrat::cli {

/// Writes all bytes to the open file `descriptor`. False, with errno, if that fails.
bool writeAll(int descriptor, std::string_view bytes);

} // namespace wellstrat::cli
