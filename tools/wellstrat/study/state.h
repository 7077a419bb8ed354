// SPDX-License-Identifier: Apache-2.0
//
// The file that a study goes on from: what was planned, and the exact sums so far.

#pragma once

#include "run.h"

#include <string>

namespace wellstrat::cli {

/// Replaces the file `path`. Throws CliError if that fails.
void saveState(const std::string& path, const StudyPlan& plan, const StudyResult& result);

/// Whether the study whose state is in the file `path` has all the patterns that were planned;
/// false if the file is damaged.
bool isFinished(const std::string& path);

/// What saveState has written. Throws CliError for a file that is damaged, or of a study with other
/// generators, integrands, counts or versions, or with more patterns than `plan`.
StudyResult loadState(const std::string& path, const StudyPlan& plan);

} // namespace wellstrat::cli
