// SPDX-License-Identifier: Apache-2.0
//
// A scramble from a bit pattern, and the domains of a bxdf and of the lights that it keeps apart.

#include "RixRNG.h"
#include "check.h"

#include <type_traits>

// The compiler must not take an integer in place of a scramble, nor a scramble in place of one.
static_assert(!std::is_convertible<unsigned, RixRNG::Scramble>::value, "");
static_assert(!std::is_convertible<RixRNG::Scramble, unsigned>::value, "");
static_assert(sizeof(RixRNG::Scramble) == sizeof(unsigned), "");

int main() {
    const RixRNG::Scramble bxdfScramble = static_cast<RixRNG::Scramble>(0x6b43a9b5);
    const RixRNG::Scramble lightScramble = static_cast<RixRNG::Scramble>(0xf1c0ffee);

    RixRNG::SampleCtx camera[3] = {{11, 0}, {12, 0}, {13, 5}};
    RixRNG parent(camera, 3);
    RixRNG::SampleCtx bxdf[3], lights[3], bxdfAgain[3];
    RixRNG bxdfRng(parent, bxdfScramble, bxdf);
    RixRNG lightRng(&parent, lightScramble, lights);
    parent.NewDomains(bxdfScramble, bxdfAgain);

    for (unsigned i = 0; i < 3; i++) {
        CHECK(bxdf[i].patternid != lights[i].patternid);
        CHECK(bxdf[i].patternid != camera[i].patternid);
        CHECK(bxdf[i].patternid == bxdfAgain[i].patternid);
        CHECK(bxdf[i].sampleid == camera[i].sampleid);
        CHECK(bxdfRng.DrawSample2D(i) != lightRng.DrawSample2D(i));
    }
    return exitCode();
}
