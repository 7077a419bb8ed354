// SPDX-License-Identifier: Apache-2.0
//
// The interface of sample generators, for integrators that want other samples than the tables.

#pragma once

#include "wellstrat/domain.h"
#include "wellstrat/platform.h"
#include "wellstrat/vector.h"

namespace wellstrat {
inline namespace stream1 {

/// Maps sample contexts to samples in [0, 1), [0, 1)^2 and [0, 1)^3. A RixRNG that has a generator
/// asks it for every draw; without one, draws come from the tables with no virtual call.
///
/// Implementations must be callable from several threads at once and should be pure functions of
/// the context, so that DrawSample of one context gives one value. The RixRNG does not own its
/// generator, which must outlive it and all its children.
class WELLSTRAT_API Generator {
public:
    virtual ~Generator();

    /// The sample of `sc`, the context of point `i` of the RixRNG.
    virtual float Sample1D(const SampleCtx& sc, unsigned i) const = 0;
    virtual Float2 Sample2D(const SampleCtx& sc, unsigned i) const = 0;
    virtual Float3 Sample3D(const SampleCtx& sc, unsigned i) const = 0;

    /// Fills xis[0, n) for n contiguous contexts, of points 0 to n - 1, of which `sc` is the first.
    /// n is at least 1. These loop over the functions above unless they are overridden.
    virtual void MultiSample1D(unsigned n, const SampleCtx& sc, float* xis) const;
    virtual void MultiSample2D(unsigned n, const SampleCtx& sc, Float2* xis) const;
    virtual void MultiSample3D(unsigned n, const SampleCtx& sc, Float3* xis) const;

    /// The generator of a RixRNG that is derived from one with this generator; null gives it the
    /// tables. `split` is 1 for a plain new domain, n for a split by n, 0 for distribution.
    virtual const Generator* ForChild(Scramble scramble, unsigned split) const;
};

} // namespace stream1
} // namespace wellstrat
