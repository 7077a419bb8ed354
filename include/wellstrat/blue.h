// SPDX-License-Identifier: Apache-2.0
//
// Samples whose errors cancel between neighboring pixels: blue noise, at every sample count.
//
// Pixels of other generators know nothing of each other, so their errors are white noise. Here all
// samples of a block of pixels together are as well stratified as those of one pixel are, in each
// domain, and the error that is left is of high frequency: it looks finer, and vanishes under a
// filter. An integrator gets it by two changes, of the camera's contexts and of the generator:
//
//     const wellstrat::BlueProgressive blue;
//     contexts[i] = wellstrat::blueContext(x, y, seed, sampleid);
//     RixRNG camera(contexts, numPts, &blue);
//
// and must derive all domains through a RixRNG. It need not know how many samples there will be.
// Nothing is lost in a pixel by itself. What is gained, where nothing is, and why it works:
// docs/blue.md. The contexts are defined in blue_domain.h, the samples in blue_lookup.h.

#pragma once

#include "wellstrat/blue_domain.h"
#include "wellstrat/generator.h"

namespace wellstrat {
inline namespace stream1 {

/// The generator of samples that are stratified over pixels. It has no state, so all of them are
/// alike; constructing one costs nothing, and they may be used in any thread.
///
/// Domains that are derived by jointScramble(slot) are stratified together as well, as those of a
/// JointProgressive are, and under the same conditions (joint.h). Only through these are two
/// domains of a path, pixel and light, blue together.
///
/// What a domain is stratified over, in each case together with the pixels of its tile:
///
///     new domain, split by n     all its samples; where n is no power of two, a slot's by visits
///     distribution               the samples of one visit; visits are independent of each other
///
/// Any context may be drawn. One that is not derived from a blueContext by this generator, but by
/// cameraContext or SampleCtx::NewDomain, has samples as good as others', and knows nothing of
/// other pixels. Two domains of a pixel draw the same with a probability of 2^-20, that of equal
/// states: of 50 domains of a path any two do in 0.12 % of the tiles.
class WELLSTRAT_API BlueProgressive final : public OrderedGenerator {
public:
    constexpr BlueProgressive() : OrderedGenerator(Source::blue) {}
    ~BlueProgressive() override;

    float OrderedSample1D(const SampleCtx& sc, unsigned i, Order order) const override;
    Float2 OrderedSample2D(const SampleCtx& sc, unsigned i, Order order) const override;
    Float3 OrderedSample3D(const SampleCtx& sc, unsigned i, Order order) const override;
    void MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                              float* xis) const override;
    void MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                              Float2* xis) const override;
    void MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                              Float3* xis) const override;

    /// blueContext (blue_domain.h).
    SampleCtx CameraContext(int x, int y, unsigned seed, unsigned sampleid) const override;

    /// By newBlueDomainSplit and newBlueDomainDistrib (blue_domain.h).
    void MultiNewDomainSplit(unsigned n, const SampleCtx& parents, Order order, Scramble scramble,
                             unsigned newnumsamples, SampleCtx* children) const override;
    void MultiNewDomainDistrib(unsigned n, const SampleCtx& parents, Order order, Scramble scramble,
                               unsigned newsampleid, SampleCtx* children) const override;
    unsigned ParentPattern(unsigned patternid, Scramble scramble) const override;
    unsigned PlaceBits() const override;
};

} // namespace stream1
} // namespace wellstrat
