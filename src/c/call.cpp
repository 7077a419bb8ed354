// SPDX-License-Identifier: Apache-2.0

#include "c/call.h"

#include <cstdio>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// Without a constructor or a destructor, so that it is there as long as its thread.
thread_local char lastError[256] = "";

} // namespace

int c::failed(int status, const char* function, const char* text) noexcept {
    std::snprintf(lastError, sizeof lastError, "%s: %s", function, text);
    return status;
}

} // namespace stream1
} // namespace wellstrat

const char* wellstrat_last_error() { return wellstrat::lastError; }
