// SPDX-License-Identifier: Apache-2.0
//
// How fast samples are written to the memory of the current CUDA device.

#pragma once

#include "device.h"

namespace gpu_check {

/// A plain fill, each generator's 2D draws with the tables at `tables`, in memory of the device,
/// and scrambled Sobol' points of cuRAND where that was found.
std::vector<Rate> writeRates(const DeviceTables* tables);

} // namespace gpu_check
