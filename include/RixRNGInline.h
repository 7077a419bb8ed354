// SPDX-License-Identifier: Apache-2.0
//
// Repeatable random numbers from two integers, without state.

#pragma once

#include "wellstrat/bits.h"
#include "wellstrat/hash.h"

/// A uniformly distributed 32-bit integer, the same for the same arguments. For a fixed `a` the
/// values for b = 0, 1, 2, ... are as good as those of a sound pseudo-random generator.
WELLSTRAT_HOST_DEVICE constexpr unsigned HashToUnsigned(unsigned a, unsigned b) {
    return wellstrat::hashPair(a, b);
}

/// The same as a float in [0, 1), for example of a patternid and a sampleid.
WELLSTRAT_HOST_DEVICE constexpr float HashToRandom(unsigned a, unsigned b) {
    return wellstrat::toUnitFloat(wellstrat::hashPair(a, b));
}
