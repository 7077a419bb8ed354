// SPDX-License-Identifier: Apache-2.0
//
// Films as pictures for the eye.

#pragma once

#include "film.h"

#include <string>

namespace wellstrat::render {

/// How the light of a film becomes that of a screen.
struct Display {
    float exposure = 0;    ///< stops: light counts 2^exposure times
    bool isFilmic = false; ///< bright light fades to white along a curve; else it is cut off at 1
};

/// The color of the screen, in [0, 1], linear. The filmic curve is that of Narkowicz 2015, "ACES
/// Filmic Tone Mapping Curve", https://knarkowicz.wordpress.com/2016/01/06, for each channel.
Float3 displayed(Float3 light, const Display& display);

/// The bytes of a file that shows the means: ".png" and ".jpg" (".jpeg") in sRGB with 8 bits as
/// `display` says; as they are ".hdr" in Radiance's RGBE and ".exr" in float. Where the film is
/// transparent, .png and .exr have alpha: colors are not multiplied by it in .png, and are in .exr
/// and in formats without. Throws std::runtime_error, also for other suffixes.
std::string encodePicture(const Film& film, const std::string& suffix, const Display& display = {});

} // namespace wellstrat::render
