// SPDX-License-Identifier: Apache-2.0

#include "axes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr double kMostTicks = 8;
constexpr std::size_t kFewestTicks = 3;

using Digits = std::vector<int>;

/// "0.05", or "5·10^{-6}" where that has many zeros.
std::string tickLabel(int digit, int exponent) {
    if (exponent >= -3 && exponent <= 4) return fmt::format("{:g}", digit * std::pow(10, exponent));
    return digit == 1 ? fmt::format("10^{{{}}}", exponent)
                      : fmt::format("{}\u00b710^{{{}}}", digit, exponent);
}

/// Those of these digits times powers of ten that are in the range of so many decades.
std::vector<std::string> decimalTicks(const AxisRange& range, double decades,
                                      const Digits& digits) {
    const int step = static_cast<int>(std::ceil((decades + 1) / kMostTicks));
    std::vector<std::string> ticks;
    const int first = static_cast<int>(std::floor(std::log10(range.low())));
    for (int exponent = first; exponent <= std::log10(range.high()); exponent += step) {
        for (const int digit : digits) {
            const double tick = digit * std::pow(10, exponent);
            const bool isInside =
                tick > range.low() * (1 - 1e-9) && tick < range.high() * (1 + 1e-9);
            if (isInside)
                ticks.push_back(fmt::format("'{}' {:.9g}", tickLabel(digit, exponent), tick));
        }
    }
    return ticks;
}

std::string commandOf(const char* axis, const AxisRange& range,
                      const std::vector<std::string>& ticks) {
    // A range of one number is none for gnuplot.
    const double room = range.low() < range.high() ? 1 : 1.25;
    return fmt::format("set logscale {0}\nset {0}range [{1:.9g}:{2:.9g}]\nset {0}tics ({3})\n",
                       axis, range.low() / room, range.high() * room, fmt::join(ticks, ", "));
}

} // namespace

std::string doublingAxis(const char* axis, const AxisRange& range) {
    const int first = static_cast<int>(std::ceil(std::log2(range.low())));
    const int last = static_cast<int>(std::floor(std::log2(range.high())));
    const int step = static_cast<int>(std::ceil((last - first + 1) / kMostTicks));
    std::vector<std::string> ticks;
    for (int power = first; power <= last; power += step) {
        ticks.push_back(fmt::format("{:.0f}", std::exp2(power)));
    }
    return commandOf(axis, range, ticks);
}

std::string decimalAxis(const char* axis, const AxisRange& range) {
    const double decades = std::log10(range.high() / range.low());
    std::vector<std::string> ticks;
    if (decades > 2.5) return commandOf(axis, range, decimalTicks(range, decades, {1}));
    for (const auto& digits : {Digits{1, 2, 5}, Digits{1, 2, 3, 5, 7}}) {
        ticks = decimalTicks(range, decades, digits);
        if (ticks.size() >= kFewestTicks) break;
    }
    return commandOf(axis, range, ticks);
}

} // namespace wellstrat::cli
