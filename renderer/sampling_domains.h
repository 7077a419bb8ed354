// SPDX-License-Identifier: Apache-2.0
//
// The sample domains of a path, each derived from its parent by one of these scrambles:
//
//     camera context: one pixel, one seed, one sampleid
//     |-- kPixelFilterScramble  2D  where in the picture
//     |-- kLensScramble         2D  where on the lens
//     |-- kTimeScramble         1D  when
//     `-- kHitScramble          --  the first hit, bounce 0
//         |-- lightScramble(bounce)        2D  which light, and where on it
//         |-- environmentScramble(bounce)  2D  which direction of the environment
//         |-- bxdfScramble(bounce)         2D  which lobe, and which direction
//         |-- kRouletteScramble            --  does the path go on? unstratified
//         |-- kPassageScramble             --  does it pass what is not all there? so, too, from
//         |                                    the camera; unstratified
//         `-- kHitScramble                 --  the next hit, and so on
//
// All that is stratified has a slot of wellstrat/joint.h, as far as there are slots: a
// JointProgressive stratifies these domains together, and to other generators their scrambles are
// like any others. No two domains of a path have the same slot, which is why the scrambles of a
// hit depend on the bounce. The first slots are the safest together, and those who need them get
// them: see "Slots" in README.md.

#pragma once

#include <RixRNG.h>
#include <wellstrat/joint.h>

namespace wellstrat::render {

// The domains of wellstrat/camera.h under its names, which these hide: slots in place of its
// scrambles.
constexpr RixRNG::Scramble kPixelFilterScramble = jointScramble(0);
constexpr RixRNG::Scramble kLensScramble = jointScramble(1);
constexpr RixRNG::Scramble kTimeScramble = jointScramble(4);

/// The slot of the light, before that of the bxdf: the first hit comes before the time, and each
/// later one has three slots of its own. What exceeds 15 is padded.
constexpr unsigned firstSlot(unsigned bounce) { return bounce == 0 ? 2 : 3 + 3 * bounce; }

constexpr RixRNG::Scramble lightScramble(unsigned bounce) {
    return jointScramble(firstSlot(bounce));
}
constexpr RixRNG::Scramble bxdfScramble(unsigned bounce) {
    return jointScramble(firstSlot(bounce) + 1);
}
constexpr RixRNG::Scramble environmentScramble(unsigned bounce) {
    return jointScramble(5 + 3 * bounce);
}

// Not drawn from, or not stratified: hexadecimal digits of the fraction of pi, so that nobody has
// chosen them.
constexpr RixRNG::Scramble kHitScramble{0x03707344};
constexpr RixRNG::Scramble kRouletteScramble{0xec4e6c89};
constexpr RixRNG::Scramble kPassageScramble{0x452821e6};

} // namespace wellstrat::render
