// SPDX-License-Identifier: Apache-2.0
//
// RixRNG: the samples and sample domains of a batch of shading points.
//
// An integrator keeps one sample context for each point of a batch, wraps the array in a RixRNG,
// and hands that to whatever needs samples:
//
//     RixRNG camera(contexts, numPts);                           // contexts from the camera
//     RixRNG bxdf(camera, kBxdfScramble, bxdfContexts);          // a new domain for each point
//     bxdf.DrawSamples2D(xi);                                    // one 2D sample for each point
//
// Draw functions leave the contexts as they are, so drawing again gives the same samples;
// Generate functions then step each context to its next sample.

#pragma once

#include "RiTypesHelper.h"
#include "RixRNGInline.h"
#include "RixRNGProgressive.h"
#include "wellstrat/array_argument.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/detail/few_points.h"
#include "wellstrat/generator.h"
#include "wellstrat/joint_lookup.h"
#include "wellstrat/sequence_slots.h"

#include <cassert>

/// A view of `numPts` sample contexts that somebody else owns, of the order of their domain, and of
/// the generator, if any, that makes their samples. Small; copy it freely. The arrays and the
/// generator must outlive it.
///
/// Points are numbered from 0. An index i must be below numPts, a count n at most numPts: asserted
/// where the caller is built without NDEBUG. Arrays are given by a pointer, which is not checked,
/// or as an array or a container with data() and size(); one of these that is too small ends the
/// program with a line that says so, before anything is written. A batch of 0 points is valid.
///
/// Nothing here allocates or throws, but the first camera's RixRNG of a process builds the tables
/// (see wellstrat::buildTables) unless its generator computes its samples, and a generator may do
/// as it likes. One object must not be used by two threads at once if one of them generates;
/// different objects over different arrays may.
class RixRNG {
    template <class T>
    using Array = wellstrat::ArrayArgument<T>;

public:
    using Scramble = wellstrat::Scramble;
    using SampleCtx = wellstrat::SampleCtx;
    using Generator = wellstrat::Generator;
    using Order = wellstrat::Order;

    /// Tags of the deriving constructors.
    struct Distrib {
        unsigned newsampleid;
    };
    struct Split {
        unsigned newnumsamples;
    };

    SampleCtx* sampleCtxArray; ///< not owned
    unsigned numPts;
    /// Not owned; null: the tables. Who exchanges a LongProgressive or a BlueProgressive for what
    /// draws from the tables calls wellstrat::buildTables() before.
    const Generator* generator;
    Order order; ///< of the domain that the contexts belong to

    /// A view of a camera's contexts, that may be filled in before or after.
    RixRNG(Array<SampleCtx> contexts, unsigned numPoints, const Generator* gen = nullptr)
        : RixRNG(contexts.first(numPoints, "RixRNG"), numPoints, gen, Order{}) {
        if (!isComputed(gen)) wellstrat::tables();
    }

    /// A view of contexts that may be filled in before or after, for the parent's generator. They
    /// may be any contexts, such as new domains of some of the parent's points, so the order is the
    /// root order, but for the parent's splits. Contexts of the parent's own slot
    /// (wellstrat/joint.h) draw padded samples of the same pattern through such a view; slots below
    /// contexts that were split by hand gain little. To keep the order, derive: see the
    /// constructors with indices.
    RixRNG(const RixRNG& parent, Array<SampleCtx> contexts, unsigned numPoints)
        : RixRNG(contexts.first(numPoints, "RixRNG"), numPoints, parent.generator,
                 parent.viewOrder()) {}

    /// The parent's own domain at some of its points, in any order: contexts[k] is a copy of the
    /// context of point indices[k], for k in [0, n). Each index is below parent.numPts; an index
    /// may occur again. The parent stays as it is. `contexts` may be the parent's own array if the
    /// indices strictly increase, as they do where paths end; what it held is overwritten then.
    /// What is written to `contexts` later is taken for the same domain.
    RixRNG(const RixRNG& parent, Array<const unsigned> indices, unsigned n,
           Array<SampleCtx> contexts)
        : RixRNG(contexts.first(n, "RixRNG"), n, parent.generator, parent.order) {
        copyFrom(parent, indices.first(n, "RixRNG"));
    }

