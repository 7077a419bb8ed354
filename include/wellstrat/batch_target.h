// SPDX-License-Identifier: Apache-2.0
//
// Which instruction set the batch functions use. The first batch chooses the best one that the
// processor has; the samples are the same bits with any. For tests, measurements and curiosity.

#pragma once

#include "wellstrat/platform.h"

namespace wellstrat {
inline namespace stream1 {

/// The name of the index-th target that this processor can run, best first, or null beyond the
/// last. The last is "scalar". A static string.
WELLSTRAT_API const char* batchTarget(unsigned index);

/// The target in use.
WELLSTRAT_API const char* chosenBatchTarget();

/// From now on uses the target with this name in all threads. False, and nothing changes, if this
/// processor has none of that name.
WELLSTRAT_API bool forceBatchTarget(const char* name);

} // namespace stream1
} // namespace wellstrat
