// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/generator.h"

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

const Generator* Generator::ForChild(Scramble /*scramble*/, unsigned /*split*/) const {
    return this;
}

} // namespace stream1
} // namespace wellstrat
