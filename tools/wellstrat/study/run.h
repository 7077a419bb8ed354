// SPDX-License-Identifier: Apache-2.0
//
// Runs a study on all cores of all processes.

#pragma once

#include "common/ranks/ranks.h"
#include "plan.h"

#include <functional>
#include <vector>

namespace wellstrat::cli {

/// What is finished: the sums over patterns 0 to patterns - 1.
struct StudyResult {
    uint64_t patterns = 0;
    std::vector<ErrorSums> sums; ///< in the order of StudyPlan
};

/// Adds to `result` the patterns that it lacks, in rounds of a second or so. The bits of the result
/// depend neither on the rounds nor on threads and processes. After each round rank 0, whose
/// `result` alone is right, calls `save`. SIGINT or SIGTERM ends it early, without the round in
/// work; a second one ends the program.
void runStudy(const StudyPlan& plan, const Ranks& ranks, StudyResult& result,
              const std::function<void()>& save);

} // namespace wellstrat::cli
