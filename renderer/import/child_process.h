// SPDX-License-Identifier: Apache-2.0
//
// Runs code that may crash where a crash does no harm.

#pragma once

#include <functional>

namespace wellstrat::render {

/// Runs `write` in a copy of this process with the writing end of a pipe, while `read` gets the
/// reading end here. The copy prints nothing, and ends when `write` returns or throws. Afterwards
/// throws std::runtime_error with one line if the copy crashed, was killed, or took more than
/// `cpuSeconds` of processor time or twice as long; otherwise what `read` threw, if it did.
///
/// The copy has only the calling thread. Not to be used while other threads hold locks that `write`
/// needs; call it before starting threads.
void runInChild(const std::function<void(int pipe)>& write,
                const std::function<void(int pipe)>& read, unsigned cpuSeconds);

} // namespace wellstrat::render
