// SPDX-License-Identifier: Apache-2.0
//
// Long runs that end early when asked to.

#pragma once

#include <atomic>

namespace wellstrat::cli {

constexpr int kExitInterrupted = 130; ///< as shells say of Ctrl-C

/// While it exists, the first SIGINT, SIGTERM or SIGHUP sets `interrupted`; the next does what it
/// did before. One that is ignored, as under nohup, stays so. One guard at a time.
class InterruptGuard {
public:
    InterruptGuard();
    ~InterruptGuard();
    InterruptGuard(const InterruptGuard&) = delete;
    InterruptGuard& operator=(const InterruptGuard&) = delete;

    static std::atomic<bool> interrupted;
};

} // namespace wellstrat::cli
