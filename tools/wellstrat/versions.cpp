// SPDX-License-Identifier: Apache-2.0

#include "versions.h"

#include "wellstrat/version.h"

#include <fmt/format.h>

namespace wellstrat::cli {

nlohmann::ordered_json versionedJson() {
    return {{"version", WELLSTRAT_VERSION_STRING}, {"stream_version", kStreamVersion}};
}

std::string versionLine() {
    return fmt::format("wellstrat {}, stream version {}", WELLSTRAT_VERSION_STRING, kStreamVersion);
}

} // namespace wellstrat::cli
