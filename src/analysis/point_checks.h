// SPDX-License-Identifier: Apache-2.0
//
// What the classes of point sets check of their input. Each throws an `Error` that says what is
// wrong and what is accepted.

#pragma once

#include <cstddef>
#include <cstdio>
#include <string>

namespace wellstrat {
inline namespace stream1 {

template <class Error>
void checkDimensions(std::size_t dims, unsigned most) {
    if (dims >= 1 && dims <= most) return;
    throw Error("the number of dimensions is " + std::to_string(dims) + "; accepted are 1 to " +
                std::to_string(most));
}

template <class Error>
void checkCoordinateExists(unsigned dim, unsigned dims) {
    if (dim < dims) return;
    throw Error("coordinate " + std::to_string(dim) + " does not exist; the points have " +
                std::to_string(dims));
}

template <class Error>
void checkValue(double value, std::size_t point, unsigned dim) {
    if (value >= 0 && value < 1) return;
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    throw Error("coordinate " + std::to_string(dim) + " of point " + std::to_string(point) +
                " is " + text + "; accepted are values in [0, 1)");
}

} // namespace stream1
} // namespace wellstrat
