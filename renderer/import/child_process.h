// SPDX-License-Identifier: Apache-2.0
//
// Runs code that may crash where a crash does no harm.

#pragma once

#include <cstdint>
#include <functional>

namespace wellstrat::render {

/// What a copy of this process may use.
struct ChildLimits {
    unsigned cpuSeconds; ///< of processor time, and half of the time that may pass
    uint64_t memory;     ///< in bytes, beside what this process has; UINT64_MAX: any amount
};

/// Runs `write` in a copy of this process with the writing end of a pipe, while `read` gets the
/// reading end here. The copy prints nothing, and ends when `write` returns or throws. Where it
/// asks for more memory than `limits` has, it gets none: std::bad_alloc in C++. Afterwards throws
/// std::runtime_error with one line if the copy crashed, was killed, or took too long; otherwise
/// what `read` threw, if it did.
///
/// The copy has only the calling thread. Not to be used while other threads hold locks that `write`
/// needs; call it before starting threads.
void runInChild(const std::function<void(int pipe)>& write,
                const std::function<void(int pipe)>& read, const ChildLimits& limits);

} // namespace wellstrat::render
