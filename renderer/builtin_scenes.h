// SPDX-License-Identifier: Apache-2.0
//
// The scenes that need no file. Each is made by a file in scenes/.

#pragma once

#include "scene.h"

#include <string>
#include <vector>

namespace wellstrat::render {

struct BuiltinSceneInfo {
    const char* name;
    const char* description; ///< one line
};

/// All built-in scenes.
const std::vector<BuiltinSceneInfo>& builtinScenes();

/// Whether there is a built-in scene of this name.
bool isBuiltinScene(const std::string& name);

/// The scene of this name, the same each time. Throws std::invalid_argument, which lists the names.
Scene builtinScene(const std::string& name);

} // namespace wellstrat::render
