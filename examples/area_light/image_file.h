// SPDX-License-Identifier: Apache-2.0
//
// Writes images as PNG files.

#pragma once

#include "integrator.h"

#include <string>

namespace area_light {

/// Writes images of size x size pixels side by side, 8 bits in sRGB. The file appears complete or
/// not at all. Throws std::runtime_error if it cannot be written.
void writePng(const std::string& path, unsigned size, const std::vector<const Image*>& images);

} // namespace area_light
