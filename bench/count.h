// SPDX-License-Identifier: Apache-2.0
//
// Ways to draw samples, for a program that counts instructions.

#pragma once

#include "RixRNG.h"

#include <vector>

namespace wellstrat {

/// What the draws read and write, all of one length.
struct CountedArrays {
    std::vector<SampleCtx> contexts, children;
    std::vector<RtFloat2> xis;
    std::vector<RtFloat3> points;

    RixRNG rng(const Generator* generator = nullptr) {
        return RixRNG(contexts.data(), static_cast<unsigned>(contexts.size()), generator);
    }
};

/// A way to draw as many samples as the arrays have elements. Constructed before main.
struct CountedPath {
    CountedPath(const char* name, void (*draw)(CountedArrays& arrays));
};

/// Draws `samples` samples in the way that is called `path`; "nothing" only makes their contexts.
/// False, after a line that says which there are, if there is no such way.
bool drawForCounting(const char* path, unsigned samples);

} // namespace wellstrat
