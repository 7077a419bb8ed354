// SPDX-License-Identifier: Apache-2.0

#include "versions.h"

#include "wellstrat/version.h"

#include <fmt/format.h>

namespace wellstrat::cli {

nlohmann::ordered_json versionedJson() {
    return {{"version", WELLSTRAT_VERSION_STRING}, {"stream_version", kStreamVersion}};
}

std::string versionLine(std::string_view program) {
    return fmt::format("{} {}, stream version {}", program, WELLSTRAT_VERSION_STRING,
                       kStreamVersion);
}

} // namespace wellstrat::cli
