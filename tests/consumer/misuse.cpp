// SPDX-License-Identifier: Apache-2.0
//
// Mistakes that the compiler must catch. Compiled with each MISUSE, which must fail, and with 0,
// which must not.

#include "RixRNG.h"

RixRNG::SampleCtx use(RixRNG& rng, const RixRNG& constant, RixRNG::SampleCtx* contexts) {
    const auto scramble = static_cast<RixRNG::Scramble>(0x5eed1234u);
#if MISUSE == 1
    rng.NewDomain(0, 0x5eed1234); // a plain integer is no scramble
#endif
#if MISUSE == 2
    rng.NewDomainSplit(0, 4, scramble); // wrong order
#endif
#if MISUSE == 3
    RixRNG child(rng, 0x5eed1234u, contexts);
#endif
#if MISUSE == 4
    const unsigned plain = scramble; // and no scramble is a plain integer
#endif
#if MISUSE == 5
    RixRNG child(rng, scramble, contexts, 4u); // split or distribution?
#endif
#if MISUSE == 6
    constant.GenerateSample2D(0); // changes the sampleid
#endif
#if MISUSE == 7
    struct Incomplete : RixRNG::Generator {
        float Sample1D(const RixRNG::SampleCtx&, unsigned) const override { return 0.0f; }
    } generator; // 2D and 3D are missing
#endif
#if MISUSE == 8
    RtFloat2 xi[1];
    constant.DrawSamples3D(xi);
#endif
#if MISUSE == 9
    contexts[0].NewDomain(42);
#endif
    RtFloat2 xi[1];
    constant.DrawSamples2D(1, xi);
    rng.GenerateSample2D(0);
    const RixRNG child(rng, scramble, contexts, RixRNG::Split{4});
    return child.NewDomainSplit(0, scramble, 4);
}
