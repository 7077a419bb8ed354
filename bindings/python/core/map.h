// SPDX-License-Identifier: Apache-2.0
//
// The warps of the unit square, as functions of rows of floats.

#pragma once

#include <cstddef>

namespace python {

/// A warp, its inverse or its density.
struct Map {
    const char* name;
    unsigned inputs, outputs;                   ///< floats of a row
    void (*apply)(const float* in, float* out); ///< maps one row
};

/// The map of this name, or null if there is none.
const Map* findMap(const char* name);

} // namespace python
