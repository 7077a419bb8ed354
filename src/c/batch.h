// SPDX-License-Identifier: Apache-2.0
//
// Batches of the C interface as those of the library.

#pragma once

#include "c/call.h"
#include "wellstrat/domain.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace wellstrat {
inline namespace stream1 {
namespace c {

static_assert(sizeof(wellstrat_context) == sizeof(SampleCtx) &&
                  alignof(wellstrat_context) == alignof(SampleCtx) &&
                  offsetof(wellstrat_context, sampleid) == offsetof(SampleCtx, sampleid),
              "contexts have the same layout in C");

inline SampleCtx* contexts(wellstrat_context* array) { return reinterpret_cast<SampleCtx*>(array); }
inline const SampleCtx* contexts(const wellstrat_context* array) {
    return reinterpret_cast<const SampleCtx*>(array);
}

/// n, which is below 2^32 and such that arrays of 3D samples fit into an address space. Throws
/// std::invalid_argument if it is not, as a negative number from a language that has them.
inline unsigned checkedCount(std::size_t n) {
    constexpr std::size_t kMost = std::min<std::size_t>(
        std::numeric_limits<uint32_t>::max(), std::numeric_limits<std::size_t>::max() / 12);
    if (n <= kMost) return static_cast<unsigned>(n);
    throw std::invalid_argument("n is " + std::to_string(n) + "; accepted are 0 to " +
                                std::to_string(kMost));
}

} // namespace c
} // namespace stream1
} // namespace wellstrat
