// SPDX-License-Identifier: Apache-2.0
//
// Commands that are shown to be run again.

#pragma once

#include <string>

namespace wellstrat::cli {

/// `text` as a shell takes it for one word: quoted if need be.
std::string shellWord(const std::string& text);

} // namespace wellstrat::cli
