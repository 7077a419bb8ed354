// SPDX-License-Identifier: Apache-2.0

#include "common/command_line/versions.h"
#include "output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace wellstrat::cli {
namespace {

/// The ratios of all generators with one integrand: for each generator, for each count.
using Ratios = std::vector<std::vector<double>>;

/// The ratio to the first generator. Where that one is exact, so are others, or nothing can be
/// said.
double ratio(double rmse, double first) { return first > 0 ? rmse / first : std::nan(""); }

/// Of the integrand whose curves begin at `curves`.
Ratios ratiosOf(const StudyPlan& plan, const StudyCurve* curves) {
    Ratios ratios(plan.sources.size(), std::vector<double>(plan.counts.size()));
    for (std::size_t s = 0; s < plan.sources.size(); ++s) {
        for (std::size_t c = 0; c < plan.counts.size(); ++c) {
            ratios[s][c] = ratio(curves[s].errors[c].rmse, curves[0].errors[c].rmse);
        }
    }
    return ratios;
}

Ratios geometricMeans(const std::vector<Ratios>& all) {
    Ratios means = all[0];
    for (std::size_t s = 0; s < means.size(); ++s) {
        for (std::size_t c = 0; c < means[s].size(); ++c) {
            double sum = 0;
            for (const Ratios& ratios : all) sum += std::log(ratios[s][c]);
            means[s][c] = std::exp(sum / static_cast<double>(all.size()));
        }
    }
    return means;
}

class PictureTable {
public:
    explicit PictureTable(const StudyPlan& plan) : plan_(plan) {
        for (const StudySource& source : plan.sources) {
            width_ = std::max(width_, source.name.size());
        }
    }

    void append(const std::string& title, const Ratios& ratios, std::string& text) const {
        const auto out = std::back_inserter(text);
        fmt::format_to(out, "\n{}\n{:<{}}", title, "generator", width_);
        for (const uint32_t n : plan_.counts) {
            fmt::format_to(out, " {:>7}", fmt::format("N={}", n));
        }
        text += '\n';
        for (std::size_t s = 0; s < plan_.sources.size(); ++s) {
            fmt::format_to(out, "{:<{}}", plan_.sources[s].name, width_);
            for (const double value : ratios[s]) {
                fmt::format_to(out, " {:>7}",
                               std::isnan(value) ? "-" : fmt::format("{:.3f}", value));
            }
            text += '\n';
        }
    }

private:
    const StudyPlan& plan_;
    std::size_t width_ = 9;
};

} // namespace

std::string pictureTable(const StudyPlan& plan, const StudyResult& result,
                         const std::vector<StudyCurve>& curves) {
    std::string text = fmt::format("{}\n{}, relative to {}\n", versionLine(),
                                   studyTitle(plan, result), plan.sources[0].name);
    const PictureTable table(plan);
    std::vector<Ratios> ratios;
    for (std::size_t k = 0; k < plan.integrands.size(); ++k) {
        ratios.push_back(ratiosOf(plan, &curves[k * plan.sources.size()]));
        table.append(plan.integrands[k].name, ratios.back(), text);
    }
    for (const IntegrandGroup& group : integrandPictureGroups()) {
        std::vector<Ratios> members;
        for (const std::string& name : group.members) {
            const auto found =
                std::find_if(plan.integrands.begin(), plan.integrands.end(),
                             [&](const IntegrandPicture& picture) { return picture.name == name; });
            if (found == plan.integrands.end()) break;
            members.push_back(ratios[static_cast<std::size_t>(found - plan.integrands.begin())]);
        }
        if (members.size() < group.members.size()) continue;
        table.append(fmt::format("{}, geometric mean of its {}", group.name, members.size()),
                     geometricMeans(members), text);
    }
    return text;
}

} // namespace wellstrat::cli
