// SPDX-License-Identifier: Apache-2.0
//
// wellstrat domains: which sample domains the error of an image comes from.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/interrupt.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "common/command_line/render_commands.h"
#include "common/output/output_file.h"
#include "common/ranks/run_on_ranks.h"
#include "domains_report.h"
#include "image/run.h"
#include "image/sampling.h"
#include "scene/load.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Says which part of an image's mean squared error each sample domain of the path tracer makes alone,
and what their sum is: a floor for all generators that have the same points in each domain, such as
joint, whatever they do between domains. Errors are those of --seeds images, measured by how they
differ; the parts come from pairs of images that share the samples of one domain only.

Examples:
  wellstrat domains cornell --size 48x32
  wellstrat domains lens --size 48x32 --depth 0 --spp 1024 -o lens.json

Exit codes: 0 done, 2 error, 130 interrupted.
)";

constexpr uint64_t kMostSeeds = 1000;

struct DomainsJob {
    std::unique_ptr<tbb::global_control> threads;
    std::unique_ptr<render::Scene> scene;
    ImageSize size{};
    std::unique_ptr<OutputFile> file; ///< of rank 0, if one is asked for
};

/// Thrown where the images stop, and caught where the command ends.
struct Interrupted {};

DomainsJob prepare(const DomainsOptions& options, bool root) {
    for (const std::string& name : options.generators) renderGenerator(name);
    checkSamples(options.scene, "--spp", options.spp);
    DomainsJob job;
    if (options.output) requireSuffix("--output", *options.output, {".json"});
    if (options.output && root) job.file = std::make_unique<OutputFile>(*options.output);
    job.scene = std::make_unique<render::Scene>(loadScene(options.scene));
    if (root) sayNotes(*job.scene);
    job.size = imageSize(options.scene, *job.scene);
    // Of pmj, of all domains anew, and of one thing at a time.
    const uint64_t images = 3 * options.seeds;
    requireMemory(
        "--seeds", images * job.size.width * job.size.height * 3 * sizeof(float),
        fmt::format("{} images of {}x{} pixels", images, job.size.width, job.size.height));
    job.threads = limitThreads(options.scene);
    return job;
}

/// Makes images and measures how they differ.
class DomainRun {
public:
    DomainRun(const DomainsOptions& options, const DomainsJob& job, const Ranks& ranks)
        : options_(options), job_(job), ranks_(ranks), pmj_(images("pmj", nullptr)),
          mse_(render::covariance(pmj_, pmj_)) {
        const render::RenewedGenerator renewed{{}};
        others_ = images("pmj anew", &renewed);
    }

    DomainErrors measure() {
        DomainErrors errors{std::sqrt(mse_.value), {}, {"sum", {0, 0}}, {}};
        for (const render::PathDomain& domain :
             render::pathDomains(static_cast<unsigned>(options_.scene.depth))) {
            const render::RenewedGenerator generator{domain.scramble};
            const Images with = images(domain.name + " kept", &generator);
            if (with == others_) continue; // the picture does not use it
            errors.domains.push_back(part(domain.name, pmj_, difference(with, others_)));
            add(errors.sum.value, errors.domains.back().value);
        }
        for (const std::string& name : options_.generators) {
            const Images some = images(name, renderGenerator(name));
            errors.generators.push_back(part(name, some, some));
        }
        return errors;
    }

private:
    using Images = std::vector<render::Colors>;

    Images images(const std::string& what, const Generator* generator) {
        Images all;
        for (uint64_t k = 0; k < options_.seeds; ++k) {
            ImageRun run(options_.scene, options_.scene.seed + k, *job_.scene, job_.size, generator,
                         ranks_, fmt::format("{}, seed {}", what, k));
            if (!run.render(static_cast<uint32_t>(options_.spp))) throw Interrupted();
            all.push_back(render::colorsOf(run.film()));
        }
        return all;
    }

    /// With it, what both images share with a third, roulette and renewed domains, is no noise.
    static Images difference(Images a, const Images& b) {
        for (std::size_t k = 0; k < a.size(); ++k) {
            for (std::size_t i = 0; i < a[k].size(); ++i) a[k][i] -= b[k][i];
        }
        return a;
    }

    Part part(const std::string& name, const Images& a, const Images& b) const {
        return {name, ratio(render::covariance(a, b), mse_)};
    }

    /// Both errors as if independent: no error at all is a quotient of 0.
    static render::Measured ratio(const render::Measured& a, const render::Measured& b) {
        if (!(b.value > 0)) return {0, 0};
        const double quotient = a.value / b.value;
        return {quotient, std::hypot(a.standardError, quotient * b.standardError) / b.value};
    }

    static void add(render::Measured& sum, const render::Measured& x) {
        sum = {sum.value + x.value, std::hypot(sum.standardError, x.standardError)};
    }

    const DomainsOptions& options_;
    const DomainsJob& job_;
    const Ranks& ranks_;
    const Images pmj_; ///< with the samples that all others share some of
    const render::Measured mse_;
    Images others_; ///< that share none of them
};

int run(const DomainsOptions& options, const Ranks& ranks, const DomainsJob& job) {
    try {
        const DomainErrors errors = DomainRun(options, job, ranks).measure();
        if (!ranks.isRoot()) return 0;
        if (job.file) {
            job.file->write(domainsJson(options, job.size, errors));
            job.file->commit();
        }
        printText(domainsText(options, job.size, errors));
        return 0;
    } catch (const Interrupted&) {
        if (ranks.isRoot()) say("interrupted");
        return kExitInterrupted;
    }
}

} // namespace

void addDomains(CLI::App& app, int& exitCode) {
    CLI::App* const command = app.add_subcommand(kDomains.name, kDomains.description);
    const auto options = std::make_shared<DomainsOptions>();
    addSceneOptions(*command, options->scene)->required();
    addNumber(*command, "--spp", options->spp, {1, kMostMeasuredSamples},
              "Samples of each pixel [256]");
    addNumber(*command, "--seeds", options->seeds, {2, kMostSeeds},
              "Images of each kind, with seeds from --seed on [16]");
    addRenderGenerators(*command, options->generators,
                        "What is compared with the floor: joint, long, blue, pmj, random [joint]");
    command->add_option("-o,--output", options->output, "The numbers: FILE.json")
        ->type_name("FILE");
    command->footer(kExamples);
    command->callback([options, &exitCode] {
        options->generators = eachOnce(options->generators);
        exitCode = runOnRanks(
            [&](const Ranks& ranks) { return prepare(*options, ranks.isRoot()); },
            [&](const Ranks& ranks, DomainsJob& job) { return run(*options, ranks, job); });
    });
}

} // namespace wellstrat::cli
