// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/long.h"

#include "ordered_draws.h"
#include "wellstrat/batch.h"
#include "wellstrat/sequence_slots.h"

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr auto kDraw1D = detail::orderedSample<float, sequenceSample1D, jointSequenceSample1D>;
constexpr auto kDraw2D = detail::orderedSample<Float2, sequenceSample2D, jointSequenceSample2D>;
constexpr auto kDraw3D = detail::orderedSample<Float3, sequenceSample3D, jointSequenceSample3D>;

} // namespace

LongProgressive::~LongProgressive() = default;

float LongProgressive::OrderedSample1D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return kDraw1D(sc, order);
}

Float2 LongProgressive::OrderedSample2D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return kDraw2D(sc, order);
}

Float3 LongProgressive::OrderedSample3D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return kDraw3D(sc, order);
}

void LongProgressive::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                           float* xis) const {
    detail::drawOrdered<kDraw1D>(n, sc, order, xis, drawSequenceSamples1D);
}

void LongProgressive::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                           Float2* xis) const {
    detail::drawOrdered<kDraw2D>(n, sc, order, xis, drawSequenceSamples2D);
}

void LongProgressive::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                           Float3* xis) const {
    detail::drawOrdered<kDraw3D>(n, sc, order, xis, drawSequenceSamples3D);
}

} // namespace stream1
} // namespace wellstrat
