// SPDX-License-Identifier: Apache-2.0
//
// Unstratified samples: what stratification is compared with.

#pragma once

#include "wellstrat/generator.h"
#include "wellstrat/lookup.h"

namespace wellstrat {

/// Independent uniform samples, a pure function of the context: one hash for each coordinate.
/// Sample1D is HashToRandom(patternid, sampleid). Stateless; safe in any thread.
class RandomGenerator final : public Generator {
public:
    float Sample1D(const SampleCtx& sc, unsigned /*i*/) const override {
        return sample(sc, Coordinate::z);
    }
    Float2 Sample2D(const SampleCtx& sc, unsigned /*i*/) const override {
        return {sample(sc, Coordinate::x), sample(sc, Coordinate::y)};
    }
    Float3 Sample3D(const SampleCtx& sc, unsigned /*i*/) const override {
        return {sample(sc, Coordinate::x), sample(sc, Coordinate::y), sample(sc, Coordinate::z)};
    }

private:
    static float sample(const SampleCtx& sc, Coordinate coordinate) {
        return toUnitFloat(randomBits(sc.patternid, sc.sampleid, coordinate));
    }
};

} // namespace wellstrat
