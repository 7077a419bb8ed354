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
#include "wellstrat/generator.h"

/// A view of `numPts` sample contexts that somebody else owns, and of the generator, if any, that
/// makes their samples. Small; copy it freely. The arrays and the generator must outlive it.
///
/// Points are numbered from 0; an index i must be below numPts, a count n at most numPts: neither
/// is checked. A batch of 0 points is valid. Nothing here allocates or throws, but the first RixRNG
/// of a process builds the tables (see wellstrat::buildTables). One object must not be used
/// by two threads at once if one of them generates; different objects over different arrays may.
class RixRNG {
public:
    using Scramble = wellstrat::Scramble;
    using SampleCtx = wellstrat::SampleCtx;
    using Generator = wellstrat::Generator;

    /// Tags of the deriving constructors.
    struct Distrib {
        unsigned newsampleid;
    };
    struct Split {
        unsigned newnumsamples;
    };

    SampleCtx* sampleCtxArray; ///< not owned
    unsigned numPts;
    const Generator* generator; ///< not owned; null: the tables

    /// A view of contexts that may be filled in before or after.
    RixRNG(SampleCtx* contexts, unsigned numPoints, const Generator* gen = nullptr)
        : sampleCtxArray(contexts), numPts(numPoints), generator(gen) {
        wellstrat::tables();
    }

    /// The same with the parent's generator. The contexts are left as they are, for when the points
    /// differ from the parent's in number or order. They should be of the parent's domain: a new
    /// domain may have another generator, which `Generator::ForChild` tells.
    RixRNG(const RixRNG& parent, SampleCtx* contexts, unsigned numPoints)
        : RixRNG(contexts, numPoints, parent.generator) {}

    /// New domains of all the parent's points, in the same order, written to contexts[0, numPts).
    /// `contexts` may be the parent's own array.
    RixRNG(const RixRNG& parent, Scramble scramble, SampleCtx* contexts)
        : RixRNG(contexts, parent.numPts, childGenerator(parent, scramble, 1)) {
        parent.NewDomains(scramble, contexts);
    }
    RixRNG(const RixRNG& parent, Scramble scramble, SampleCtx* contexts, Distrib distrib)
        : RixRNG(contexts, parent.numPts, childGenerator(parent, scramble, 0)) {
        parent.NewDomainsDistrib(scramble, distrib.newsampleid, contexts);
    }
    RixRNG(const RixRNG& parent, Scramble scramble, SampleCtx* contexts, Split split)
        : RixRNG(contexts, parent.numPts, childGenerator(parent, scramble, split.newnumsamples)) {
        parent.NewDomainsSplit(scramble, split.newnumsamples, contexts);
    }

    /// The same for a parent that is held by pointer.
    RixRNG(const RixRNG* parent, SampleCtx* contexts, unsigned numPoints)
        : RixRNG(*parent, contexts, numPoints) {}
    RixRNG(const RixRNG* parent, Scramble scramble, SampleCtx* contexts)
        : RixRNG(*parent, scramble, contexts) {}
    RixRNG(const RixRNG* parent, Scramble scramble, SampleCtx* contexts, Distrib distrib)
        : RixRNG(*parent, scramble, contexts, distrib) {}
    RixRNG(const RixRNG* parent, Scramble scramble, SampleCtx* contexts, Split split)
        : RixRNG(*parent, scramble, contexts, split) {}

