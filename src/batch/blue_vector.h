// SPDX-License-Identifier: Apache-2.0
//
// The batches of BlueProgressive that vector code has for each target; see kernels.h. Included once
// for each target, as vector_words.h.

#if defined(WELLSTRAT_BATCH_BLUE_VECTOR_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WELLSTRAT_BATCH_BLUE_VECTOR_H
#undef WELLSTRAT_BATCH_BLUE_VECTOR_H
#else
#define WELLSTRAT_BATCH_BLUE_VECTOR_H
#endif

#include "wellstrat/domain.h"
#include "wellstrat/vector.h"

#include "hwy/highway.h"

#include <cstddef>

namespace wellstrat {
inline namespace stream1 {
namespace batch {
namespace HWY_NAMESPACE {

/// Of float, Float2 and Float3.
template <typename Sample>
void drawBlue(std::size_t n, const SampleCtx* contexts, unsigned slot, unsigned split, Sample* xis);
void newBlueDomainsSplit(std::size_t n, const SampleCtx* parents, Scramble scramble,
                         unsigned newnumsamples, SampleCtx* children);
void newBlueDomainsDistrib(std::size_t n, const SampleCtx* parents, Scramble scramble,
                           unsigned newsampleid, SampleCtx* children);

} // namespace HWY_NAMESPACE
} // namespace batch
} // namespace stream1
} // namespace wellstrat

#endif
