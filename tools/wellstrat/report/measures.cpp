// SPDX-License-Identifier: Apache-2.0

#include "sections.h"

#include "analyze/results.h"
#include "figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace wellstrat::cli {
namespace {

std::string shortNumber(double value) { return fmt::format("{:.3g}", value); }

/// "L2 wrap-around" for wrap_around.
std::string l2Title(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    return "L2 " + name;
}

std::string starText(const StarBounds& star) {
    if (star.exact()) return errorNumber(star.lower);
    return fmt::format("{} to {}", errorNumber(star.lower), errorNumber(star.upper));
}

void addWorstPairs(ReportWriter& report) {
    constexpr std::size_t kShown = 2;
    HtmlTable table{
        "The most suspicious pairs. Their probabilities are those of a single pair: "
        "among a hundred pairs, one of 0.01 is expected.",
        {"generator", "one", "other", "correlation", "chi-square", "probability"},
        {}};
    for (const ReportSubject& subject : report.contents.subjects) {
        for (const FamilyIndependence& family : subject.inPlane.independence) {
            const std::vector<CoordinatePair>& worst = family.report.worst;
            for (std::size_t k = 0; k < std::min(kShown, worst.size()); ++k) {
                const CoordinatePair& pair = worst[k];
                table.rows.push_back(
                    {subject.title,
                     coordinateName(family, pair.first, pair.firstDim, subject.inPlane.dims),
                     coordinateName(family, pair.second, pair.secondDim, subject.inPlane.dims),
                     fmt::format("{:.3f}", pair.correlation), fmt::format("{:.2f}", pair.chiSquare),
                     shortNumber(pair.probability())});
            }
        }
    }
    report.page.table(table);
}

void addDiscrepancyTable(ReportWriter& report, Measures ReportSubject::*measures,
                         const char* space) {
    HtmlTable table{
        fmt::format("Discrepancies of the first {} points in {}: how far the share of points in a "
                    "box is from its volume, at worst (star) and in the mean (L2). Smaller is "
                    "better. The last column is the smallest distance between two points on the "
                    "torus, as a share of the largest that is possible: larger is better. The best "
                    "are marked.",
                    report.contents.size.count, space),
        {"generator", "star"},
        {}};
    for (const NamedL2& kind : kL2Kinds) table.header.push_back(l2Title(kind.name));
    table.header.emplace_back("smallest distance");
    for (const ReportSubject& subject : report.contents.subjects) {
        const Measures& found = subject.*measures;
        table.rows.push_back({subject.title, starText(*found.star)});
        std::vector<std::string>& row = table.rows.back();
        for (const std::optional<double>& value : found.l2) {
            row.push_back(value ? errorNumber(*value) : "-");
        }
        row.push_back(fmt::format("{:.3f}", packing(found).value_or(0)));
    }
    const std::size_t last = table.header.size() - 1;
    for (std::size_t c = 1; c < last; ++c) table.markBest(c, Best::least);
    table.markBest(last, Best::most);
    report.page.table(table);
}

} // namespace

void addIndependence(ReportWriter& report) {
    const Measures& first = report.contents.subjects.front().inPlane;
    report.page.section("Independence");
    report.page.paragraph(
        "A renderer combines sample i of one pattern with sample i of another: of the next pixel, "
        "the next frame, another domain of the same pixel. If they know of each other, errors do "
        "not cancel. Here each coordinate of each stream of 2D samples is tested against each "
        "coordinate of the others.");
    report.page.paragraph(
        "Streams of sequences of others are taken from their second domain, because the order of "
        "the first one is the same for all patterns. What is expected is exact for random numbers "
        "and for nets whose orders are scrambled, Owen's nested shuffles, as for others whose "
        "orders are random. Streams that depend on each other have a mean chi-square many times as "
        "large, or far below 1 if they are too even.");
    HtmlTable table{
        fmt::format("{} samples of each stream; chi-square on {} x {} cells. Spread of "
                    "correlations and mean chi-square are 1 for independent streams. The "
                    "probability is that of the worst of all pairs.",
                    first.count, first.independence.front().gridSide,
                    first.independence.front().gridSide),
        {"generator", "between", "streams", "pairs", "spread", "chi-square", "probability"},
        {}};
    for (const ReportSubject& subject : report.contents.subjects) {
        for (const FamilyIndependence& family : subject.inPlane.independence) {
            const IndependenceReport& found = family.report;
            table.rows.push_back(
                {subject.title, family.name, fmt::to_string(family.streams.size()),
                 fmt::to_string(found.pairs), fmt::format("{:.2f}", found.correlationSpread),
                 fmt::format("{:.2f}", found.meanChiSquare), shortNumber(found.probability())});
        }
    }
    report.page.table(table);
    addWorstPairs(report);
}

void addNets(ReportWriter& report) {
    const Measures& first = report.contents.subjects.front().inCube;
    report.page.section("Nets");
    report.page.paragraph(
        "Points are a (t,m,s)-net in base 2 if every elementary interval of volume 2^(t-m) holds "
        "exactly 2^t of the 2^m points. 0 is the best t; in three dimensions no sequence has less "
        "than 1.");
    HtmlTable table{fmt::format("t of the first {} points of each projection; in parentheses the "
                                "largest t of all its aligned blocks of 1, 2, 4, ... points. "
                                "Unstratified points come close to {}. The least t are marked.",
                                first.count, std::lround(std::log2(double(first.count)))),
                    {"generator"},
                    {}};
    for (const NetQuality& net : first.nets) {
        table.header.push_back(projectionName(net.projection, first.dims));
    }
    table.header.emplace_back("base-4 boxes of (x, y, z)");
    for (const ReportSubject& subject : report.contents.subjects) {
        table.rows.push_back({subject.title});
        std::vector<std::string>& row = table.rows.back();
        for (const NetQuality& net : subject.inCube.nets) {
            row.push_back(net.sequenceT ? fmt::format("{} ({})", net.t, *net.sequenceT)
                                        : fmt::to_string(net.t));
        }
        const std::optional<bool>& boxes = subject.inCube.nets.back().holdsBase4Boxes;
        row.emplace_back(!boxes ? "-" : (*boxes ? "one point each" : "not one each"));
    }
    for (std::size_t c = 1; c <= first.nets.size(); ++c) table.markBest(c, Best::least);
    report.page.table(table);
}

void addDiscrepancies(ReportWriter& report) {
    report.page.section("Discrepancies and distances");
    addDiscrepancyTable(report, &ReportSubject::inPlane, "(x, y)");
    addDiscrepancyTable(report, &ReportSubject::inCube, "(x, y, z)");
    report.page.figure(
        {{{"pair correlation of all generators",
           report.draw("pairs", pairsFigure(report.contents.subjects))}},
         "How many pairs of points lie how far apart, relative to random points, which "
         "have 1 at all distances. Below 1 near 0, points keep away from each other; bumps "
         "are preferred distances."});
}

} // namespace wellstrat::cli
