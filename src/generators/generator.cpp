// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/generator.h"

#include "wellstrat/camera.h"
#include "wellstrat/detail/few_points.h"

namespace wellstrat {
inline namespace stream1 {

Generator::~Generator() = default;

void Generator::MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const {
    for (unsigned i = 0; i < n; ++i) xis[i] = Sample1D((&sc)[i], i);
}

void Generator::MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const {
    for (unsigned i = 0; i < n; ++i) xis[i] = Sample2D((&sc)[i], i);
}

void Generator::MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const {
    for (unsigned i = 0; i < n; ++i) xis[i] = Sample3D((&sc)[i], i);
}

float Generator::OrderedSample1D(const SampleCtx& sc, unsigned i, Order /*order*/) const {
    return Sample1D(sc, i);
}

Float2 Generator::OrderedSample2D(const SampleCtx& sc, unsigned i, Order /*order*/) const {
    return Sample2D(sc, i);
}

Float3 Generator::OrderedSample3D(const SampleCtx& sc, unsigned i, Order /*order*/) const {
    return Sample3D(sc, i);
}

void Generator::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order /*order*/,
                                     float* xis) const {
    MultiSample1D(n, sc, xis);
}

void Generator::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order /*order*/,
                                     Float2* xis) const {
    MultiSample2D(n, sc, xis);
}

void Generator::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order /*order*/,
                                     Float3* xis) const {
    MultiSample3D(n, sc, xis);
}

SampleCtx Generator::CameraContext(int x, int y, unsigned seed, unsigned sampleid) const {
    constexpr unsigned kFrame = 0;
    return cameraContext(x, y, kFrame, sampleid, seed);
}

Order Generator::ChildOrder(Order parent, Scramble scramble, unsigned split) const {
    return deriveOrder(parent, scramble, split);
}

Order Generator::ViewOrder(Order parent) const { return viewOrder(parent); }

void Generator::MultiNewDomainSplit(unsigned n, const SampleCtx& parents, Order /*order*/,
                                    Scramble scramble, unsigned newnumsamples,
                                    SampleCtx* children) const {
    detail::newDomainsSplit(n, &parents, scramble, newnumsamples, children);
}

void Generator::MultiNewDomainDistrib(unsigned n, const SampleCtx& parents, Order /*order*/,
                                      Scramble scramble, unsigned newsampleid,
                                      SampleCtx* children) const {
    detail::newDomainsDistrib(n, &parents, scramble, newsampleid, children);
}

unsigned Generator::ParentPattern(unsigned patternid, Scramble scramble) const {
    return parentPattern(patternid, scramble);
}

unsigned Generator::PlaceBits() const { return 0; }

OrderedGenerator::~OrderedGenerator() = default;

float OrderedGenerator::Sample1D(const SampleCtx& sc, unsigned i) const {
    return OrderedSample1D(sc, i, {});
}

Float2 OrderedGenerator::Sample2D(const SampleCtx& sc, unsigned i) const {
    return OrderedSample2D(sc, i, {});
}

Float3 OrderedGenerator::Sample3D(const SampleCtx& sc, unsigned i) const {
    return OrderedSample3D(sc, i, {});
}

void OrderedGenerator::MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const {
    MultiOrderedSample1D(n, sc, {}, xis);
}

void OrderedGenerator::MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const {
    MultiOrderedSample2D(n, sc, {}, xis);
}

void OrderedGenerator::MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const {
    MultiOrderedSample3D(n, sc, {}, xis);
}

void OrderedGenerator::MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                            float* xis) const {
    for (unsigned i = 0; i < n; ++i) xis[i] = OrderedSample1D((&sc)[i], i, order);
}

void OrderedGenerator::MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                            Float2* xis) const {
    for (unsigned i = 0; i < n; ++i) xis[i] = OrderedSample2D((&sc)[i], i, order);
}

void OrderedGenerator::MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                            Float3* xis) const {
    for (unsigned i = 0; i < n; ++i) xis[i] = OrderedSample3D((&sc)[i], i, order);
}

} // namespace stream1
} // namespace wellstrat
