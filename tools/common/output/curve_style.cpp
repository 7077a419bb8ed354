// SPDX-License-Identifier: Apache-2.0

#include "curve_style.h"

#include <fmt/format.h>

#include <iterator>

namespace wellstrat::cli {
namespace {

constexpr std::size_t kDashTypes = 5;

/// Paul Tol's bright qualitative scheme, https://personal.sron.nl/~pault/
constexpr unsigned kColors[]{0x4477aa, 0xee6677, 0x228833, 0xccbb44, 0x66ccee, 0xaa3377, 0xbbbbbb};

} // namespace

std::string curveColor(std::size_t place) {
    return fmt::format("0x{:06x}", kColors[place % std::size(kColors)]);
}

std::string curveStyle(std::size_t place) {
    return fmt::format("dt {} lc rgb {}", place % kDashTypes + 1, curveColor(place));
}

std::string plainName(const std::string& name) {
    std::string plain;
    for (const char c : name) {
        const bool accepted = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                              (c >= '0' && c <= '9') ||
                              std::string("+-*/^.:,_ ()").find(c) != std::string::npos;
        plain += accepted ? c : '?';
    }
    return plain;
}

} // namespace wellstrat::cli
