// SPDX-License-Identifier: Apache-2.0
//
// Single draws, inlined into the caller's loop.

#include "domains.h"
#include "wellstrat/random_generator.h"

namespace wellstrat {
namespace {

const Suite kSuite([] {
    static const RandomGenerator unstratified;
    const MakeDomain tables = cameraDomain();
    addSingle("scalar 1D", Access::coherent, tables, kDraw1D);
    addSingle("scalar 2D", Access::coherent, tables, kDraw2D);
    addSingle("scalar 3D", Access::coherent, tables, kDraw3D);
    addRounds("rounds of scalar 2D", tables);
    addSingle("scalar random 1D", Access::random, tables, kDraw1D);
    addSingle("scalar random 2D", Access::random, tables, kDraw2D);
    addSingle("scalar random 3D", Access::random, tables, kDraw3D);
    addSingle("scalar 2D by RandomGenerator", Access::coherent, cameraDomain(&unstratified),
              kDraw2D);
});

} // namespace
} // namespace wellstrat
