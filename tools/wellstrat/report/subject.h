// SPDX-License-Identifier: Apache-2.0
//
// What the report measures of each generator.

#pragma once

#include "analyze/measures.h"
#include "study/sources.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// Numbers of points of the pictures.
constexpr std::size_t kPlanePoints = 256, kCubePoints = 64, kLinePoints = 64;

/// The star discrepancy in three dimensions would take too long for more.
constexpr uint64_t kMaxReportPoints = 16384;

/// How much to measure.
struct ReportSize {
    uint64_t count;        ///< points of which measures are taken, a power of two
    uint64_t realizations; ///< patterns of which spectra are the mean
};

/// A generator, points of its pattern 0 and their measures. `inPlane` has independence, `inCube`
/// the spectra of `realizations`.
struct ReportSubject {
    std::string name;  ///< as options take it
    std::string title; ///< as readers see it
    std::string description;
    SampleStream line, plane, cube;
    Measures inPlane, inCube;
};

/// Measures all sources, on all cores, with a progress bar. Throws CliError for a source of points
/// that come from a file: it has no patterns enough.
std::vector<ReportSubject> measureSubjects(const std::vector<StudySource>& sources,
                                           const ReportSize& size);

} // namespace wellstrat::cli
