// SPDX-License-Identifier: Apache-2.0
//
// Finds the mistakes that integrators make with domains, which no compiler sees and which a picture
// shows only as a little more noise.

#pragma once

#include "wellstrat/domain_finding.h"
#include "wellstrat/generator.h"

#include <memory>
#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// A generator to debug an integrator with. Set it on the camera RixRNG; it passes on the samples
/// of the generator that it wraps, bit for bit, and records which domains are drawn:
///
///     const wellstrat::DomainLinter linter(&joint);
///     RixRNG camera(contexts, numPts, &linter);
///     // ... render a few pixels ...
///     std::fputs(linter.report().c_str(), stderr);
///
/// A path is all that is drawn for one sampleid of one camera pattern. Faults are judged from the
/// whole record when they are asked for, so neither order nor threads matter. What is seen, and
/// what is not, is in docs/linter.md.
///
/// Safe in any thread. Each draw locks a mutex and takes some 50 ns, and each sample about 40 bytes
/// until clear(): lint a few pixels, not a picture. It must outlive all RixRNGs that have it.
class WELLSTRAT_API DomainLinter final : public OrderedGenerator {
public:
    using Fault = DomainFault;
    using Finding = DomainFinding;

    /// `inner`, which is not owned, makes the samples; null: the tables.
    explicit DomainLinter(const Generator* inner = nullptr);
    ~DomainLinter() override;
    DomainLinter(const DomainLinter&) = delete;
    DomainLinter& operator=(const DomainLinter&) = delete;

    float OrderedSample1D(const SampleCtx& sc, unsigned i, Order order) const override;
    Float2 OrderedSample2D(const SampleCtx& sc, unsigned i, Order order) const override;
    Float3 OrderedSample3D(const SampleCtx& sc, unsigned i, Order order) const override;
    void MultiOrderedSample1D(unsigned n, const SampleCtx& sc, Order order,
                              float* xis) const override;
    void MultiOrderedSample2D(unsigned n, const SampleCtx& sc, Order order,
                              Float2* xis) const override;
    void MultiOrderedSample3D(unsigned n, const SampleCtx& sc, Order order,
                              Float3* xis) const override;

    /// What the wrapped generator says.
    SampleCtx CameraContext(int x, int y, unsigned seed, unsigned sampleid) const override;
    unsigned ParentPattern(unsigned patternid, Scramble scramble) const override;
    unsigned PlaceBits() const override;

    /// What the wrapped generator says, but for the tag, by which the linter knows the derivation.
    Order ChildOrder(Order parent, Scramble scramble, unsigned split) const override;
    Order ViewOrder(Order parent) const override;
    void MultiNewDomainSplit(unsigned n, const SampleCtx& parents, Order order, Scramble scramble,
                             unsigned newnumsamples, SampleCtx* children) const override;
    void MultiNewDomainDistrib(unsigned n, const SampleCtx& parents, Order order, Scramble scramble,
                               unsigned newsampleid, SampleCtx* children) const override;

    /// The faults in what was drawn so far, sorted; equal records give equal findings.
    std::vector<Finding> findings() const;

    /// The same as text: a line for each finding, or "no faults in 120 draws of 3 domains".
    std::string report() const;

    /// Forgets all draws. RixRNGs that have this generator stay valid.
    void clear();

private:
    class State;
    const std::unique_ptr<State> state_;
};

} // namespace stream1
} // namespace wellstrat
