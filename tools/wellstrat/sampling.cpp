// SPDX-License-Identifier: Apache-2.0

#include "sampling.h"

#include "errors.h"
#include "wellstrat/joint.h"
#include "wellstrat/random_generator.h"

#include <fmt/format.h>

namespace wellstrat::cli {

const std::vector<NamedGenerator>& namedGenerators() {
    static const RandomGenerator random;
    static const std::vector<NamedGenerator> generators{
        {"pmj", "well stratified, from the tables", nullptr},
        {"random", "independent random numbers", &random},
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
        names += names.empty() ? candidate.name : fmt::format(", {}", candidate.name);
    }
    throw CliError(
        fmt::format("{}: no generator is called '{}'; there are {}", option, name, names));
}

UnitPoints drawPoints(const SampleRun& run) {
    std::vector<double> values;
    values.reserve(run.count * run.dims);
    drawSamples(run, [&](const float* xi) { values.insert(values.end(), xi, xi + run.dims); });
    return {values.data(), run.count, run.dims};
}

} // namespace wellstrat::cli