    /// New domains of all the parent's points, in the same order, written to contexts[0, numPts).
    /// `contexts` may be the parent's own array.
    RixRNG(const RixRNG& parent, Scramble scramble, Array<SampleCtx> contexts)
        : RixRNG(parent, scramble, contexts, Split{1}) {}
    RixRNG(const RixRNG& parent, Scramble scramble, Array<SampleCtx> contexts, Distrib distrib)
        : RixRNG(contexts.first(parent.numPts, "RixRNG"), parent.numPts, parent.generator,
                 parent.childOrder(scramble, 0)) {
        parent.derive(parent.numPts, parent.sampleCtxArray, scramble, distrib, sampleCtxArray);
    }
    RixRNG(const RixRNG& parent, Scramble scramble, Array<SampleCtx> contexts, Split split)
        : RixRNG(contexts.first(parent.numPts, "RixRNG"), parent.numPts, parent.generator,
                 parent.childOrder(scramble, split.newnumsamples)) {
        parent.derive(parent.numPts, parent.sampleCtxArray, scramble, split, sampleCtxArray);
    }

    /// The same at some of the parent's points, in any order: contexts[k] is the new domain of
    /// point indices[k], for k in [0, n), as above.
    RixRNG(const RixRNG& parent, Scramble scramble, Array<const unsigned> indices, unsigned n,
           Array<SampleCtx> contexts)
        : RixRNG(parent, scramble, indices, n, contexts, Split{1}) {}
    RixRNG(const RixRNG& parent, Scramble scramble, Array<const unsigned> indices, unsigned n,
           Array<SampleCtx> contexts, Distrib distrib)
        : RixRNG(contexts.first(n, "RixRNG"), n, parent.generator, parent.childOrder(scramble, 0)) {
        copyFrom(parent, indices.first(n, "RixRNG"));
        parent.derive(n, sampleCtxArray, scramble, distrib, sampleCtxArray);
    }
    RixRNG(const RixRNG& parent, Scramble scramble, Array<const unsigned> indices, unsigned n,
           Array<SampleCtx> contexts, Split split)
        : RixRNG(contexts.first(n, "RixRNG"), n, parent.generator,
                 parent.childOrder(scramble, split.newnumsamples)) {
        copyFrom(parent, indices.first(n, "RixRNG"));
        parent.derive(n, sampleCtxArray, scramble, split, sampleCtxArray);
    }

    /// The same for a parent that is held by pointer.
    RixRNG(const RixRNG* parent, Array<SampleCtx> contexts, unsigned numPoints)
        : RixRNG(*parent, contexts, numPoints) {}
    RixRNG(const RixRNG* parent, Array<const unsigned> indices, unsigned n,
           Array<SampleCtx> contexts)
        : RixRNG(*parent, indices, n, contexts) {}
    RixRNG(const RixRNG* parent, Scramble scramble, Array<SampleCtx> contexts)
        : RixRNG(*parent, scramble, contexts) {}
    RixRNG(const RixRNG* parent, Scramble scramble, Array<SampleCtx> contexts, Distrib distrib)
        : RixRNG(*parent, scramble, contexts, distrib) {}
    RixRNG(const RixRNG* parent, Scramble scramble, Array<SampleCtx> contexts, Split split)
        : RixRNG(*parent, scramble, contexts, split) {}
    RixRNG(const RixRNG* parent, Scramble scramble, Array<const unsigned> indices, unsigned n,
           Array<SampleCtx> contexts)
        : RixRNG(*parent, scramble, indices, n, contexts) {}
    RixRNG(const RixRNG* parent, Scramble scramble, Array<const unsigned> indices, unsigned n,
           Array<SampleCtx> contexts, Distrib distrib)
        : RixRNG(*parent, scramble, indices, n, contexts, distrib) {}
    RixRNG(const RixRNG* parent, Scramble scramble, Array<const unsigned> indices, unsigned n,
           Array<SampleCtx> contexts, Split split)
        : RixRNG(*parent, scramble, indices, n, contexts, split) {}

