// SPDX-License-Identifier: Apache-2.0
//
// What the computer lacks, in a sentence.

#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace python {

/// Lets the module that calls it, when it is loaded, raise MemoryError and RuntimeError with what
/// is missing, where pybind11 would show the text of C++'s exceptions.
inline void nameWhatIsMissing() {
    pybind11::register_local_exception_translator([](std::exception_ptr error) {
        try {
            std::rethrow_exception(std::move(error));
        } catch (const std::bad_alloc&) {
            PyErr_SetString(PyExc_MemoryError, "there is not enough memory");
        } catch (const std::system_error& problem) { // of std::thread
            const std::string text = std::string("no thread can be started: ") + problem.what();
            PyErr_SetString(PyExc_RuntimeError, text.c_str());
        }
    });
}

} // namespace python
