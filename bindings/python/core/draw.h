// SPDX-License-Identifier: Apache-2.0
//
// The samples of all generators, by one function.

#pragma once

#include "wellstrat/domain.h"
#include "wellstrat/order.h"

#include <cstddef>
#include <cstdint>

namespace python {

/// The generators, by the numbers that the package knows them by.
enum class Generator { pmj, longSequence, blue, random };

/// Which samples are drawn, and as what.
struct Drawing {
    Generator generator;
    unsigned dims; ///< 1: z; 2: x and y; 3: x, y and z
    wellstrat::Order order;
    double offset; ///< added to samples in double
};

/// xis[i * dims + k] = coordinate k of the sample of contexts[i], for i in [0, n). In float its
/// upper 24 bits, in double all that there are.
void draw(std::size_t n, const wellstrat::SampleCtx* contexts, const Drawing& drawing, float* xis);
void draw(std::size_t n, const wellstrat::SampleCtx* contexts, const Drawing& drawing, double* xis);

/// The samples first to first + count - 1 of each of several patterns.
struct Runs {
    const uint32_t* patterns;
    std::size_t count;
    uint32_t first;
};

/// The same of the samples [begin, end) of all runs, counted from the first of the first pattern.
template <typename Real>
void drawRuns(const Runs& runs, std::size_t begin, std::size_t end, const Drawing& drawing,
              Real* xis);

extern template void drawRuns(const Runs&, std::size_t, std::size_t, const Drawing&, float*);
extern template void drawRuns(const Runs&, std::size_t, std::size_t, const Drawing&, double*);

} // namespace python
