// SPDX-License-Identifier: Apache-2.0
//
// Tells scenes apart, so that images of different ones are not mixed up.

#pragma once

#include "scene.h"

#include <string>

namespace wellstrat::render {

/// 16 hexadecimal digits that change with everything in the scene that can change an image: all
/// but the names of its files, its notes, its aspect, and the cameras that were not chosen. A hash
/// of 64 bits, against mistakes and not against malice.
std::string sceneFingerprint(const Scene& scene);

} // namespace wellstrat::render