    /// The sample of point i. z of the 3D point is the 1D sample, (x, y) the 2D sample: a 2D and a
    /// 1D draw from one context are together well stratified in 3D.
    float DrawSample1D(unsigned i) const {
        assert(i < numPts);
        const SampleCtx& sc = sampleCtxArray[i];
        switch (drawn()) {
        case Drawn::padded:
            return wellstrat::sample1D(wellstrat::builtTables(), sc.patternid, sc.sampleid);
        case Drawn::slot:
            return wellstrat::jointSample1D(wellstrat::builtTables(), sc.patternid, sc.sampleid,
                                            order.slot, 1);
        case Drawn::sequence: return wellstrat::sequenceSample1D(sc.patternid, sc.sampleid);
        case Drawn::sequenceSlot:
            return wellstrat::jointSequenceSample1D(sc.patternid, sc.sampleid, order.slot, 1);
        case Drawn::blue: return wellstrat::blueSample1D(sc.patternid, sc.sampleid);
        case Drawn::blueSlot:
            return wellstrat::blueSlotSample1D(sc.patternid, sc.sampleid, order.slot, 1);
        default: return generator->OrderedSample1D(sc, i, order);
        }
    }
    RtFloat2 DrawSample2D(unsigned i) const {
        assert(i < numPts);
        const SampleCtx& sc = sampleCtxArray[i];
        switch (drawn()) {
        case Drawn::padded:
            return wellstrat::sample2D(wellstrat::builtTables(), sc.patternid, sc.sampleid);
        case Drawn::slot:
            return wellstrat::jointSample2D(wellstrat::builtTables(), sc.patternid, sc.sampleid,
                                            order.slot, 1);
        case Drawn::sequence: return wellstrat::sequenceSample2D(sc.patternid, sc.sampleid);
        case Drawn::sequenceSlot:
            return wellstrat::jointSequenceSample2D(sc.patternid, sc.sampleid, order.slot, 1);
        case Drawn::blue: return wellstrat::blueSample2D(sc.patternid, sc.sampleid);
        case Drawn::blueSlot:
            return wellstrat::blueSlotSample2D(sc.patternid, sc.sampleid, order.slot, 1);
        default: return generator->OrderedSample2D(sc, i, order);
        }
    }
    RtFloat3 DrawSample3D(unsigned i) const {
        assert(i < numPts);
        const SampleCtx& sc = sampleCtxArray[i];
        switch (drawn()) {
        case Drawn::padded:
            return wellstrat::sample3D(wellstrat::builtTables(), sc.patternid, sc.sampleid);
        case Drawn::slot:
            return wellstrat::jointSample3D(wellstrat::builtTables(), sc.patternid, sc.sampleid,
                                            order.slot, 1);
        case Drawn::sequence: return wellstrat::sequenceSample3D(sc.patternid, sc.sampleid);
        case Drawn::sequenceSlot:
            return wellstrat::jointSequenceSample3D(sc.patternid, sc.sampleid, order.slot, 1);
        case Drawn::blue: return wellstrat::blueSample3D(sc.patternid, sc.sampleid);
        case Drawn::blueSlot:
            return wellstrat::blueSlotSample3D(sc.patternid, sc.sampleid, order.slot, 1);
        default: return generator->OrderedSample3D(sc, i, order);
        }
    }

    /// The same, and then the point's sampleid is incremented.
    float GenerateSample1D(unsigned i) {
        const float xi = DrawSample1D(i);
        ++sampleCtxArray[i].sampleid;
        return xi;
    }
    RtFloat2 GenerateSample2D(unsigned i) {
        const RtFloat2 xi = DrawSample2D(i);
        ++sampleCtxArray[i].sampleid;
        return xi;
    }
    RtFloat3 GenerateSample3D(unsigned i) {
        const RtFloat3 xi = DrawSample3D(i);
        ++sampleCtxArray[i].sampleid;
        return xi;
    }

