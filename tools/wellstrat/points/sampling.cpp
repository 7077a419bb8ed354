// SPDX-License-Identifier: Apache-2.0

#include "sampling.h"

#include <vector>

namespace wellstrat::cli {

UnitPoints drawPoints(const SampleRun& run) {
    std::vector<double> values;
    values.reserve(run.count * run.dims);
    drawSamples(run, [&](const float* xi) { values.insert(values.end(), xi, xi + run.dims); });
    return {values.data(), run.count, run.dims};
}

} // namespace wellstrat::cli
