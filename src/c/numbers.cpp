// SPDX-License-Identifier: Apache-2.0
//
// Functions of the C interface: versions, hashes, and choices by a sample.

#include "RixRNGInline.h"
#include "RixShadingUtils.h"
#include "c/batch.h"
#include "c/call.h"
#include "wellstrat/c.h"
#include "wellstrat/version.h"

using namespace wellstrat;

static_assert(WELLSTRAT_C_STREAM_VERSION == kStreamVersion, "C has the version of version.h");

const char* wellstrat_version() { return WELLSTRAT_VERSION_STRING; }

uint32_t wellstrat_stream_version() { return kStreamVersion; }

uint32_t wellstrat_hash_to_unsigned(uint32_t a, uint32_t b) { return HashToUnsigned(a, b); }

float wellstrat_hash_to_random(uint32_t a, uint32_t b) { return HashToRandom(a, b); }

int wellstrat_choose_of_two_and_remap(float prob0, float* xi, uint32_t* chosen) {
    return c::guarded(__func__, [&] {
        c::checkPointer(xi, "xi");
        c::checkPointer(chosen, "chosen");
        *chosen = RixChooseAndRemap(*xi, prob0);
    });
}

int wellstrat_choose_and_remap(const float* weights, size_t n, float* xi, uint32_t* chosen,
                               float* prob) {
    return c::guarded(__func__, [&] {
        const unsigned count = c::checkedCount(n);
        c::checkPointer(weights, "weights", n);
        c::checkPointer(xi, "xi");
        c::checkPointer(chosen, "chosen");
        *chosen = RixChooseAndRemap(*xi, weights, count, prob);
    });
}
