// SPDX-License-Identifier: Apache-2.0
//
// Films as files.
//
// The EXR file that keeps a film exactly has these channels:
//     R, G, B            float   the mean of the samples: what viewers show
//     count, invalid     uint    samples of the pixel; of them, those that were NaN or infinite
//     sum.red.0 ... 3    uint    the words of PixelSums::color[0], the lowest first
//     sum.green, sum.blue, sum.square   likewise
//     A, open            float, uint   where a background is transparent: what of the samples met
//                                surfaces, and how many did not
//     count.BEGIN        uint    where a range of samples is unfinished: SampleRange::counts
// and the attributes `wellstrat:samples`, such as "0:64 128:192", `wellstrat:first` where
// FilmPart::firstSample is not 0, and `wellstrat:NAME` for each setting. The same film gives the
// same bytes: there is no date.

#pragma once

#include "film_part.h"

#include <string>

namespace wellstrat::render {

/// The bytes of an EXR file that keeps all of `part`. Throws std::runtime_error.
std::string encodePart(const FilmPart& part);

/// Reads what encodePart wrote. Throws std::runtime_error, in one line without the file's name, if
/// it cannot be read, has no sums, or contradicts itself.
FilmPart readPart(const std::string& path);

} // namespace wellstrat::render
