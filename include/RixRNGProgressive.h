// SPDX-License-Identifier: Apache-2.0
//
// Lookups in the tables of progressive samples, for those who need no RixRNG object. The meaning of
// a sample and the scalar code are in wellstrat/lookup.h, the compiled batch code in
// wellstrat/batch.h.

#pragma once

#include "RiTypesHelper.h"
#include "wellstrat/batch.h"
#include "wellstrat/lookup.h"

/// Sample `sampleid` of pattern `patternid`, in [0, 1) in each dimension. Any two integers are
/// valid; from sampleid 196608 on the samples are unstratified.
inline float RixProgressiveSample1D(unsigned patternid, unsigned sampleid) {
    return wellstrat::sample1D(patternid, sampleid);
}
inline RtFloat2 RixProgressiveSample2D(unsigned patternid, unsigned sampleid) {
    return wellstrat::sample2D(patternid, sampleid);
}
inline RtFloat3 RixProgressiveSample3D(unsigned patternid, unsigned sampleid) {
    return wellstrat::sample3D(patternid, sampleid);
}

/// The samples of n contexts.
inline void RixProgressiveSamples1D(unsigned n,
                                    wellstrat::ArrayArgument<const wellstrat::SampleCtx> contexts,
                                    wellstrat::ArrayArgument<float> xis) {
    wellstrat::drawSamples1D(n, contexts, xis);
}
inline void RixProgressiveSamples2D(unsigned n,
                                    wellstrat::ArrayArgument<const wellstrat::SampleCtx> contexts,
                                    wellstrat::ArrayArgument<RtFloat2> xis) {
    wellstrat::drawSamples2D(n, contexts, xis);
}
inline void RixProgressiveSamples3D(unsigned n,
                                    wellstrat::ArrayArgument<const wellstrat::SampleCtx> contexts,
                                    wellstrat::ArrayArgument<RtFloat3> xis) {
    wellstrat::drawSamples3D(n, contexts, xis);
}
