// SPDX-License-Identifier: Apache-2.0
//
// What a study is to measure.

#pragma once

#include "wellstrat/analysis/picture_error.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// A source of points with the name that --generators gave.
struct StudySource {
    std::string name;
    PointSourcePtr source;
    PixelPattern patternOf = cameraPattern; ///< in a study of pictures
    std::string description = {};           ///< for readers; none of a file
};

/// The errors of patterns 0 to patterns - 1, each by itself; or, with a filter, what is left after
/// it of the errors of pictures 0 to patterns - 1.
struct StudyPlan {
    std::vector<StudySource> sources;
    std::vector<IntegrandPicture> integrands; ///< without a filter of one pixel
    std::vector<uint32_t> counts;             ///< in ascending order
    uint64_t patterns;
    std::optional<GaussianFilter> filter = {};

    /// The sums of a study are for each source, in it for each integrand, in it for each count.
    std::size_t cells() const { return sources.size() * integrands.size() * counts.size(); }
    std::size_t firstCell(std::size_t source, std::size_t integrand) const {
        return (source * integrands.size() + integrand) * counts.size();
    }
};

constexpr uint32_t kMaxStudyPoints = uint32_t{1} << 20;
constexpr uint64_t kMaxStudyPatterns = uint64_t{1} << 32;
constexpr uint64_t kMaxStudyPictures = uint64_t{1} << 16;
constexpr std::size_t kMaxPictureCounts = 64;

/// The numbers of points that `text` stands for: "all:A..B", "pow2:A..B", or numbers and such
/// ranges with commas between. Throws CliError.
std::vector<uint32_t> parseCounts(const std::string& text);

/// The integrands with these names; groups are written out and repetitions dropped. Throws
/// CliError.
std::vector<IntegrandPicture> parseIntegrands(const std::vector<std::string>& names);

/// The same for pictures of size x size pixels.
std::vector<IntegrandPicture> parsePictures(const std::vector<std::string>& names, unsigned size);

/// Throws CliError if one of the sources cannot do what is planned.
void checkPlan(const StudyPlan& plan);

} // namespace wellstrat::cli
