// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/blue.h"

#include "core/order_check.h"
#include "wellstrat/batch.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/detail/few_points.h"

namespace wellstrat {
inline namespace stream1 {

BlueProgressive::~BlueProgressive() = default;

float BlueProgressive::OrderedSample1D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return detail::hasSlot(order)
               ? blueSlotSample1D(sc.patternid, sc.sampleid, order.slot, order.splits)
               : blueSample1D(sc.patternid, sc.sampleid);
}

Float2 BlueProgressive::OrderedSample2D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return detail::hasSlot(order)
               ? blueSlotSample2D(sc.patternid, sc.sampleid, order.slot, order.splits)
               : blueSample2D(sc.patternid, sc.sampleid);
}

Float3 BlueProgressive::OrderedSample3D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return detail::hasSlot(order)
               ? blueSlotSample3D(sc.patternid, sc.sampleid, order.slot, order.splits)
               : blueSample3D(sc.patternid, sc.sampleid);
}

void BlueProgressive::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                           float* xis) const {
    if (n > detail::kFewPoints) return drawBlueSamples1D(n, &sc, order, xis);
    for (unsigned i = 0; i < n; ++i) xis[i] = BlueProgressive::OrderedSample1D((&sc)[i], i, order);
}

void BlueProgressive::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                           Float2* xis) const {
    if (n > detail::kFewPoints) return drawBlueSamples2D(n, &sc, order, xis);
    for (unsigned i = 0; i < n; ++i) xis[i] = BlueProgressive::OrderedSample2D((&sc)[i], i, order);
}

void BlueProgressive::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                           Float3* xis) const {
    if (n > detail::kFewPoints) return drawBlueSamples3D(n, &sc, order, xis);
    for (unsigned i = 0; i < n; ++i) xis[i] = BlueProgressive::OrderedSample3D((&sc)[i], i, order);
}

SampleCtx BlueProgressive::CameraContext(int x, int y, unsigned seed, unsigned sampleid) const {
    return blueContext(x, y, seed, sampleid);
}

void BlueProgressive::MultiNewDomainSplit(unsigned n, const SampleCtx& parents, Order /*order*/,
                                          Scramble scramble, unsigned newnumsamples,
                                          SampleCtx* children) const {
    if (n > detail::kFewPoints) {
        return newBlueDomainsSplit(n, &parents, scramble, newnumsamples, children);
    }
    for (unsigned i = 0; i < n; ++i) {
        children[i] = newBlueDomainSplit((&parents)[i], scramble, newnumsamples);
    }
}

void BlueProgressive::MultiNewDomainDistrib(unsigned n, const SampleCtx& parents, Order /*order*/,
                                            Scramble scramble, unsigned newsampleid,
                                            SampleCtx* children) const {
    if (n > detail::kFewPoints) {
        return newBlueDomainsDistrib(n, &parents, scramble, newsampleid, children);
    }
    for (unsigned i = 0; i < n; ++i) {
        children[i] = newBlueDomainDistrib((&parents)[i], scramble, newsampleid);
    }
}

unsigned BlueProgressive::ParentPattern(unsigned patternid, Scramble scramble) const {
    return parentBluePattern(patternid, scramble);
}

unsigned BlueProgressive::PlaceBits() const { return kRankDigits; }

} // namespace stream1
} // namespace wellstrat
