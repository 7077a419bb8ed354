// SPDX-License-Identifier: Apache-2.0
//
// Makes scenes in a process of their own, by code that is not trusted with this one.

#pragma once

#include "../scene.h"
#include "child_process.h"

#include <functional>

namespace wellstrat::render {

/// What `make` makes, in a copy of this process and within `limits`. Throws std::runtime_error with
/// one line: that of what `make` throws, or how the copy ended. Call it before starting threads.
Scene makeInChild(const std::function<Scene()>& make, const ChildLimits& limits);

} // namespace wellstrat::render
