// SPDX-License-Identifier: Apache-2.0
//
// The sample domains of a path, each derived from its parent by one of these scrambles:
//
//     camera context: one pixel, one frame, one sampleid
//     |-- kPixelFilterScramble   2D  where in the picture              } wellstrat/camera.h
//     |-- kLensScramble          2D  where on the lens                 }
//     |-- kTimeScramble          1D  when                              }
//     `-- kHitScramble           --  the first hit
//         |-- kLightScramble        2D  which light, and where on it
//         |-- kEnvironmentScramble  2D  which direction of the environment
//         |-- kBxdfScramble         2D  which lobe, and which direction
//         |-- kRouletteScramble     --  does the path go on? unstratified
//         `-- kHitScramble          --  the next hit, and so on
//
// The values are hexadecimal digits of the fraction of pi, after those of wellstrat/camera.h.

#pragma once

#include <RixRNG.h>
#include <wellstrat/camera.h>

namespace wellstrat::render {

constexpr RixRNG::Scramble kHitScramble{0x03707344};
constexpr RixRNG::Scramble kLightScramble{0xa4093822};
constexpr RixRNG::Scramble kEnvironmentScramble{0x299f31d0};
constexpr RixRNG::Scramble kBxdfScramble{0x082efa98};
constexpr RixRNG::Scramble kRouletteScramble{0xec4e6c89};

} // namespace wellstrat::render
