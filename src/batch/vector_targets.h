// SPDX-License-Identifier: Apache-2.0
//
// What Highway is told before it is included: for which targets to compile.

#pragma once

// Highway's own assertions would need its library.
#define HWY_IS_DEBUG_BUILD 0
// Left out: registers of no fixed size, and what gains nothing over the next target.
#define HWY_DISABLED_TARGETS                                                                       \
    (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
