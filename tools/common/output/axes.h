// SPDX-License-Identifier: Apache-2.0
//
// Logarithmic axes of plots, which end where the data end.

#pragma once

#include <string>

namespace wellstrat::cli {

/// What an axis has to show.
class AxisRange {
public:
    /// Numbers that a logarithmic axis has no place for do not count.
    void add(double value) {
        if (!(value > 0)) return;
        low_ = low_ == 0 || value < low_ ? value : low_;
        high_ = value > high_ ? value : high_;
    }
    /// Both are 1 where there is nothing to show.
    double low() const { return low_ > 0 ? low_ : 1; }
    double high() const { return high_ > 0 ? high_ : 1; }

private:
    double low_ = 0, high_ = 0;
};

/// Commands of gnuplot for an axis, "x" or "y", of numbers of samples: with ticks at powers of two.
std::string doublingAxis(const char* axis, const AxisRange& range);

/// The same with ticks at 1, 10, 100, ..., at 2, 5, 20, ... where these are few, and at 3, 7, 30,
/// ... where those are.
std::string decimalAxis(const char* axis, const AxisRange& range);

} // namespace wellstrat::cli
