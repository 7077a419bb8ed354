// SPDX-License-Identifier: Apache-2.0
//
// The sections of the report.

#pragma once

#include "bench.h"
#include "common/output/html_page.h"
#include "common/output/picture.h"
#include "study/output.h"
#include "subject.h"

#include <fmt/format.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// All that was measured.
struct ReportContents {
    ReportSize size;
    std::vector<ReportSubject> subjects;
    const StudyPlan& plan;
    const StudyResult& result;
    std::vector<StudyCurve> curves;
};

/// Draws a plot and returns the picture's bytes. The name, such as "points-pmj", is for the files
/// that are kept.
using DrawReportPlot = std::function<std::string(const std::string& name, const Plot& plot)>;

/// The page, with what its sections are made of.
struct ReportWriter {
    const ReportContents& contents;
    const DrawReportPlot& draw;
    HtmlPage& page;

    /// A picture for each generator. The description says what it shows.
    template <typename MakePlot>
    std::vector<HtmlPicture> eachGenerator(const std::string& name, const std::string& description,
                                           MakePlot makePlot) const {
        std::vector<HtmlPicture> pictures;
        for (const ReportSubject& subject : contents.subjects) {
            pictures.push_back({subject.title + ": " + description,
                                draw(name + "-" + subject.name, makePlot(subject))});
        }
        return pictures;
    }
};

/// How many pictures the sections have, beside one for each integrand.
constexpr std::size_t kPicturesPerGenerator = 6, kOtherPictures = 4;

void addPoints(ReportWriter& report);
void addSpectra(ReportWriter& report);
void addErrors(ReportWriter& report);
void addIndependence(ReportWriter& report);
void addNets(ReportWriter& report);
void addDiscrepancies(ReportWriter& report);
void addSpeed(ReportWriter& report, const BenchResults& bench);

/// Small numbers as all tables show them: three digits.
inline std::string errorNumber(double value) { return fmt::format("{:#.3g}", value); }

} // namespace wellstrat::cli
