// SPDX-License-Identifier: Apache-2.0
#include "bank/header.h"

#include <fmt/format.h>

#include <iterator>

namespace wellstrat::cli {
namespace {

constexpr auto kBegin = R"(// SPDX-License-Identifier: Apache-2.0
//
// The orders of the slots of joint.h. Made by `wellstrat bank`, which see for how.

#pragma once

#include "wellstrat/platform.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

/// Bits of an index for which there are columns: the slots are joint in their first 2^16 samples.
constexpr unsigned kJointBankDigits = 16;

/// Row d is the matrix U_d over GF(2) of slot d, given by its columns: column k is what bit k of an
/// index contributes to the place of the sample, bit r of a column being row r. Upper triangular
/// with a diagonal of ones. The first m columns are all that the first 2^m samples depend on.
)";

constexpr auto kEnd = R"(};

} // namespace stream1
} // namespace wellstrat
)";

static_assert(bank::kDigits == 16, "as the text above says");

} // namespace

std::string bankHeader(const std::vector<bank::Columns>& slots) {
    std::string text = kBegin;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "inline constexpr uint16_t kJointBank[{}][kJointBankDigits] = {{\n",
                   slots.size());
    for (const bank::Columns& columns : slots) {
        const auto lineEnd = columns.begin() + 12; // as clang-format has it
        fmt::format_to(out, "    {{{:#06x},\n     {:#06x}}},\n",
                       fmt::join(columns.begin(), lineEnd, ", "),
                       fmt::join(lineEnd, columns.end(), ", "));
    }
    return text + kEnd;
}

} // namespace wellstrat::cli
