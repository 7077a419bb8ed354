// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/long.h"

#include "core/order_check.h"
#include "wellstrat/batch.h"
#include "wellstrat/detail/few_points.h"
#include "wellstrat/sequence_slots.h"

namespace wellstrat {
inline namespace stream1 {

LongProgressive::~LongProgressive() = default;

float LongProgressive::OrderedSample1D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return detail::hasSlot(order)
               ? jointSequenceSample1D(sc.patternid, sc.sampleid, order.slot, order.splits)
               : sequenceSample1D(sc.patternid, sc.sampleid);
}

Float2 LongProgressive::OrderedSample2D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return detail::hasSlot(order)
               ? jointSequenceSample2D(sc.patternid, sc.sampleid, order.slot, order.splits)
               : sequenceSample2D(sc.patternid, sc.sampleid);
}

Float3 LongProgressive::OrderedSample3D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return detail::hasSlot(order)
               ? jointSequenceSample3D(sc.patternid, sc.sampleid, order.slot, order.splits)
               : sequenceSample3D(sc.patternid, sc.sampleid);
}

void LongProgressive::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                           float* xis) const {
    if (n > detail::kFewPoints) return drawSequenceSamples1D(n, &sc, order, xis);
    for (unsigned i = 0; i < n; ++i) xis[i] = LongProgressive::OrderedSample1D((&sc)[i], i, order);
}

void LongProgressive::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                           Float2* xis) const {
    if (n > detail::kFewPoints) return drawSequenceSamples2D(n, &sc, order, xis);
    for (unsigned i = 0; i < n; ++i) xis[i] = LongProgressive::OrderedSample2D((&sc)[i], i, order);
}

void LongProgressive::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                           Float3* xis) const {
    if (n > detail::kFewPoints) return drawSequenceSamples3D(n, &sc, order, xis);
    for (unsigned i = 0; i < n; ++i) xis[i] = LongProgressive::OrderedSample3D((&sc)[i], i, order);
}

} // namespace stream1
} // namespace wellstrat
