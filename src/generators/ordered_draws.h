// SPDX-License-Identifier: Apache-2.0
//
// How generators draw in an order: from its slot or padded, and of few points each by itself.

#pragma once

#include "core/order_check.h"
#include "wellstrat/array_argument.h"
#include "wellstrat/detail/few_points.h"
#include "wellstrat/domain.h"
#include "wellstrat/order.h"

#include <cstddef>
#include <cstdint>

namespace wellstrat {
inline namespace stream1 {
namespace detail {

/// A sample by kPadded(patternid, sampleid) or kSlot(patternid, sampleid, slot, splits).
template <typename Sample, Sample (*kPadded)(uint32_t, uint32_t),
          Sample (*kSlot)(uint32_t, uint32_t, unsigned, unsigned)>
Sample orderedSample(const SampleCtx& sc, Order order) {
    return hasSlot(order) ? kSlot(sc.patternid, sc.sampleid, order.slot, order.splits)
                          : kPadded(sc.patternid, sc.sampleid);
}

/// The samples of n contexts from `first` on, by `batch` or, few of them, by kSingle.
template <auto kSingle, typename Sample>
void drawOrdered(unsigned n, const SampleCtx& first, Order order, Sample* xis,
                 void (*batch)(std::size_t, ArrayArgument<const SampleCtx>, Order,
                               ArrayArgument<Sample>)) {
    if (n > kFewPoints) return batch(n, &first, order, xis);
    for (unsigned i = 0; i < n; ++i) xis[i] = kSingle((&first)[i], order);
}

} // namespace detail
} // namespace stream1
} // namespace wellstrat
