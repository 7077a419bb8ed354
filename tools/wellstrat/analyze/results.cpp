// SPDX-License-Identifier: Apache-2.0

#include "results.h"

#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "common/command_line/versions.h"
#include "common/output/lines.h"
#include "set_summary.h"
#include "wellstrat/analysis/point_set.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace wellstrat::cli {
namespace {

/// Sections of lines, with an empty line between them.
class Report : public Lines {
public:
    void section(const char* title) { line("\n{}", title); }
};

/// The mean of a radial quantity over the frequencies from..to, both included.
double ringMean(const std::vector<double>& rings, std::size_t from, std::size_t to) {
    to = std::min(to, rings.size() - 1);
    double sum = 0;
    for (std::size_t r = from; r <= to; ++r) sum += rings[r];
    return sum / static_cast<double>(to - from + 1);
}

/// Up to half the frequency that the mean spacing of the points stands for.
std::size_t lowFrequency(std::size_t count) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(double(count)) / 2));
}

std::string yesNo(const std::optional<bool>& value) {
    if (!value) return "-";
    return *value ? "yes" : "no";
}

/// Sections of measures that were not taken are not there.
void reportSets(const Measures& measures, Report& report) {
    if (measures.sets.empty()) return;
    report.section(fmt::format("{} sets, each by itself", measures.sets.size()).c_str());
    report.line("  {:<24} {:>12} {:>12}  {}", "", "mean", "worst", "worst set");
    for (const SummaryRow& row : summaryOf(measures)) {
        report.line("  {:<24} {:>12.6g} {:>12.6g}  {}", row.measure, row.mean, row.worst,
                    oneLine(row.worstSet));
    }
    report.line("\nThe spectrum is the mean of all sets; what else follows is of the first one.");
}

void reportNets(const Measures& measures, Report& report) {
    if (!measures.choice.nets) return;
    report.section("t as a net in base 2, 0 is best");
    if (measures.nets.empty()) {
        report.line("  not there: the number of points is no power of two");
        return;
    }
    report.line("  {:<16} {:>8} {:>16} {:>16}", "projection", "t", "aligned blocks",
                "base-4 boxes");
    for (const NetQuality& net : measures.nets) {
        report.line("  {:<16} {:>8} {:>16} {:>16}", projectionName(net.projection, measures.dims),
                    net.t, net.sequenceT ? fmt::to_string(*net.sequenceT) : "-",
                    yesNo(net.holdsBase4Boxes));
    }
    if (measures.dims > PointSet::kMaxDimensions) {
        report.line("  more than {} dimensions: projections to one and two only",
                    PointSet::kMaxDimensions);
    }
}

void reportDiscrepancies(const Measures& measures, Report& report) {
    if (!measures.choice.star && !measures.choice.l2) return;
    report.section("discrepancy");
    if (measures.choice.star) {
        if (!measures.star) {
            report.line("  {:<16} not there: more than {} dimensions", "star", kMaxStarDimensions);
        } else if (measures.star->exact()) {
            report.line("  {:<16} {:.6g}", "star", measures.star->lower);
        } else {
            report.line("  {:<16} {:.6g} to {:.6g}", "star", measures.star->lower,
                        measures.star->upper);
        }
    }
    if (!measures.choice.l2) return;
    for (std::size_t k = 0; k < kL2Kinds.size(); ++k) {
        const std::string name = fmt::format("L2 {}", kL2Kinds[k].name);
        if (measures.l2[k]) {
            report.line("  {:<16} {:.6g}", name, *measures.l2[k]);
        } else {
            report.line("  {:<16} left out: more than {} points", name, kMaxSquarePoints);
        }
    }
}

void reportDistances(const Measures& measures, Report& report) {
    if (!measures.choice.distances) return;
    report.section("distance to the nearest point");
    report.line("  {:<16} {:>12} {:>12}", "", "minimum", "mean");
    for (const auto& [name, distances] :
         {std::pair("cube", *measures.onCube), std::pair("torus", *measures.onTorus)}) {
        report.line("  {:<16} {:>12.6g} {:>12.6g}", name, distances.minimum, distances.mean);
    }
    if (const auto share = packing(measures)) {
        report.line("  {:<16} {:>12.4f}", "of the largest", *share);
    }
}

