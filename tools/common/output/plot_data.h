// SPDX-License-Identifier: Apache-2.0
//
// The data file of a plot.

#pragma once

#include "lines.h"

#include <cstddef>

namespace wellstrat::cli {

/// Named sets of lines, with two blank lines between them as gnuplot wants.
class PlotData : public Lines {
public:
    void begin(const char* set, size_t number) {
        line("{}# {}{}", text_.empty() ? "" : "\n\n", set, number);
    }
};

} // namespace wellstrat::cli