    /// The samples of points 0 to n - 1 into xis[0, n).
    void DrawSamples1D(unsigned n, Array<float> array) const {
        assert(n <= numPts);
        float* const xis = array.first(n, "DrawSamples1D");
        if (!generator) {
            wellstrat::detail::drawSamples1D(n, sampleCtxArray, xis);
        } else if (n > 0) {
            generator->MultiOrderedSample1D(n, *sampleCtxArray, order, xis);
        }
    }
    void DrawSamples2D(unsigned n, Array<RtFloat2> array) const {
        assert(n <= numPts);
        RtFloat2* const xis = array.first(n, "DrawSamples2D");
        if (!generator) {
            wellstrat::detail::drawSamples2D(n, sampleCtxArray, xis);
        } else if (n > 0) {
            generator->MultiOrderedSample2D(n, *sampleCtxArray, order, xis);
        }
    }
    void DrawSamples3D(unsigned n, Array<RtFloat3> array) const {
        assert(n <= numPts);
        RtFloat3* const xis = array.first(n, "DrawSamples3D");
        if (!generator) {
            wellstrat::detail::drawSamples3D(n, sampleCtxArray, xis);
        } else if (n > 0) {
            generator->MultiOrderedSample3D(n, *sampleCtxArray, order, xis);
        }
    }

    /// The same, and then the sampleids of these points are incremented.
    void GenerateSamples1D(unsigned n, Array<float> xis) {
        DrawSamples1D(n, xis.first(n, "GenerateSamples1D"));
        advance(n);
    }
    void GenerateSamples2D(unsigned n, Array<RtFloat2> xis) {
        DrawSamples2D(n, xis.first(n, "GenerateSamples2D"));
        advance(n);
    }
    void GenerateSamples3D(unsigned n, Array<RtFloat3> xis) {
        DrawSamples3D(n, xis.first(n, "GenerateSamples3D"));
        advance(n);
    }

    /// The same for all points: xis[0, numPts).
    void DrawSamples1D(Array<float> xis) const { DrawSamples1D(numPts, xis); }
    void DrawSamples2D(Array<RtFloat2> xis) const { DrawSamples2D(numPts, xis); }
    void DrawSamples3D(Array<RtFloat3> xis) const { DrawSamples3D(numPts, xis); }
    void GenerateSamples1D(Array<float> xis) { GenerateSamples1D(numPts, xis); }
    void GenerateSamples2D(Array<RtFloat2> xis) { GenerateSamples2D(numPts, xis); }
    void GenerateSamples3D(Array<RtFloat3> xis) { GenerateSamples3D(numPts, xis); }

    /// A new domain of point i; see wellstrat::SampleCtx for the three kinds. A RixRNG around such
    /// contexts has no slot; the constructors with indices keep what the order has to give.
    SampleCtx NewDomain(unsigned i, Scramble scramble) const {
        return NewDomainSplit(i, scramble, 1);
    }
    SampleCtx NewDomainDistrib(unsigned i, Scramble scramble, unsigned newsampleid) const {
        assert(i < numPts);
        SampleCtx child;
        derive(1, sampleCtxArray + i, scramble, Distrib{newsampleid}, &child);
        return child;
    }
    SampleCtx NewDomainSplit(unsigned i, Scramble scramble, unsigned newnumsamples) const {
        assert(i < numPts);
        SampleCtx child;
        derive(1, sampleCtxArray + i, scramble, Split{newnumsamples}, &child);
        return child;
    }

    /// New domains of all points into out[0, numPts), which may be sampleCtxArray itself: then this
    /// becomes a RixRNG of the new domain, as far as it may change.
    void NewDomains(Scramble scramble, Array<SampleCtx> out) const {
        derive(numPts, sampleCtxArray, scramble, Split{1}, out.first(numPts, "NewDomains"));
    }
    void NewDomainsDistrib(Scramble scramble, unsigned newsampleid, Array<SampleCtx> out) const {
        derive(numPts, sampleCtxArray, scramble, Distrib{newsampleid},
               out.first(numPts, "NewDomainsDistrib"));
    }
    void NewDomainsSplit(Scramble scramble, unsigned newnumsamples, Array<SampleCtx> out) const {
        derive(numPts, sampleCtxArray, scramble, Split{newnumsamples},
               out.first(numPts, "NewDomainsSplit"));
    }

