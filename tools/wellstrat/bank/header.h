// SPDX-License-Identifier: Apache-2.0
//
// include/wellstrat/joint_bank.h as text.

#pragma once

#include "bank_search/slot_order.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

std::string bankHeader(const std::vector<bank::Columns>& slots);

} // namespace wellstrat::cli
