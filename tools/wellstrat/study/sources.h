// SPDX-License-Identifier: Apache-2.0
//
// The generators that a study can compare.

#pragma once

#include "plan.h"

#include <functional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// A name that --generators accepts.
struct StudySourceKind {
    std::string name;
    std::string description;
    std::function<PointSourcePtr()> make;
    PixelPattern patternOf = cameraPattern; ///< in a study of pictures
};

/// All of them, but for joint:SLOT+SLOT and its kin, and file:PATH.
std::vector<StudySourceKind> studySourceKinds();

/// Samplers of others that spread errors over neighboring pixels, for studies of pictures alone.
std::vector<StudySourceKind> rivalSourceKinds();

/// The generators of GSL and Boost; none of a library that this build does not have.
std::vector<StudySourceKind> librarySourceKinds();

/// The one called `name`; "joint:3+7" is JointProgressive with slot 3 for the first domain, 7 for
/// the second, and none for others, "long:3+7" LongProgressive, "blue:3+7" BlueProgressive. Throws
/// CliError, which names `option` and all generators, if there is none.
StudySourceKind findStudySource(const std::string& option, const std::string& name);

/// The sources with these names. "file:PATH" is a file of points, of one pattern or, as a NumPy
/// array with the axes (patterns, points, coordinates), of many. Throws CliError.
std::vector<StudySource> makeStudySources(const std::vector<std::string>& names);

/// The same for studies of pictures: of generators, and of rivalSourceKinds() too, but of no files.
std::vector<StudySource> makePictureSources(const std::vector<std::string>& names);

} // namespace wellstrat::cli
