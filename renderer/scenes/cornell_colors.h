// SPDX-License-Identifier: Apache-2.0
//
// The colors of the Cornell box, from its measured spectra.

#pragma once

#include "wellstrat/vector.h"

namespace wellstrat::render {

/// Linear Rec. 709. The light's is radiance, in the units of the measurement; a light of the same
/// radiance at all wavelengths would be gray. The others are reflectances under that light: what
/// a surface returns of it, divided by what a perfect reflector would. So light that is reflected
/// once has the color that the spectra give it, and light reflected more often nearly has.
struct CornellColors {
    Float3 light, white, red, green;
};

CornellColors cornellColors();

} // namespace wellstrat::render
