// SPDX-License-Identifier: Apache-2.0
//
// What the domains of the C interface mean: a generator, and an order.

#pragma once

#include "wellstrat/c.h"
#include "wellstrat/generator.h"
#include "wellstrat/order.h"

namespace wellstrat {
inline namespace stream1 {
namespace c {

/// These throw std::invalid_argument for a domain that nobody derives.
///
/// Whose samples a domain draws. The object is there until the process has ended.
const Generator& generatorOf(wellstrat_domain domain);
/// How it was derived.
Order orderOf(wellstrat_domain domain);
/// The order in which it draws: without a slot for pmj, whose generator is that of joint.
Order drawnOrderOf(wellstrat_domain domain);

} // namespace c
} // namespace stream1
} // namespace wellstrat
