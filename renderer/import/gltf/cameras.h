// SPDX-License-Identifier: Apache-2.0
//
// The cameras of glTF.

#pragma once

#include "../../scene.h"
#include "../notes.h"
#include "nodes.h"

#include <vector>

namespace wellstrat::render {

/// The cameras of a scene, each of the name of its node, or of its own if that has none. Those that
/// cannot be used are left out, with a note.
std::vector<NamedCamera> importCameras(const GltfDocument& document,
                                       const std::vector<GltfInstance>& cameras, Notes& notes);

} // namespace wellstrat::render
