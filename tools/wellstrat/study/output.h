// SPDX-License-Identifier: Apache-2.0
//
// The results of a study as a table, as CSV and JSON, and as a picture.

#pragma once

#include "common/output/picture.h"
#include "run.h"

#include <string>
#include <vector>

namespace wellstrat::cli {

/// One generator with one integrand.
struct StudyCurve {
    const StudySource* source;
    const IntegrandPicture* integrand;
    std::vector<ErrorEstimate> errors; ///< for each of the plan's counts
    SlopeFit allCounts, powersOfTwo;   ///< from the counts from the study's first one to fit on
};

/// The curves of all integrands, those of one integrand together. `fitFrom` is the first count
/// that takes part in the fits. `result.patterns` is at least 1.
std::vector<StudyCurve> studyCurves(const StudyPlan& plan, const StudyResult& result,
                                    uint32_t fitFrom);

/// A line for each curve and count: generator, integrand, points, patterns, rmse, low, high, bias.
/// Numbers have all their digits. A band that does not exist is empty.
std::string studyCsv(const StudyPlan& plan, const StudyResult& result,
                     const std::vector<StudyCurve>& curves);

/// The same with formulas, integrals and slopes.
std::string studyJson(const StudyPlan& plan, const StudyResult& result,
                      const std::vector<StudyCurve>& curves);

/// What the errors are, such as "RMSE over 60 patterns".
std::string studyTitle(const StudyPlan& plan, const StudyResult& result);

/// Of pictures: the ratio of the RMSE to that of the plan's first generator, at all counts, and the
/// geometric means over groups of integrands that are there.
std::string pictureTable(const StudyPlan& plan, const StudyResult& result,
                         const std::vector<StudyCurve>& curves);

/// The RMSE at the counts `columns`, all of the plan, and the slopes, for readers.
std::string studyTable(const StudyPlan& plan, const StudyResult& result,
                       const std::vector<StudyCurve>& curves, const std::vector<uint32_t>& columns);

constexpr std::size_t kMaxPlottedIntegrands = 36;

/// A panel for each integrand, at most kMaxPlottedIntegrands, with the RMSE of all generators over
/// the number of points and their bands.
Plot studyFigure(const StudyPlan& plan, const StudyResult& result,
                 const std::vector<StudyCurve>& curves);

/// One of these panels: that of the integrand whose curves begin at `first`.
Plot studyPanel(const StudyPlan& plan, const std::vector<StudyCurve>& curves, std::size_t first);

} // namespace wellstrat::cli
