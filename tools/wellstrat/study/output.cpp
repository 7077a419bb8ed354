// SPDX-License-Identifier: Apache-2.0

#include "output.h"

#include "common/command_line/versions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wellstrat::cli {
namespace {

bool isPowerOfTwo(uint32_t n) { return (n & (n - 1)) == 0; }

StudyCurve curveOf(const StudyPlan& plan, const StudyResult& result, std::size_t source,
                   std::size_t integrand, uint32_t fitFrom) {
    StudyCurve curve{&plan.sources[source], &plan.integrands[integrand], {}, {}, {}};
    const ErrorSums* const sums = &result.sums[plan.firstCell(source, integrand)];
    std::vector<double> rmse, rmseOfPowers;
    std::vector<uint32_t> powers;
    for (std::size_t c = 0; c < plan.counts.size(); ++c) {
        curve.errors.push_back(estimateError(sums[c], result.patterns));
        rmse.push_back(curve.errors.back().rmse);
        if (!isPowerOfTwo(plan.counts[c])) continue;
        powers.push_back(plan.counts[c]);
        rmseOfPowers.push_back(rmse.back());
    }
    curve.allCounts = fitSlope(plan.counts, rmse, fitFrom);
    curve.powersOfTwo = fitSlope(powers, rmseOfPowers, fitFrom);
    return curve;
}

std::string numberText(double value) { return std::isnan(value) ? "" : fmt::format("{}", value); }

/// As RFC 4180 quotes fields.
std::string csvField(const std::string& text) {
    if (text.find_first_of("\",\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

/// JSON has no NaN.
nlohmann::ordered_json jsonNumber(double value) {
    return std::isnan(value) ? nlohmann::ordered_json() : nlohmann::ordered_json(value);
}

nlohmann::ordered_json slopeJson(const SlopeFit& fit) {
    return {{"slope", jsonNumber(fit.slope)},
            {"standard_error", jsonNumber(fit.standardError)},
            {"points", fit.points}};
}

std::string slopeText(const SlopeFit& fit) {
    if (std::isnan(fit.slope)) return "-";
    if (std::isnan(fit.standardError)) return fmt::format("{:.3f}", fit.slope);
    return fmt::format("{:.3f} +- {:.3f}", fit.slope, fit.standardError);
}

} // namespace

std::vector<StudyCurve> studyCurves(const StudyPlan& plan, const StudyResult& result,
                                    uint32_t fitFrom) {
    std::vector<StudyCurve> curves;
    for (std::size_t integrand = 0; integrand < plan.integrands.size(); ++integrand) {
        for (std::size_t source = 0; source < plan.sources.size(); ++source) {
            curves.push_back(curveOf(plan, result, source, integrand, fitFrom));
        }
    }
    return curves;
}

std::string studyCsv(const StudyPlan& plan, const StudyResult& result,
                     const std::vector<StudyCurve>& curves) {
    std::string text = "generator,integrand,points,patterns,rmse,low,high,bias\n";
    for (const StudyCurve& curve : curves) {
        const std::string names =
            csvField(curve.source->name) + ',' + csvField(curve.integrand->name);
        for (std::size_t c = 0; c < plan.counts.size(); ++c) {
            const ErrorEstimate& error = curve.errors[c];
            fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{}\n", names,
                           plan.counts[c], result.patterns, numberText(error.rmse),
                           numberText(error.low), numberText(error.high), numberText(error.bias));
        }
    }
    return text;
}

std::string studyJson(const StudyPlan& plan, const StudyResult& result,
                      const std::vector<StudyCurve>& curves) {
    nlohmann::ordered_json json = versionedJson();
    json["patterns"] = result.patterns;
    if (plan.filter) {
        json["filter"] = plan.filter->sigma();
        json["window"] = plan.integrands[0].size;
    }
    json["points"] = plan.counts;
    json["curves"] = nlohmann::ordered_json::array();
    for (const StudyCurve& curve : curves) {
        nlohmann::ordered_json entry{{"generator", curve.source->name},
                                     {"integrand", curve.integrand->name}};
        if (!plan.filter) entry["integral"] = curve.integrand->pixels[0].integral;
        entry["slope"] = slopeJson(curve.allCounts);
        entry["slope_at_powers_of_two"] = slopeJson(curve.powersOfTwo);
        for (const ErrorEstimate& error : curve.errors) {
            entry["rmse"].push_back(error.rmse);
            entry["low"].push_back(jsonNumber(error.low));
            entry["high"].push_back(jsonNumber(error.high));
            entry["bias"].push_back(error.bias);
        }
        json["curves"].push_back(std::move(entry));
    }
    return json.dump(2) + "\n";
}

std::string studyTitle(const StudyPlan& plan, const StudyResult& result) {
    if (!plan.filter) return fmt::format("RMSE over {} patterns", result.patterns);
    return fmt::format("RMSE after a Gaussian of {} pixels over {} pictures of {}x{}",
                       plan.filter->sigma(), result.patterns, plan.integrands[0].size,
                       plan.integrands[0].size);
}

std::string studyTable(const StudyPlan& plan, const StudyResult& result,
                       const std::vector<StudyCurve>& curves,
                       const std::vector<uint32_t>& columns) {
    std::size_t width = 9;
    for (const StudySource& source : plan.sources) width = std::max(width, source.name.size());
    std::string text =
        fmt::format("{}\n{}; +- says how well a line fits, not how certain the slope is\n",
                    versionLine(), studyTitle(plan, result));
    const auto out = std::back_inserter(text);
    const IntegrandPicture* shown = nullptr;
    for (const StudyCurve& curve : curves) {
        if (curve.integrand != shown) {
            shown = curve.integrand;
            fmt::format_to(out, "\n{}, integral {:.9g}\n{:<{}}", shown->name,
                           shown->pixels[0].integral, "generator", width);
            for (const uint32_t n : columns) fmt::format_to(out, " {:>10}", fmt::format("N={}", n));
            fmt::format_to(out, "  {:<16} {}\n", "slope", "at powers of 2");
        }
        fmt::format_to(out, "{:<{}}", curve.source->name, width);
        for (const uint32_t n : columns) {
            const auto at = std::lower_bound(plan.counts.begin(), plan.counts.end(), n);
            const auto c = static_cast<std::size_t>(at - plan.counts.begin());
            fmt::format_to(out, " {:>10.3e}", curve.errors[c].rmse);
        }
        fmt::format_to(out, "  {:<16} {}\n", slopeText(curve.allCounts),
                       slopeText(curve.powersOfTwo));
    }
    return text;
}

} // namespace wellstrat::cli
