// SPDX-License-Identifier: Apache-2.0
//
// What calls of the C interface have in common: exceptions become a status and a text that is kept
// for the thread, and pointers are checked. Every library with such functions uses this.

#pragma once

#include "wellstrat/c.h"
#include "wellstrat/platform.h"

#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>

namespace wellstrat {
inline namespace stream1 {
namespace c {

/// Lets wellstrat_last_error say "function: text" in this thread, cut to 255 bytes. Returns the
/// status.
WELLSTRAT_API int failed(int status, const char* function, const char* text) noexcept;

/// Calls the body of a function, which throws std::invalid_argument for bad arguments before it
/// writes anything.
template <class Body>
int guarded(const char* function, const Body& body) noexcept {
    try {
        body();
        return WELLSTRAT_OK;
    } catch (const std::bad_alloc&) {
        return failed(WELLSTRAT_NO_MEMORY, function, "there is not enough memory");
    } catch (const std::exception& error) {
        return failed(WELLSTRAT_INVALID, function, error.what());
    }
}

/// Throws for null. `name` is that of the argument.
inline void checkResult(const void* pointer, const char* name) {
    if (pointer != nullptr) return;
    throw std::invalid_argument(std::string(name) +
                                " is null; it must point to where the result "
                                "is to be");
}

/// Throws for null, unless there are no elements.
inline void checkArray(const void* pointer, const char* name, std::size_t n) {
    if (pointer != nullptr || n == 0) return;
    throw std::invalid_argument(std::string(name) +
                                " is null; that is accepted of no elements, and there are " +
                                std::to_string(n));
}

} // namespace c
} // namespace stream1
} // namespace wellstrat
