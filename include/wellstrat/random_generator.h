// SPDX-License-Identifier: Apache-2.0
//
// Unstratified samples: what stratification is compared with.

#pragma once

#include "wellstrat/generator.h"
#include "wellstrat/random.h"

namespace wellstrat {
inline namespace stream1 {

/// Independent uniform samples, a pure function of the context: one hash for each coordinate.
/// Sample1D is HashToRandom(patternid, sampleid). Stateless; safe in any thread.
class RandomGenerator final : public Generator {
public:
    float Sample1D(const SampleCtx& sc, unsigned /*i*/) const override {
        return randomSample1D(sc.patternid, sc.sampleid);
    }
    Float2 Sample2D(const SampleCtx& sc, unsigned /*i*/) const override {
        return randomSample2D(sc.patternid, sc.sampleid);
    }
    Float3 Sample3D(const SampleCtx& sc, unsigned /*i*/) const override {
        return randomSample3D(sc.patternid, sc.sampleid);
    }
};

} // namespace stream1
} // namespace wellstrat
