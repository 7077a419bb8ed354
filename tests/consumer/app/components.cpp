// SPDX-License-Identifier: Apache-2.0
//
// All components in one program: measures samples that are drawn under the linter. An exception of
// the analysis library must be caught by its type, for which shared libraries export that.

#include "all_headers.h"

#include <cstdio>

namespace {

bool rejectsNoPoints() {
    try {
        const double none = 0;
        wellstrat::UnitPoints(&none, 0, 2);
    } catch (const wellstrat::PointError&) {
        return true;
    }
    return false;
}

} // namespace

int main() {
    constexpr unsigned kPoints = 64;
    RixRNG::SampleCtx contexts[kPoints];
    for (unsigned i = 0; i < kPoints; ++i) contexts[i] = wellstrat::cameraContext(320, 200, 1, i);
    const wellstrat::DomainLinter linter;
    RtFloat2 xi[kPoints];
    RixRNG(contexts, kPoints, &linter).DrawSamples2D(xi);
    const unsigned t = wellstrat::tValue(wellstrat::PointSet::fromFloats(&xi[0].x, kPoints, 2));
    std::printf("t = %u, %s\n", t, linter.report().c_str());
    return t == 0 && linter.findings().empty() && rejectsNoPoints() ? 0 : 1;
}
