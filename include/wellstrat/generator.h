// SPDX-License-Identifier: Apache-2.0
//
// The interface of sample generators, for integrators that want other samples than the tables.
//
// A Generator of one's own needs the first three functions, and gets the others as they are for all
// that know nothing of orders (order.h). An OrderedGenerator needs three as well, which are told.

#pragma once

#include "wellstrat/domain.h"
#include "wellstrat/order.h"
#include "wellstrat/platform.h"
#include "wellstrat/vector.h"

#include <cstdint>

namespace wellstrat {
inline namespace stream1 {

/// Maps sample contexts to samples in [0, 1), [0, 1)^2 and [0, 1)^3. A RixRNG that has a generator
/// asks it for every draw; without one, draws come from the tables with no virtual call.
///
/// Implementations must be callable from several threads at once and should be pure functions of
/// their arguments, so that DrawSample of one context gives one value. The RixRNG does not own its
/// generator, which must outlive it and all its children.
///
/// Functions for many contexts take the first of n contiguous ones, n >= 1.
class WELLSTRAT_API Generator {
public:
    virtual ~Generator();

    /// Whose samples these are, where a RixRNG knows how to draw them without a virtual call.
    enum class Source : uint32_t {
        own,      ///< nobody's that it knows
        tables,   ///< those of JointProgressive (joint.h)
        sequence, ///< those of LongProgressive (long.h)
        blue,     ///< those of BlueProgressive (blue.h)
    };
    Source source() const { return source_; }

    /// The sample of `sc`, the context of point `i` of the RixRNG.
    virtual float Sample1D(const SampleCtx& sc, unsigned i) const = 0;
    virtual Float2 Sample2D(const SampleCtx& sc, unsigned i) const = 0;
    virtual Float3 Sample3D(const SampleCtx& sc, unsigned i) const = 0;

    /// Fills xis[0, n) for the contexts of points 0 to n - 1. These loop over the functions above
    /// unless they are overridden.
    virtual void MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const;
    virtual void MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const;
    virtual void MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const;

    // What a RixRNG really calls. By default, the functions above: the order does not matter. Who
    // overrides one of these overrides those for n contexts too; an OrderedGenerator does.

    /// The sample of `sc` in a domain of this order.
    virtual float OrderedSample1D(const SampleCtx& sc, unsigned i, Order order) const;
    virtual Float2 OrderedSample2D(const SampleCtx& sc, unsigned i, Order order) const;
    virtual Float3 OrderedSample3D(const SampleCtx& sc, unsigned i, Order order) const;

    /// The same for the contexts of points 0 to n - 1.
    virtual void MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                                      float* xis) const;
    virtual void MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                                      Float2* xis) const;
    virtual void MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                                      Float3* xis) const;

    // Where contexts begin.

    /// The context of sample `sampleid` of pixel (x, y), for a RixRNG that has this generator. By
    /// default cameraContext (camera.h) of frame 0: images of different seeds are independent, and
    /// the frames of a sequence go on in the sampleid. Where there is no generator, that is right
    /// too.
    virtual SampleCtx CameraContext(int x, int y, unsigned seed, unsigned sampleid) const;

    // How domains are derived through a RixRNG.

    /// The order of a new domain, by default deriveOrder(parent, scramble, split): `split` is 1 for
    /// a plain one, n for a split by n, 0 for distribution.
    virtual Order ChildOrder(Order parent, Scramble scramble, unsigned split) const;

    /// The order of RixRNG(parent, contexts, n), whose contexts may be any. By default
    /// viewOrder(parent), which is sound whatever they are.
    virtual Order ViewOrder(Order parent) const;

    /// The contexts of new domains of n contexts, whose order is `order`, into children[0, n),
    /// which may be where `parents` are. By default what SampleCtx::NewDomainSplit and
    /// NewDomainDistrib give. A plain new domain is a split by 1.
    virtual void MultiNewDomainSplit(unsigned n, const SampleCtx& parents, Order order,
                                     Scramble scramble, unsigned newnumsamples,
                                     SampleCtx* children) const;
    virtual void MultiNewDomainDistrib(unsigned n, const SampleCtx& parents, Order order,
                                       Scramble scramble, unsigned newsampleid,
                                       SampleCtx* children) const;

    /// The pattern whose new domain, plain or split, `patternid` belongs to, if it was derived by
    /// `scramble`: what tools need to find the camera's pattern. By default parentPattern
    /// (domain.h). Who overrides MultiNewDomainSplit overrides this too.
    virtual unsigned ParentPattern(unsigned patternid, Scramble scramble) const;

    /// How many of the last bits of a patternid are the same in all domains of a pixel, so that not
    /// they keep domains apart. By default none.
    virtual unsigned PlaceBits() const;

protected:
    constexpr Generator() = default;
    explicit constexpr Generator(Source source) : source_(source) {}

private:
    Source source_ = Source::own;
};

/// The base of generators to which the order of a domain matters. They need OrderedSample1D, 2D and
/// 3D; all other draws are these, without a RixRNG in the root order.
class WELLSTRAT_API OrderedGenerator : public Generator {
protected:
    constexpr OrderedGenerator() = default;
    explicit constexpr OrderedGenerator(Source source) : Generator(source) {}

public:
    ~OrderedGenerator() override;

    float Sample1D(const SampleCtx& sc, unsigned i) const final;
    Float2 Sample2D(const SampleCtx& sc, unsigned i) const final;
    Float3 Sample3D(const SampleCtx& sc, unsigned i) const final;
    void MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const final;
    void MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const final;
    void MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const final;

    float OrderedSample1D(const SampleCtx& sc, unsigned i, Order order) const override = 0;
    Float2 OrderedSample2D(const SampleCtx& sc, unsigned i, Order order) const override = 0;
    Float3 OrderedSample3D(const SampleCtx& sc, unsigned i, Order order) const override = 0;
    void MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                              float* xis) const override;
    void MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                              Float2* xis) const override;
    void MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                              Float3* xis) const override;
};

} // namespace stream1
} // namespace wellstrat
