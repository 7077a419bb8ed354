// SPDX-License-Identifier: Apache-2.0

#include "generators.h"

#include "errors.h"
#include "wellstrat/blue.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"
#include "wellstrat/random_generator.h"

#include <fmt/format.h>

#include <algorithm>

namespace wellstrat::cli {

const std::vector<NamedGenerator>& namedGenerators() {
    static const LongProgressive longSamples;
    static const RandomGenerator random;
    static const BlueProgressive blue;
    static const std::vector<NamedGenerator> generators{
        {"pmj", "well stratified, from the tables", nullptr},
        {"random", "independent random numbers", &random},
        {"long", "well stratified without end, computed", &longSamples},
        {"blue", "well stratified, together with those of neighboring pixels", &blue},
    };
    return generators;
}

const std::vector<NamedGenerator>& sampleGenerators() {
    static const std::vector<NamedGenerator> generators = [] {
        static const JointProgressive joint;
        std::vector<NamedGenerator> all = namedGenerators();
        all.push_back({"joint", "the tables in the order of slot 0 of joint stratification", &joint,
                       jointOrder(0)});
        return all;
    }();
    return generators;
}

const NamedGenerator& findGenerator(const std::string& option, const std::string& name,
                                    const std::vector<NamedGenerator>& among) {
    std::string names;
    for (const NamedGenerator& candidate : among) {
        if (name == candidate.name) return candidate;
        if (name.rfind(fmt::format("{}:", candidate.name), 0) == 0) {
            throw CliError(
                fmt::format("{}: slots, as in '{}', are for study, analyze and report; here it is "
                            "'{}'",
                            option, name, candidate.name));
        }
        names += names.empty() ? candidate.name : fmt::format(", {}", candidate.name);
    }
    throw CliError(
        fmt::format("{}: no generator is called '{}'; there are {}", option, name, names));
}

std::vector<std::string> eachOnce(const std::vector<std::string>& names) {
    std::vector<std::string> once;
    for (const std::string& name : names) {
        if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
    }
    return once;
}

} // namespace wellstrat::cli
