// SPDX-License-Identifier: Apache-2.0
//
// A part of the samples of an image, with what must be known to put parts together: which samples
// they are, and how they were made.

#pragma once

#include "film.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace wellstrat::render {

/// The samples from `begin` to `end` (exclusive) of each pixel.
struct SampleRange {
    uint32_t begin, end;
    /// Where rendering stopped before the end: how many samples, from `begin` on, each pixel has,
    /// row by row. Empty: all.
    std::vector<uint32_t> counts;
};

struct FilmPart {
    Film film;
    std::vector<SampleRange> ranges; ///< sorted, disjoint, none empty; those that touch are one
    std::map<std::string, std::string> settings; ///< names and values of all that decides bits
    /// Where the picture begins, at most ranges[0].begin: 0, but for later frames of a sequence.
    /// What is before it is not missing.
    uint32_t firstSample = 0;
};

/// The part of a film that was rendered from sample `begin` to `end`, if `film` has each pixel's
/// count from there.
FilmPart makePart(Film film, uint32_t begin, uint32_t end,
                  std::map<std::string, std::string> settings);

/// Adds `other` to `part`: the bits do not depend on the order. Throws std::invalid_argument, and
/// leaves `part` as it was, if sizes or settings differ or if both have the same samples. The sum
/// begins where the earlier of the two does.
void addPart(FilmPart& part, const FilmPart& other);

/// What a part lacks between its first sample and its last one, such as "samples 8:16 and some of
/// 16:24"; empty if nothing.
std::string missingSamples(const FilmPart& part);

/// The name of the first setting in which two parts differ; empty if none.
std::string differingSetting(const std::map<std::string, std::string>& a,
                             const std::map<std::string, std::string>& b);

} // namespace wellstrat::render
