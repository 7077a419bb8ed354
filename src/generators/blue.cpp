// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/blue.h"

#include "ordered_draws.h"
#include "wellstrat/batch.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/detail/few_points.h"

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr auto kDraw1D = detail::orderedSample<float, blueSample1D, blueSlotSample1D>;
constexpr auto kDraw2D = detail::orderedSample<Float2, blueSample2D, blueSlotSample2D>;
constexpr auto kDraw3D = detail::orderedSample<Float3, blueSample3D, blueSlotSample3D>;

} // namespace

BlueProgressive::~BlueProgressive() = default;

float BlueProgressive::OrderedSample1D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return kDraw1D(sc, order);
}

Float2 BlueProgressive::OrderedSample2D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return kDraw2D(sc, order);
}

Float3 BlueProgressive::OrderedSample3D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return kDraw3D(sc, order);
}

void BlueProgressive::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                           float* xis) const {
    detail::drawOrdered<kDraw1D>(n, sc, order, xis, drawBlueSamples1D);
}

void BlueProgressive::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                           Float2* xis) const {
    detail::drawOrdered<kDraw2D>(n, sc, order, xis, drawBlueSamples2D);
}

void BlueProgressive::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                           Float3* xis) const {
    detail::drawOrdered<kDraw3D>(n, sc, order, xis, drawBlueSamples3D);
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
