// SPDX-License-Identifier: Apache-2.0

#include "gil.h"

#include <chrono>
#include <thread>

namespace python {
namespace {

// Both are guarded by the lock.
unsigned computing = 0;
bool exiting = false;

void waitForThreads() {
    exiting = true;
    while (computing > 0) {
        const pybind11::gil_scoped_release release;
        std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
}

/// After a fork only the thread that called it is left, which was not computing.
void forgetThreads() { computing = 0; }

} // namespace

Unlocked::Unlocked() : state_(nullptr) {
    if (exiting) return;
    ++computing;
    state_ = PyEval_SaveThread();
}

Unlocked::~Unlocked() {
    if (state_ == nullptr) return;
    PyEval_RestoreThread(state_);
    --computing;
}

void watchForExit() {
    using pybind11::cpp_function;
    using pybind11::module_;
    module_::import("atexit").attr("register")(cpp_function(waitForThreads));
    module_::import("os").attr("register_at_fork")(pybind11::arg("after_in_child") =
                                                       cpp_function(forgetThreads));
}

} // namespace python
