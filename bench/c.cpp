// SPDX-License-Identifier: Apache-2.0
//
// Batches by the interface in C.

#include "wellstrat/c.h"

#include "domains.h"

namespace wellstrat {
namespace {

constexpr auto kDrawAll2DInC = +[](const RixRNG& rng, RtFloat2* xis) {
    const wellstrat_domain domain = {WELLSTRAT_PMJ, WELLSTRAT_NO_SLOT, 1};
    const auto* contexts = reinterpret_cast<const wellstrat_context*>(rng.sampleCtxArray);
    wellstrat_draw_samples_2d(domain, rng.numPts, contexts, &xis->x);
};

const Suite kSuite([] {
    addBatch("in C, coherent 2D", {16, 256, 4096, 65536}, Access::coherent, cameraDomain(),
             kDrawAll2DInC);
});

} // namespace
} // namespace wellstrat