void reportPairs(const Measures& measures, Report& report) {
    if (!measures.choice.pairs) return;
    report.section("pair correlation, independent points have 1");
    if (measures.dims > kMaxPairDimensions) {
        report.line("  not there: more than {} dimensions", kMaxPairDimensions);
    }
    if (!measures.pairs) return;
    const std::vector<double>& values = measures.pairs->values;
    constexpr std::size_t kRows = 12;
    const std::size_t perRow = values.size() / kRows;
    for (std::size_t k = 0; k < values.size(); k += perRow) {
        const double mean = ringMean(values, k, k + perRow - 1);
        report.line("  {:.4g} to {:.4g}  {:.4f}", static_cast<double>(k) * measures.pairs->step,
                    static_cast<double>(k + perRow) * measures.pairs->step, mean);
    }
}

void reportSpectra(const Measures& measures, Report& report) {
    if (measures.spectra.empty()) return;
    const std::size_t low = lowFrequency(measures.count);
    report.section("spectrum, independent points have 1 (0 dB)");
    report.line("  mean of {} realizations, frequencies up to {}; low ones up to {}",
                measures.realizations, measures.spectra.front().periodogram.maxFrequency(), low);
    report.line("  {:<16} {:>12} {:>12} {:>14} {:>20}", "projection", "low mean", "other mean",
                "anisotropy", "peak");
    for (const PlaneSpectrum& plane : measures.spectra) {
        const std::size_t rings = plane.radial.mean.size();
        report.line(
            "  {:<16} {:>9.1f} dB {:>9.1f} dB {:>11.1f} dB {:>20}",
            projectionName(plane.projection, measures.dims),
            decibels(ringMean(plane.radial.mean, 1, low)),
            decibels(ringMean(plane.radial.mean, low + 1, rings - 1)),
            ringMean(plane.radial.anisotropyDb, low + 1, rings - 1),
            fmt::format("{:.3g} at ({}, {})", plane.peak.power, plane.peak.fx, plane.peak.fy));
    }
}

void reportIndependence(const Measures& measures, Report& report) {
    if (measures.independence.empty()) return;
    report.section(
        "independence: probabilities are those of streams in nested random orders of their own, as "
        "random\nnumbers and scrambled nets are");
    for (const FamilyIndependence& family : measures.independence) {
        report.section(fmt::format("{}", family.name).c_str());
        report.line(
            "  {} coordinate pairs; spread of their correlations {:.3f}, mean chi-square "
            "{:.3f} on {} x {} cells (both 1 if independent)",
            family.report.pairs, family.report.correlationSpread, family.report.meanChiSquare,
            family.gridSide, family.gridSide);
        report.line("  {:<40} {:>12} {:>12} {:>12}", "worst pairs", "correlation", "chi-square",
                    "probability");
        for (const CoordinatePair& pair : family.report.worst) {
            report.line("  {:<40} {:>12.4f} {:>12.3f} {:>12.2g}",
                        coordinateName(family, pair.first, pair.firstDim, measures.dims) + " - " +
                            coordinateName(family, pair.second, pair.secondDim, measures.dims),
                        pair.correlation, pair.chiSquare, pair.probability());
        }
    }
}

} // namespace

std::string coordinateName(const FamilyIndependence& family, std::size_t stream, unsigned dim,
                           unsigned dims) {
    return fmt::format("{} {}", family.streams[stream], projectionName({dim}, dims));
}

std::optional<double> packing(const Measures& measures) {
    if (measures.dims > 3 || measures.count < 2 || !measures.onTorus) return {};
    return measures.onTorus->minimum / largestMinimumDistance(measures.count, measures.dims);
}

std::string measuresText(const Measures& measures, const std::string& subject) {
    Report report;
    report.line("{}", versionLine());
    const std::string sets =
        measures.sets.empty() ? "" : fmt::format("{} sets of ", measures.sets.size());
    report.line("{}: {}{} points in {} dimensions", subject, sets, measures.count, measures.dims);
    reportSets(measures, report);
    reportNets(measures, report);
    reportDiscrepancies(measures, report);
    reportDistances(measures, report);
    reportPairs(measures, report);
    reportSpectra(measures, report);
    reportIndependence(measures, report);
    return report.take();
}

} // namespace wellstrat::cli
