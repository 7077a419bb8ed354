// SPDX-License-Identifier: Apache-2.0
//
// Long computations that are no loops of ours, and that Ctrl-C ends all the same.

#pragma once

#include "gil.h"

#include <pybind11/pybind11.h>

#include <chrono>
#include <future>
#include <thread>
#include <utility>

namespace python {

/// What compute() returns or throws. It runs in a thread of its own, while this one is unlocked and
/// looks for Ctrl-C now and then; after one, nobody waits for it any more. So it must own all that
/// it reads, and must not touch Python.
template <typename Compute>
auto computeInterruptibly(Compute compute) {
    std::packaged_task<decltype(compute())()> task(std::move(compute));
    auto result = task.get_future();
    std::thread(std::move(task)).detach();
    for (bool isReady = false; !isReady;) {
        {
            const Unlocked unlocked;
            isReady = result.wait_for(std::chrono::milliseconds(50)) == std::future_status::ready;
        }
        if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    }
    return result.get();
}

} // namespace python
