// SPDX-License-Identifier: Apache-2.0
//
// What pages and pictures call things that options take by a name.

#pragma once

#include <string>

namespace wellstrat::cli {

/// "Owen-scrambled Sobol" for sobol-owen, "Stratified jointly, slots 3+7" for joint:3+7; without
/// its directory for file:PATH. What has no other name keeps its own.
std::string generatorTitle(const std::string& name);

/// "Gaussian 3D" for gaussian-3d, "Disk in 2 domains" for disk^2, "Disk times linear" for
/// disk*linear.
std::string integrandTitle(const std::string& name);

} // namespace wellstrat::cli
