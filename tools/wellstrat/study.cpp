// SPDX-License-Identifier: Apache-2.0
//
// wellstrat study: the error of integrals against the number of points.

#include "commands.h"
#include "errors.h"
#include "options.h"
#include "output_file.h"
#include "study_output.h"
#include "study_sources.h"
#include "study_state.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Each integrand is estimated by the mean over the first N points of each pattern; the RMSE is
over patterns 0, 1, 2, ... Integrands: 'wellstrat study --list'. A product over several domains is
written disk^3 or disk*linear; classic, edges, sines, boxes, pixels, products, 1d and 3d stand for
several. Counts: 4,16,100 or all:1..4096 or pow2:4..4096.

Ctrl-C writes the results of the patterns that are finished, and FILE.state, from which the same
command with --resume goes on (also with more --patterns). Built with MPI, the same command under
mpirun splits the work. Threads and processes change no bit of the results.

Examples:
  wellstrat study --list
  wellstrat study --integrands disk,gaussian --counts pow2:4..1024
  wellstrat study --generators pmj,halton --integrands disk^2 --counts all:1..64 -o results.csv
  wellstrat study --integrands classic --patterns 100 --plot error.svg

Exit codes: 0 done, 2 error, 130 interrupted.
)";

constexpr int kExitInterrupted = 130;

struct StudyOptions {
    std::vector<std::string> generators{"pmj", "random"};
    std::vector<std::string> integrands{"classic"};
    std::string counts = "pow2:4..4096";
    std::string table = "16,64,256,1024,4096";
    uint64_t patterns = 1000;
    uint64_t fitFrom = 16;
    uint64_t saveEvery = 30;
    std::optional<std::string> output;
    std::optional<std::string> plot;
    bool keepPlotFiles = false;
    bool resume = false;
    bool list = false;
};

std::string listText() {
    std::string text = "Generators\n";
    const auto out = std::back_inserter(text);
    const auto row = [&out](const std::string& name, const std::string& what) {
        fmt::format_to(out, "  {:<18} {}\n", name, what);
    };
    for (const StudySourceKind& kind : studySourceKinds()) row(kind.name, kind.description);
    row("file:PATH", "the points of a file, one pattern");
    text += "\nIntegrands, with the dimensions of their domains\n";
    for (const IntegrandFamily& family : integrandFamilies()) {
        row(family.name,
            fmt::format("{}  {}{}", fmt::join(family.domains, "+"), family.formula,
                        family.hasParameter ? fmt::format("; {} = {}..{}", family.name.back(),
                                                          family.first, family.last)
                                            : ""));
    }
    text += "\nProducts over domains of their own, at most 5: disk^2, disk*linear, ...\n\nGroups\n";
    for (const IntegrandGroup& group : integrandGroups()) {
        row(group.name, fmt::format("{}", fmt::join(group.members, " ")));
    }
    return text;
}

/// The files that a study writes, opened before it begins.
class StudyFiles {
public:
    explicit StudyFiles(const StudyOptions& options) {
        if (options.output) {
            json_ = *options.output != "-" &&
                    requireSuffix("--output", *options.output, {".csv", ".json"}) == ".json";
            file_ = std::make_unique<OutputFile>(*options.output);
        }
        if (options.plot) {
            picture_ = std::make_unique<Picture>("--plot", *options.plot, options.keepPlotFiles);
        }
    }

    void write(const StudyPlan& plan, const StudyResult& result,
               const std::vector<StudyCurve>& curves) {
        if (picture_) picture_->draw(studyFigure(plan, result, curves));
        if (file_) {
            file_->write((json_ ? studyJson : studyCsv)(plan, result, curves));
            file_->commit();
        }
        if (picture_) picture_->commit();
    }

private:
    bool json_ = false;
    std::unique_ptr<OutputFile> file_;
    std::unique_ptr<Picture> picture_;
};

/// The counts of --table that the plan has.
std::vector<uint32_t> tableColumns(const StudyOptions& options, const StudyPlan& plan) {
    std::vector<uint32_t> columns;
    for (const uint32_t n : parseCounts(options.table)) {
        if (std::binary_search(plan.counts.begin(), plan.counts.end(), n)) columns.push_back(n);
    }
    return columns.empty() ? std::vector<uint32_t>{plan.counts.back()} : columns;
}

bool writesToFile(const StudyOptions& options) { return options.output && *options.output != "-"; }

std::string statePath(const StudyOptions& options) { return *options.output + ".state"; }

StudyResult startOf(const StudyOptions& options, const StudyPlan& plan) {
    if (options.resume) {
        if (!writesToFile(options))
            throw CliError("--resume needs -o FILE, beside which is FILE.state");
        return loadState(statePath(options), plan);
    }
    if (writesToFile(options) && std::filesystem::exists(statePath(options))) {
        throw CliError(
            fmt::format("'{}' is of an unfinished study; go on with --resume, or remove "
                        "it",
                        statePath(options)));
    }
    return {0, std::vector<ErrorSums>(plan.cells())};
}

StudyPlan planOf(const StudyOptions& options) {
    StudyPlan plan{makeStudySources(options.generators), parseIntegrands(options.integrands),
                   parseCounts(options.counts), options.patterns};
    checkPlan(plan);
    if (options.plot && plan.integrands.size() > kMaxPlottedIntegrands) {
        throw CliError(fmt::format("--plot: at most {} integrands can be drawn, not {}",
                                   kMaxPlottedIntegrands, plan.integrands.size()));
    }
    return plan;
}

/// Saves the state now and then.
class Checkpoints {
public:
    Checkpoints(const StudyOptions& options, const StudyPlan& plan, const StudyResult& result)
        : options_(options), plan_(plan), result_(result) {}

