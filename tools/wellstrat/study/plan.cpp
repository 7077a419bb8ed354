// SPDX-License-Identifier: Apache-2.0

#include "plan.h"

#include "common/command_line/errors.h"
#include "common/command_line/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace wellstrat::cli {
namespace {

constexpr NumberRange kCountRange{1, kMaxStudyPoints};

CliError countError(const std::string& text) {
    return CliError(
        fmt::format("--counts: neither a number, nor all:A..B, nor pow2:A..B, with "
                    "numbers from {} to {}, A <= B: '{}'",
                    kCountRange.min, kCountRange.max, text));
}

/// Adds a number, or the numbers of a range.
void addCounts(const std::string& text, std::set<uint32_t>& counts) {
    uint64_t first = 0, last = 0;
    if (parseNumber(text, kCountRange, first)) {
        counts.insert(static_cast<uint32_t>(first));
        return;
    }
    const size_t colon = text.find(':'), dots = text.find("..");
    if (colon == std::string::npos || dots == std::string::npos || dots < colon) {
        throw countError(text);
    }
    const std::string kind = text.substr(0, colon);
    if ((kind != "all" && kind != "pow2") ||
        !parseNumber(text.substr(colon + 1, dots - colon - 1), kCountRange, first) ||
        !parseNumber(text.substr(dots + 2), kCountRange, last) || first > last) {
        throw countError(text);
    }
    for (uint64_t n = kind == "all" ? first : 1; n <= last; n = kind == "all" ? n + 1 : 2 * n) {
        if (n >= first) counts.insert(static_cast<uint32_t>(n));
    }
}

/// The names, groups written out and repetitions dropped.
std::vector<std::string> ungrouped(const std::vector<std::string>& names,
                                   const std::vector<IntegrandGroup>& groups) {
    std::vector<std::string> all;
    const auto add = [&all](const std::string& name) {
        if (std::find(all.begin(), all.end(), name) == all.end()) all.push_back(name);
    };
    for (const std::string& name : names) {
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const auto& g) { return g.name == name; });
        if (group == groups.end()) {
            add(name);
        } else {
            for (const std::string& member : group->members) add(member);
        }
    }
    return all;
}

/// What make(name) gives for each name.
template <typename Make>
std::vector<IntegrandPicture> makeAll(const std::vector<std::string>& names, Make make) {
    std::vector<IntegrandPicture> integrands;
    try {
        for (const std::string& name : names) integrands.push_back(make(name));
    } catch (const std::invalid_argument& error) {
        throw CliError(fmt::format("--integrands: {}; see 'wellstrat study --list'", error.what()));
    }
    return integrands;
}

} // namespace

std::vector<uint32_t> parseCounts(const std::string& text) {
    std::set<uint32_t> counts;
    std::istringstream parts(text);
    for (std::string part; std::getline(parts, part, ',');) addCounts(part, counts);
    if (counts.empty()) throw countError(text);
    return {counts.begin(), counts.end()};
}

std::vector<IntegrandPicture> parseIntegrands(const std::vector<std::string>& names) {
    return makeAll(ungrouped(names, integrandGroups()), [](const std::string& name) {
        Integrand integrand = makeIntegrand(name);
        return IntegrandPicture{name, integrand.domains, 1, {std::move(integrand)}};
    });
}

std::vector<IntegrandPicture> parsePictures(const std::vector<std::string>& names, unsigned size) {
    return makeAll(ungrouped(names, integrandPictureGroups()),
                   [size](const std::string& name) { return makeIntegrandPicture(name, size); });
}

void checkPlan(const StudyPlan& plan) {
    for (const StudySource& source : plan.sources) {
        for (const IntegrandPicture& integrand : plan.integrands) {
            try {
                source.source->check(integrand.domains, plan.counts.back(), plan.patterns);
            } catch (const std::invalid_argument& error) {
                throw CliError(fmt::format("--generators: {} with the integrand {}: {}",
                                           source.name, integrand.name, error.what()));
            }
        }
    }
}

} // namespace wellstrat::cli
