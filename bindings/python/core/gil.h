// SPDX-License-Identifier: Apache-2.0
//
// Letting other Python threads run while this one computes.

#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstddef>

namespace python {

/// As long as it lives, other threads of the interpreter run, and this one must not touch Python.
///
/// A thread that asks for the lock while the interpreter exits never returns: it ends, through
/// frames of C++ that cannot be left in that way, and the program aborts. So `watchForExit` makes
/// the exit wait for all threads that compute, and those that begin later keep the lock.
class Unlocked {
public:
    Unlocked();
    ~Unlocked();
    Unlocked(const Unlocked&) = delete;
    Unlocked& operator=(const Unlocked&) = delete;

private:
    PyThreadState* state_; ///< null if it kept the lock
};

/// Call it once, when the module is loaded.
void watchForExit();

/// Calls compute(begin, end) for consecutive parts of [0, n), unlocked, and looks for Ctrl-C in
/// between. A part takes some tens of milliseconds.
template <typename Compute>
void computeUnlocked(std::size_t n, Compute compute) {
    constexpr std::size_t kPart = std::size_t{1} << 22;
    for (std::size_t begin = 0; begin < n; begin += kPart) {
        {
            const Unlocked unlocked;
            compute(begin, std::min(begin + kPart, n));
        }
        if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
    }
}

} // namespace python
