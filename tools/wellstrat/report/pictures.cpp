// SPDX-License-Identifier: Apache-2.0

#include "sections.h"

#include "analyze/figure.h"
#include "figures.h"
#include "sample/figure.h"

#include <fmt/format.h>

#include <cmath>

namespace wellstrat::cli {
namespace {

/// The three planes of each generator's 3D points.
std::vector<HtmlPicture> projectionsOf(const ReportWriter& report) {
    constexpr const char* kPlanes[]{"xy", "xz", "yz"};
    std::vector<HtmlPicture> pictures;
    for (const ReportSubject& subject : report.contents.subjects) {
        const std::vector<Plot> plots = sampleFigures(subject.cube);
        for (std::size_t p = 0; p < plots.size(); ++p) {
            pictures.push_back(
                {fmt::format("{}: 3D points in the plane {}", subject.title, kPlanes[p]),
                 report.draw(fmt::format("projection-{}-{}", kPlanes[p], subject.name), plots[p])});
        }
    }
    return pictures;
}

} // namespace

void addPoints(ReportWriter& report) {
    report.page.section("Points");
    report.page.figure(
        {report.eachGenerator("points", "points over square strata",
                              [](const ReportSubject& s) { return sampleFigure({s.plane}); }),
         fmt::format("The first {} points of pattern 0 over {} equal squares. Of well "
                     "stratified points each square holds exactly one. The strips along "
                     "the axes show the same for {} columns and rows: blue with one "
                     "point, orange with more, blank with none.",
                     kPlanePoints, kPlanePoints, kPlanePoints),
         3});
    report.page.subsection("Projections of 3D points");
    report.page.figure(
        {projectionsOf(report),
         fmt::format("The first {} points in three dimensions, seen along each axis. "
                     "Good points look good from every side. The strips show each "
                     "coordinate alone.",
                     kCubePoints),
         3});
    report.page.subsection("1D points in their order");
    report.page.figure(
        {report.eachGenerator("order", "values over their order",
                              [](const ReportSubject& s) { return sampleFigure({s.line}); }),
         fmt::format("The first {} values in one dimension, from the first at the bottom "
                     "to the last at the top. Good values fill all {} columns and cover "
                     "the whole range again and again on the way up.",
                     kLinePoints, kLinePoints),
         3});
}

void addSpectra(ReportWriter& report) {
    const Measures& first = report.contents.subjects.front().inCube;
    report.page.section("Spectra");
    report.page.figure(
        {report.eachGenerator("spectrum", "periodograms of three planes", periodogramFigure),
         fmt::format("Power of the frequencies up to {} of {} points, the mean of {} "
                     "patterns, with frequency 0 in the middle. Gray is the power of "
                     "random points, black is none, white is twice as much or more. Dark "
                     "around the middle means a small error for smooth images; white "
                     "spots or lines are patterns that an eye can see.",
                     shownFrequency(first.spectra.front().periodogram), first.count,
                     first.realizations),
         2});
    report.page.figure(
        {{{"radial mean of all generators",
           report.draw("radial", radialFigure(report.contents.subjects))},
          {"anisotropy of all generators",
           report.draw("anisotropy", anisotropyFigure(report.contents.subjects))}},
         fmt::format("The same for (x, y) by distance from frequency 0. Left, the mean "
                     "power: random points lie at 0 dB, lower is better. Right, how much "
                     "directions differ: points alike in all directions lie at {:.0f} dB "
                     "with {} patterns, higher means that some directions are favored.",
                     -10 * std::log10(double(first.realizations)), first.realizations),
         2});
    HtmlTable table{
        "The strongest frequency of each plane, as a multiple of the power of random "
        "points. Values far above those of random points would be visible patterns.",
        {"generator"},
        {}};
    for (const PlaneSpectrum& plane : first.spectra) {
        table.header.push_back(projectionName(plane.projection, first.dims));
    }
    for (const ReportSubject& subject : report.contents.subjects) {
        table.rows.push_back({subject.title});
        for (const PlaneSpectrum& plane : subject.inCube.spectra) {
            table.rows.back().push_back(
                fmt::format("{:.3g} at ({}, {})", plane.peak.power, plane.peak.fx, plane.peak.fy));
        }
    }
    report.page.table(table);
}

} // namespace wellstrat::cli
