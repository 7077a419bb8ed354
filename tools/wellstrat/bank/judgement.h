// SPDX-License-Identifier: Apache-2.0
//
// How good a bank is, in tables.

#pragma once

#include "bank_search/partial_bank.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

/// The error of products over two slots relative to padding, for 4, 8, ... points. Each of
/// `products` is an integrand of one domain, for its square, or two with '*' between, for both
/// directions.
std::string judgedProducts(const bank::Bank& bank, const std::vector<std::string>& products);

/// The same for all products of integrands of study that have one domain, by the dimensions that
/// are drawn: for the first 4, 8 and 16 slots of the bank, as far as it has them.
std::string judgedDraws(const bank::Bank& bank);

} // namespace wellstrat::cli
