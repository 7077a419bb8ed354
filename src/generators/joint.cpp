// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/joint.h"

#include "ordered_draws.h"
#include "wellstrat/batch.h"

namespace wellstrat {
inline namespace stream1 {
namespace {

/// The tables if they are built and the order is one of most draws', padded or of a slot without
/// splits; else null. What is rare is compiled apart from what is not, which costs a fifth less
/// that way.
const uint32_t* tablesForMost(Order order) {
    const bool most = order.slot == kJointSlots || (order.slot < kJointSlots && order.splits == 1);
    return most ? detail::tableWords.load(std::memory_order_acquire) : nullptr;
}

WELLSTRAT_NOINLINE float rareSample1D(const SampleCtx& sc, Order order) {
    if (!detail::hasSlot(order)) return sample1D(sc.patternid, sc.sampleid);
    return jointSample1D(tables(), sc.patternid, sc.sampleid, order.slot, order.splits);
}

WELLSTRAT_NOINLINE Float2 rareSample2D(const SampleCtx& sc, Order order) {
    if (!detail::hasSlot(order)) return sample2D(sc.patternid, sc.sampleid);
    return jointSample2D(tables(), sc.patternid, sc.sampleid, order.slot, order.splits);
}

WELLSTRAT_NOINLINE Float3 rareSample3D(const SampleCtx& sc, Order order) {
    if (!detail::hasSlot(order)) return sample3D(sc.patternid, sc.sampleid);
    return jointSample3D(tables(), sc.patternid, sc.sampleid, order.slot, order.splits);
}

float draw1D(const SampleCtx& sc, Order order) {
    const uint32_t* const words = tablesForMost(order);
    if (WELLSTRAT_UNLIKELY(words == nullptr)) return rareSample1D(sc, order);
    return order.slot == kJointSlots
               ? sample1D(words, sc.patternid, sc.sampleid)
               : jointSample1D(words, sc.patternid, sc.sampleid, order.slot, 1);
}

Float2 draw2D(const SampleCtx& sc, Order order) {
    const uint32_t* const words = tablesForMost(order);
    if (WELLSTRAT_UNLIKELY(words == nullptr)) return rareSample2D(sc, order);
    return order.slot == kJointSlots
               ? sample2D(words, sc.patternid, sc.sampleid)
               : jointSample2D(words, sc.patternid, sc.sampleid, order.slot, 1);
}

Float3 draw3D(const SampleCtx& sc, Order order) {
    const uint32_t* const words = tablesForMost(order);
    if (WELLSTRAT_UNLIKELY(words == nullptr)) return rareSample3D(sc, order);
    return order.slot == kJointSlots
               ? sample3D(words, sc.patternid, sc.sampleid)
               : jointSample3D(words, sc.patternid, sc.sampleid, order.slot, 1);
}

} // namespace

JointProgressive::~JointProgressive() = default;

float JointProgressive::OrderedSample1D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return draw1D(sc, order);
}

Float2 JointProgressive::OrderedSample2D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return draw2D(sc, order);
}

Float3 JointProgressive::OrderedSample3D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return draw3D(sc, order);
}

void JointProgressive::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                            float* xis) const {
    detail::drawOrdered<draw1D>(n, sc, order, xis, drawJointSamples1D);
}

void JointProgressive::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                            Float2* xis) const {
    detail::drawOrdered<draw2D>(n, sc, order, xis, drawJointSamples2D);
}

void JointProgressive::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                            Float3* xis) const {
    detail::drawOrdered<draw3D>(n, sc, order, xis, drawJointSamples3D);
}

} // namespace stream1
} // namespace wellstrat
