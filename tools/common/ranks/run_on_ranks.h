// SPDX-License-Identifier: Apache-2.0
//
// How a command runs in all processes at once, and fails as one.

#pragma once

#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "ranks.h"

#include <exception>
#include <optional>

namespace wellstrat::cli {

/// Runs run(ranks, job) on what prepare(ranks) returns, in all processes. If some cannot prepare,
/// none runs, and what all find wrong rank 0 says for all. An error while it runs ends all.
template <typename Prepare, typename Run>
int runOnRanks(Prepare&& prepare, Run&& run) {
    const Ranks ranks;
    std::optional<decltype(prepare(ranks))> job;
    std::exception_ptr failure;
    try {
        job.emplace(prepare(ranks));
    } catch (...) {
        failure = std::current_exception();
    }
    if (ranks.any(failure != nullptr)) {
        const bool rootFailed = ranks.fromRoot(failure != nullptr ? 1 : 0) != 0;
        const bool says = failure && (ranks.isRoot() || !rootFailed);
        if (says) exitCodeOf([&]() -> int { std::rethrow_exception(failure); });
        ranks.any(false); // until it is said: the first process to leave in error ends the others
        return kExitError;
    }
    try {
        return run(ranks, *job);
    } catch (const std::exception& error) {
        if (ranks.size() == 1) throw;
        sayText(messageOf(error));
        ranks.abort(kExitError);
        return kExitError;
    }
}

} // namespace wellstrat::cli
