// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/array_argument.h"

#include <cstdio>
#include <cstdlib>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

void endForSmallArray(const char* function, std::size_t size, std::size_t needed) {
    std::fprintf(stderr, "wellstrat: %s: the array has %zu elements and needs %zu\n", function,
                 size, needed);
    std::abort();
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
