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

/// Throws for null, where there is anything to read or write. `name` is that of the argument.
inline void checkPointer(const void* pointer, const char* name, std::size_t n = 1) {
    if (pointer != nullptr || n == 0) return;
    throw std::invalid_argument(
        std::string(name) + " is null; " +
        (n == 1 ? "it must point to a value" : "it must be an array for n = " + std::to_string(n)));
}

} // namespace c
} // namespace stream1
} // namespace wellstrat
