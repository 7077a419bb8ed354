// SPDX-License-Identifier: Apache-2.0
//
// How plots tell curves, such as those of several generators, apart.

#pragma once

#include <cstddef>
#include <string>

namespace wellstrat::cli {

/// The legend stands below the axes, where no curve can be.
constexpr auto kLegendBelow = "set key below samplen 2 spacing 1 height 1 noenhanced\n";

/// The color of curve `place` of a plot as gnuplot takes it, such as "0x4477aa".
std::string curveColor(std::size_t place);

/// Its dash type and color as a style of gnuplot. Dashes show curves that lie on each other.
std::string curveStyle(std::size_t place);

/// A name without what means something to gnuplot, between single or double quotes.
std::string plainName(const std::string& name);

} // namespace wellstrat::cli