    /// The sample of point i. z of the 3D point is the 1D sample, (x, y) the 2D sample: a 2D and a
    /// 1D draw from one context are together well stratified in 3D.
    float DrawSample1D(unsigned i) const {
        const SampleCtx& sc = sampleCtxArray[i];
        return generator ? generator->Sample1D(sc, i)
                         : wellstrat::sample1D(wellstrat::builtTables(), sc.patternid, sc.sampleid);
    }
    RtFloat2 DrawSample2D(unsigned i) const {
        const SampleCtx& sc = sampleCtxArray[i];
        return generator ? generator->Sample2D(sc, i)
                         : wellstrat::sample2D(wellstrat::builtTables(), sc.patternid, sc.sampleid);
    }
    RtFloat3 DrawSample3D(unsigned i) const {
        const SampleCtx& sc = sampleCtxArray[i];
        return generator ? generator->Sample3D(sc, i)
                         : wellstrat::sample3D(wellstrat::builtTables(), sc.patternid, sc.sampleid);
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
    void DrawSamples1D(unsigned n, float* xis) const {
        if (!generator) {
            wellstrat::drawSamples1D(n, sampleCtxArray, xis);
        } else if (n > 0) {
            generator->MultiSample1D(n, *sampleCtxArray, xis);
        }
    }
    void DrawSamples2D(unsigned n, RtFloat2* xis) const {
        if (!generator) {
            wellstrat::drawSamples2D(n, sampleCtxArray, xis);
        } else if (n > 0) {
            generator->MultiSample2D(n, *sampleCtxArray, xis);
        }
    }
    void DrawSamples3D(unsigned n, RtFloat3* xis) const {
        if (!generator) {
            wellstrat::drawSamples3D(n, sampleCtxArray, xis);
        } else if (n > 0) {
            generator->MultiSample3D(n, *sampleCtxArray, xis);
        }
    }

    /// The same, and then the sampleids of these points are incremented.
    void GenerateSamples1D(unsigned n, float* xis) {
        DrawSamples1D(n, xis);
        advance(n);
    }
    void GenerateSamples2D(unsigned n, RtFloat2* xis) {
        DrawSamples2D(n, xis);
        advance(n);
    }
    void GenerateSamples3D(unsigned n, RtFloat3* xis) {
        DrawSamples3D(n, xis);
        advance(n);
    }

    /// The same for all points: xis[0, numPts).
    void DrawSamples1D(float* xis) const { DrawSamples1D(numPts, xis); }
    void DrawSamples2D(RtFloat2* xis) const { DrawSamples2D(numPts, xis); }
    void DrawSamples3D(RtFloat3* xis) const { DrawSamples3D(numPts, xis); }
    void GenerateSamples1D(float* xis) { GenerateSamples1D(numPts, xis); }
    void GenerateSamples2D(RtFloat2* xis) { GenerateSamples2D(numPts, xis); }
    void GenerateSamples3D(RtFloat3* xis) { GenerateSamples3D(numPts, xis); }

    /// A new domain of point i; see wellstrat::SampleCtx for the three kinds.
    SampleCtx NewDomain(unsigned i, Scramble scramble) const {
        return sampleCtxArray[i].NewDomain(scramble);
    }
    SampleCtx NewDomainDistrib(unsigned i, Scramble scramble, unsigned newsampleid) const {
        return sampleCtxArray[i].NewDomainDistrib(scramble, newsampleid);
    }
    SampleCtx NewDomainSplit(unsigned i, Scramble scramble, unsigned newnumsamples) const {
        return sampleCtxArray[i].NewDomainSplit(scramble, newnumsamples);
    }

    /// New domains of all points into out[0, numPts), which may be sampleCtxArray itself.
    void NewDomains(Scramble scramble, SampleCtx* out) const {
        wellstrat::newDomains(numPts, sampleCtxArray, scramble, out);
    }
    void NewDomainsDistrib(Scramble scramble, unsigned newsampleid, SampleCtx* out) const {
        wellstrat::newDomainsDistrib(numPts, sampleCtxArray, scramble, newsampleid, out);
    }
    void NewDomainsSplit(Scramble scramble, unsigned newnumsamples, SampleCtx* out) const {
        wellstrat::newDomainsSplit(numPts, sampleCtxArray, scramble, newnumsamples, out);
    }

private:
    static const Generator* childGenerator(const RixRNG& parent, Scramble scramble,
                                           unsigned split) {
        return parent.generator ? parent.generator->ForChild(scramble, split) : nullptr;
    }

    void advance(unsigned n) {
        for (unsigned i = 0; i < n; ++i) ++sampleCtxArray[i].sampleid;
    }
};
