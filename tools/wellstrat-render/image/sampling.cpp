// SPDX-License-Identifier: Apache-2.0

#include "sampling.h"

#include "common/command_line/errors.h"
#include "common/command_line/options.h"

#include "wellstrat/joint.h"
#include "wellstrat/version.h"

#include <fmt/format.h>

#include <stdexcept>

namespace wellstrat::cli {

const std::vector<NamedGenerator>& renderGenerators() {
    static const JointProgressive joint;
    static const std::vector<NamedGenerator> generators = [] {
        std::vector<NamedGenerator> all = namedGenerators();
        all.push_back({"joint", "the tables, with domains stratified together", &joint});
        return all;
    }();
    return generators;
}

CLI::Option* addRenderGenerators(CLI::App& command, std::vector<std::string>& names,
                                 const std::string& description) {
    return command.add_option("--generators", names, description)
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("NAME,NAME");
}

const Generator* renderGenerator(const std::string& name) {
    return findGenerator("--generators", name, renderGenerators()).generator;
}

std::unique_ptr<render::Renderer> makeRenderer(const SceneOptions& options,
                                               const render::Scene& scene, ImageSize size,
                                               const Generator* generator) {
    render::SamplingOptions sampling;
    sampling.generator = generator;
    sampling.seed = static_cast<unsigned>(options.seed);
    sampling.depth = static_cast<unsigned>(options.depth);
    sampling.split = static_cast<unsigned>(options.split);
    sampling.distrib = options.distrib;
    sampling.background = !options.transparent;
    try {
        return std::make_unique<render::Renderer>(scene, size.width, size.height, sampling);
    } catch (const std::invalid_argument& error) {
        throw CliError(fmt::format("cannot render '{}': {}", options.scene, error.what()));
    }
}

std::unique_ptr<tbb::global_control> limitThreads(const SceneOptions& options) {
    if (!options.threads) return nullptr;
    return std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                 *options.threads);
}

std::map<std::string, std::string> imageSettings(const SceneOptions& options,
                                                 const std::string& fingerprint,
                                                 const std::string& generator) {
    std::map<std::string, std::string> settings{
        {"scene", fingerprint},
        {"generator", generator},
        {"stream_version", fmt::format("{}", kStreamVersion)},
        {"seed", fmt::format("{}", options.seed)},
        {"depth", fmt::format("{}", options.depth)},
        {"split", fmt::format("{}", options.split)},
        {"distrib", options.distrib ? "yes" : "no"}};
    if (options.transparent) settings["background"] = "transparent";
    return settings;
}

uint64_t mostSamples(const SceneOptions& options) { return kMaxWord / options.split; }

void checkSamples(const SceneOptions& options, const std::string& option, uint64_t samples) {
    const uint64_t most = mostSamples(options);
    if (samples <= most) return;
    throw CliError(fmt::format("{}: a pixel has at most {} samples with --split {}, not {}", option,
                               most, options.split, samples));
}

} // namespace wellstrat::cli
