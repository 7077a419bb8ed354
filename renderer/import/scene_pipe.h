// SPDX-License-Identifier: Apache-2.0
//
// Scenes through pipes, from one process to a copy of it.

#pragma once

#include "../scene.h"

#include <string>

namespace wellstrat::render {

/// Writes a scene to a pipe. Throws std::runtime_error if the other end is closed.
void sendScene(const Scene& scene, int pipe);

/// Writes instead why there is no scene.
void sendFailure(const std::string& reason, int pipe);

/// Reads what one of them wrote, to the end. Throws std::runtime_error with the reason of a
/// failure, or if the pipe ends early.
Scene receiveScene(int pipe);

} // namespace wellstrat::render
