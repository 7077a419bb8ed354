// SPDX-License-Identifier: Apache-2.0

#include "common/output/readable_names.h"
#include "sections.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace wellstrat::cli {
namespace {

std::string slopeText(const SlopeFit& fit) {
    return std::isnan(fit.slope) ? "-" : fmt::format("{:.2f}", fit.slope);
}

/// For names of files: disk-2 for disk^2.
std::string fileWord(std::string name) {
    for (char& c : name) {
        if (c == '^' || c == '*') c = '-';
    }
    return name;
}

void addSlopes(ReportWriter& report) {
    HtmlTable table{
        "Slopes of these lines at powers of two: -0.5 is the rate of random points; "
        "-1.5 is the best for smooth integrands and -0.75 for edges in the plane. In "
        "parentheses those over all N that were measured.",
        {"integrand"},
        {}};
    const std::size_t generators = report.contents.subjects.size();
    for (const ReportSubject& subject : report.contents.subjects)
        table.header.push_back(subject.title);
    for (std::size_t i = 0; i < report.contents.curves.size(); ++i) {
        const StudyCurve& curve = report.contents.curves[i];
        if (i % generators == 0) table.rows.push_back({integrandTitle(curve.integrand->name)});
        table.rows.back().push_back(
            fmt::format("{} ({})", slopeText(curve.powersOfTwo), slopeText(curve.allCounts)));
    }
    report.page.table(table);
}

void addErrorTable(ReportWriter& report) {
    const std::vector<uint32_t>& counts = report.contents.plan.counts;
    HtmlTable table{"RMSE at some numbers of points N. The least of each integrand are marked.",
                    {"integrand", "generator"},
                    {}};
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < counts.size(); ++c) {
        const auto root = static_cast<uint32_t>(std::lround(std::sqrt(double(counts[c]))));
        if (root * root != counts[c] || (root & (root - 1)) != 0) continue;
        columns.push_back(c);
        table.header.push_back(fmt::format("N = {}", counts[c]));
    }
    const IntegrandPicture* shown = nullptr;
    for (const StudyCurve& curve : report.contents.curves) {
        const bool isFirst = std::exchange(shown, curve.integrand) != curve.integrand;
        table.rows.push_back({isFirst ? integrandTitle(curve.integrand->name) : "",
                              generatorTitle(curve.source->name)});
        for (const std::size_t c : columns) {
            table.rows.back().push_back(errorNumber(curve.errors[c].rmse));
        }
    }
    const std::size_t generators = report.contents.subjects.size();
    for (std::size_t first = 0; first < table.rows.size(); first += generators) {
        std::vector<std::size_t> ofIntegrand(generators);
        std::iota(ofIntegrand.begin(), ofIntegrand.end(), first);
        for (std::size_t c = 2; c < table.header.size(); ++c) {
            table.markBest(c, ofIntegrand, Best::least);
        }
    }
    report.page.table(table);
}

} // namespace

void addErrors(ReportWriter& report) {
    report.page.section("Errors of integrals");
    const ReportContents& contents = report.contents;
    const std::size_t generators = contents.subjects.size();
    std::vector<HtmlPicture> pictures;
    for (std::size_t first = 0; first < contents.curves.size(); first += generators) {
        const std::string& name = contents.curves[first].integrand->name;
        pictures.push_back({"error over number of points: " + integrandTitle(name),
                            report.draw("error-" + fileWord(name),
                                        studyPanel(contents.plan, contents.curves, first))});
    }
    report.page.figure(
        {pictures,
         fmt::format("The root of the mean squared error (RMSE) of the mean over N points, "
                     "over {} patterns, with 95 % confidence bands. Both axes are "
                     "logarithmic: a straight line is a power of N, and the lowest line "
                     "is the best.",
                     contents.result.patterns),
         3});
    addSlopes(report);
    addErrorTable(report);
}

} // namespace wellstrat::cli
