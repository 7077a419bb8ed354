// SPDX-License-Identifier: Apache-2.0
//
// A bank of slots: 2, then 4, 8 and 16 of them, so that fewer slots are better ones.

#pragma once

#include "bank_search/insertion.h"

#include <functional>

namespace wellstrat::bank {

struct SearchOptions {
    uint32_t seed = 1;
    unsigned rounds = 150;  ///< of improvement, at each size
    std::size_t slots = 16; ///< the first so many, at least 2; they do not depend on the others
    unsigned width = 2;     ///< of the beam
};

/// A bank of `slots` slots, of which slot 0 is the identity. The same for the same options on every
/// machine and with any number of threads. Calls `progress` with the part that is done, in [0, 1].
Bank searchBank(const SearchOptions& options, const std::function<void(double)>& progress);

} // namespace wellstrat::bank
