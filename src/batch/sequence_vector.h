// SPDX-License-Identifier: Apache-2.0
//
// The batches of the computed sequence that vector code has for each target; see kernels.h.
// Included once for each target, as vector_words.h.

#if defined(WELLSTRAT_BATCH_SEQUENCE_VECTOR_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLSTRAT_BATCH_SEQUENCE_VECTOR_H
#undef WELLSTRAT_BATCH_SEQUENCE_VECTOR_H
#else
#define WELLSTRAT_BATCH_SEQUENCE_VECTOR_H
#endif

#include "wellstrat/domain.h"
#include "wellstrat/vector.h"

#include "hwy/highway.h"

#include <cstddef>
#include <cstdint>

namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {

/// Of float, Float2 and Float3, and of uint32_t, Bits2 and Bits3.
template <typename Sample>
void drawSequence(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split,
                  Sample* xis);

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat

#endif
