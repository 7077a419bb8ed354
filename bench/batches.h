// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace wellstrat {

/// Registers the batch benchmarks for each target that the processor can run.
void registerBatches();

} // namespace wellstrat