    void maybeSave() {
        if (Clock::now() - last_ >= std::chrono::seconds(options_.saveEvery)) save();
    }
    void save() {
        if (!writesToFile(options_)) return;
        saveState(statePath(options_), plan_, result_);
        last_ = Clock::now();
    }

private:
    using Clock = std::chrono::steady_clock;
    const StudyOptions& options_;
    const StudyPlan& plan_;
    const StudyResult& result_;
    Clock::time_point last_ = Clock::now();
};

/// What rank 0 does after the run. Returns the exit code.
int finish(const StudyOptions& options, const StudyPlan& plan, const StudyResult& result,
           StudyFiles& files) {
    const bool complete = result.patterns == plan.patterns;
    if (result.patterns > 0) {
        const std::vector<StudyCurve> curves =
            studyCurves(plan, result, static_cast<uint32_t>(options.fitFrom));
        files.write(plan, result, curves);
        if (!options.output || *options.output != "-") {
            printText(studyTable(plan, result, curves, tableColumns(options, plan)));
        }
    }
    if (complete) {
        if (writesToFile(options)) std::filesystem::remove(statePath(options));
        return 0;
    }
    fmt::print(stderr, "wellstrat: interrupted after {} of {} patterns{}\n", result.patterns,
               plan.patterns, writesToFile(options) ? "; --resume goes on" : "");
    return kExitInterrupted;
}

/// A study with all that it needs. Only rank 0 has files, and what was done before.
struct Study {
    StudyPlan plan;
    StudyResult result;
    std::unique_ptr<StudyFiles> files;
};

Study prepare(const StudyOptions& options, bool root) {
    Study study{planOf(options), {}, nullptr};
    parseCounts(options.table);
    study.result.sums.resize(study.plan.cells());
    if (root) {
        study.result = startOf(options, study.plan);
        study.files = std::make_unique<StudyFiles>(options);
    }
    return study;
}

/// Errors of one process end all.
int run(const StudyOptions& options, const Ranks& ranks, Study& study) {
    try {
        Checkpoints checkpoints(options, study.plan, study.result);
        runStudy(study.plan, ranks, study.result, [&checkpoints] { checkpoints.maybeSave(); });
        if (!ranks.isRoot()) return 0;
        if (study.result.patterns < study.plan.patterns) checkpoints.save();
        return finish(options, study.plan, study.result, *study.files);
    } catch (const std::exception& error) {
        if (ranks.size() == 1) throw;
        fmt::print(stderr, "wellstrat: {}\n", oneLine(error.what()));
        ranks.abort(kExitError);
        return kExitError;
    }
}

/// What all processes find wrong, rank 0 says for all.
int studyOnRanks(const StudyOptions& options) {
    if (options.list) {
        printText(listText());
        return 0;
    }
    const Ranks ranks;
    std::optional<Study> study;
    std::exception_ptr failure;
    try {
        study.emplace(prepare(options, ranks.isRoot()));
    } catch (...) {
        failure = std::current_exception();
    }
    if (!ranks.any(failure != nullptr)) return run(options, ranks, *study);
    const bool rootFailed = ranks.fromRoot(failure != nullptr ? 1 : 0) != 0;
    if (failure && (ranks.isRoot() || !rootFailed)) std::rethrow_exception(failure);
    return kExitError;
}

void addOutputs(CLI::App& command, StudyOptions& options) {
    command
        .add_option("-o,--output", options.output,
                    "The results: FILE.csv, FILE.json, or - for CSV instead of the table")
        ->type_name("FILE");
    CLI::Option* const plot =
        command.add_option("--plot", options.plot, "Draw: FILE.png, FILE.svg or FILE.pdf")
            ->type_name("FILE");
    command
        .add_flag("--keep-plot-files", options.keepPlotFiles,
                  "Keep the data (FILE.dat) and the gnuplot script (FILE.gp) of the plot")
        ->needs(plot);
    command.add_flag("--resume", options.resume, "Go on from FILE.state");
    addNumber(command, "--save-every", options.saveEvery, {0, 86400},
              "Seconds between savings of FILE.state while it runs [30]");
}

} // namespace

void addStudy(CLI::App& app, int& exitCode) {
    CLI::App* const command =
        app.add_subcommand("study", "Measure the error of integrals against the number of points");
    const auto options = std::make_shared<StudyOptions>();
    command->add_flag("--list", options->list, "Print generators and integrands and exit");
    const auto addNames = [&](const char* flag, std::vector<std::string>& names,
                              const char* description) {
        command->add_option(flag, names, description)
            ->delimiter(',')
            ->allow_extra_args(false)
            ->type_name("NAME,NAME");
    };
    addNames("--generators", options->generators, "What draws the points [pmj,random]");
    addNames("--integrands", options->integrands, "Integrands and groups [classic]");
    command->add_option("--counts", options->counts, "Numbers of points [pow2:4..4096]")
        ->type_name("COUNTS");
    addNumber(*command, "--patterns", options->patterns, {1, kMaxStudyPatterns},
              "Patterns of each generator [1000]");
    command
        ->add_option("--table", options->table,
                     "Numbers of points in the printed table [16,64,256,1024,4096]")
        ->type_name("COUNTS");
    addNumber(*command, "--fit-from", options->fitFrom, {1, kMaxStudyPoints},
              "Fit slopes from this number of points on [16]");
    addOutputs(*command, *options);
    command->footer(kExamples);
    command->callback([options, &exitCode] { exitCode = studyOnRanks(*options); });
}

} // namespace wellstrat::cli