    void NewDomains(Scramble scramble, Array<SampleCtx> out) {
        NewDomainsSplit(scramble, 1, out.first(numPts, "NewDomains"));
    }
    void NewDomainsDistrib(Scramble scramble, unsigned newsampleid, Array<SampleCtx> out) {
        SampleCtx* const children = out.first(numPts, "NewDomainsDistrib");
        derive(numPts, sampleCtxArray, scramble, Distrib{newsampleid}, children);
        if (children == sampleCtxArray) order = childOrder(scramble, 0);
    }
    void NewDomainsSplit(Scramble scramble, unsigned newnumsamples, Array<SampleCtx> out) {
        SampleCtx* const children = out.first(numPts, "NewDomainsSplit");
        derive(numPts, sampleCtxArray, scramble, Split{newnumsamples}, children);
        if (children == sampleCtxArray) order = childOrder(scramble, newnumsamples);
    }

private:
    RixRNG(SampleCtx* contexts, unsigned numPoints, const Generator* gen, Order ownOrder)
        : sampleCtxArray(contexts), numPts(numPoints), generator(gen), order(ownOrder) {}

    static bool isComputed(const Generator* gen) {
        return gen && (gen->source() == Generator::Source::sequence ||
                       gen->source() == Generator::Source::blue);
    }

    /// What is drawn, where that needs no virtual call: from the tables or computed, padded or from
    /// slots without splits.
    enum class Drawn { padded, slot, sequence, sequenceSlot, blue, blueSlot, virtually };

    Drawn drawn() const {
        if (!generator) return Drawn::padded;
        const bool padded = order.slot == wellstrat::kJointSlots;
        if (!padded && (order.slot > wellstrat::kJointSlots || order.splits != 1)) {
            return Drawn::virtually;
        }
        switch (generator->source()) {
        case Generator::Source::tables: return padded ? Drawn::padded : Drawn::slot;
        case Generator::Source::sequence: return padded ? Drawn::sequence : Drawn::sequenceSlot;
        case Generator::Source::blue: return padded ? Drawn::blue : Drawn::blueSlot;
        default: return Drawn::virtually;
        }
    }

    Order childOrder(Scramble scramble, unsigned split) const {
        return generator ? generator->ChildOrder(order, scramble, split)
                         : wellstrat::deriveOrder(order, scramble, split);
    }
    Order viewOrder() const {
        return generator ? generator->ViewOrder(order) : wellstrat::viewOrder(order);
    }

    /// The new domains of n contexts of this domain, into children[0, n).
    void derive(unsigned n, const SampleCtx* parents, Scramble scramble, Split split,
                SampleCtx* children) const {
        if (!generator) {
            wellstrat::detail::newDomainsSplit(n, parents, scramble, split.newnumsamples, children);
        } else if (n > 0) {
            generator->MultiNewDomainSplit(n, *parents, order, scramble, split.newnumsamples,
                                           children);
        }
    }
    void derive(unsigned n, const SampleCtx* parents, Scramble scramble, Distrib distrib,
                SampleCtx* children) const {
        if (!generator) {
            wellstrat::detail::newDomainsDistrib(n, parents, scramble, distrib.newsampleid,
                                                 children);
        } else if (n > 0) {
            generator->MultiNewDomainDistrib(n, *parents, order, scramble, distrib.newsampleid,
                                             children);
        }
    }

    void copyFrom(const RixRNG& parent, const unsigned* indices) {
        for (unsigned k = 0; k < numPts; ++k) {
            assert(indices[k] < parent.numPts);
            assert(sampleCtxArray != parent.sampleCtxArray || indices[k] >= k);
            sampleCtxArray[k] = parent.sampleCtxArray[indices[k]];
        }
    }

    void advance(unsigned n) {
        for (unsigned i = 0; i < n; ++i) ++sampleCtxArray[i].sampleid;
    }
};
