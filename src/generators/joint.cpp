// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/joint.h"

#include "core/order_check.h"

namespace wellstrat {
inline namespace stream1 {

JointProgressive::~JointProgressive() = default;

float JointProgressive::OrderedSample1D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    if (!detail::hasSlot(order)) return sample1D(sc.patternid, sc.sampleid);
    return jointSample1D(tables(), sc.patternid, sc.sampleid, order.slot, order.splits);
}

Float2 JointProgressive::OrderedSample2D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    if (!detail::hasSlot(order)) return sample2D(sc.patternid, sc.sampleid);
    return jointSample2D(tables(), sc.patternid, sc.sampleid, order.slot, order.splits);
}

Float3 JointProgressive::OrderedSample3D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    if (!detail::hasSlot(order)) return sample3D(sc.patternid, sc.sampleid);
    return jointSample3D(tables(), sc.patternid, sc.sampleid, order.slot, order.splits);
}

void JointProgressive::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                            float* xis) const {
    drawJointSamples1D(n, &sc, order, xis);
}

void JointProgressive::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                            Float2* xis) const {
    drawJointSamples2D(n, &sc, order, xis);
}

void JointProgressive::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                            Float3* xis) const {
    drawJointSamples3D(n, &sc, order, xis);
}

} // namespace stream1
} // namespace wellstrat
