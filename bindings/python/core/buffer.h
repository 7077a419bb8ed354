// SPDX-License-Identifier: Apache-2.0
//
// The memory of an array, by Python's buffer protocol: this module needs no headers of NumPy's and
// works with any version of it.

#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <stdexcept>

namespace python {

/// The items of a C-contiguous array, which stays as it is as long as this lives. `T` is const for
/// arrays that are only read. Throws std::invalid_argument for items of another size, and Python's
/// BufferError for an array that is read-only or not contiguous: the package checks before.
template <typename T>
class Buffer {
public:
    explicit Buffer(const pybind11::object& array) {
        const int flags =
            std::is_const_v<T> ? PyBUF_C_CONTIGUOUS : PyBUF_C_CONTIGUOUS | PyBUF_WRITABLE;
        if (PyObject_GetBuffer(array.ptr(), &view_, flags) != 0) {
            throw pybind11::error_already_set();
        }
        if (view_.itemsize != static_cast<Py_ssize_t>(sizeof(T))) {
            PyBuffer_Release(&view_);
            throw std::invalid_argument("an array of the wrong type");
        }
    }
    ~Buffer() { PyBuffer_Release(&view_); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    T* data() const { return static_cast<T*>(view_.buf); }
    std::size_t size() const { return static_cast<std::size_t>(view_.len) / sizeof(T); }

    /// Throws std::invalid_argument unless there are n items.
    void expect(std::size_t n) const {
        if (size() != n) throw std::invalid_argument("an array of the wrong size");
    }

private:
    Py_buffer view_;
};

} // namespace python
