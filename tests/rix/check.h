// SPDX-License-Identifier: Apache-2.0
//
// The checks of these programs: they count failures, and the count decides the exit code.

#pragma once

#include <cstdio>

inline int& failedChecks() {
    static int count = 0;
    return count;
}

inline void check(bool passed, const char* condition, const char* file, int line) {
    if (passed) return;
    std::fprintf(stderr, "%s:%d: failed: %s\n", file, line, condition);
    ++failedChecks();
}

#define CHECK(condition) check((condition), #condition, __FILE__, __LINE__)

inline int exitCode() { return failedChecks() == 0 ? 0 : 1; }
