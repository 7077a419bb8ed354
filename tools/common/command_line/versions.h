// SPDX-License-Identifier: Apache-2.0
//
// The versions as every machine-readable output of the tool states them.

#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace wellstrat::cli {

/// An object that keeps the order of its members, with "version" and "stream_version" set.
nlohmann::ordered_json versionedJson();

/// "wellstrat 1.2.3, stream version 1".
std::string versionLine(std::string_view program = "wellstrat");

} // namespace wellstrat::cli
