// SPDX-License-Identifier: Apache-2.0
//
// Where scene files say that their parts are.

#pragma once

#include <optional>
#include <string>

namespace wellstrat::render {

/// With %20 and the like replaced by the bytes that they stand for: RFC 3986, section 2.1.
std::string percentDecoded(const std::string& uri);

/// The data of a "data:" URI of RFC 2397.
struct DataUri {
    std::string mediaType; ///< such as "image/png"; empty if it does not say
    std::string bytes;
};

/// None if `uri` does not begin with "data:". Throws std::runtime_error if it does, but has no
/// comma or is no base64 where it says so.
std::optional<DataUri> dataOf(const std::string& uri);

} // namespace wellstrat::render
