// SPDX-License-Identifier: Apache-2.0
//
// wellstrat study: the error of integrals against the number of points.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/interrupt.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "common/output/output_file.h"
#include "common/output/savings.h"
#include "common/ranks/run_on_ranks.h"
#include "options.h"
#include "output.h"
#include "sources.h"
#include "state.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace wellstrat::cli {
namespace {

std::string listText() {
    std::string text = "Generators\n";
    const auto out = std::back_inserter(text);
    const auto row = [&out](const std::string& name, const std::string& what) {
        fmt::format_to(out, "  {:<18} {}\n", name, what);
    };
    for (const StudySourceKind& kind : studySourceKinds()) row(kind.name, kind.description);
    row("joint:3+7", "the same with these slots, for as many domains");
    row("long:3+7", "long with these slots");
    row("blue:3+7", "blue with these slots");
    row("file:PATH", "the points of a file; NumPy arrays may hold many patterns");
    text += "\nIntegrands, with the dimensions of their domains\n";
    for (const IntegrandFamily& family : integrandFamilies()) {
        row(family.name,
            fmt::format("{}  {}{}", fmt::join(family.domains, "+"), family.formula,
                        family.hasParameter ? fmt::format("; {} = {}..{}", family.name.back(),
                                                          family.first, family.last)
                                            : ""));
    }
    text += "\nProducts over domains of their own, at most 5: disk^2, disk*linear, ...\n\nGroups\n";
    const auto rowsOf = [&row](const std::vector<IntegrandGroup>& groups) {
        for (const IntegrandGroup& group : groups) {
            row(group.name, fmt::format("{}", fmt::join(group.members, " ")));
        }
    };
    rowsOf(integrandGroups());
    text += "\nWith --filter: more generators\n";
    for (const StudySourceKind& kind : rivalSourceKinds()) row(kind.name, kind.description);
    text += "\nWith --filter: integrands of pixel (X, Y), u = sin(X / 40) and v = sin(Y / 40)\n";
    for (const IntegrandPictureKind& kind : integrandPictureKinds()) {
        row(kind.name, fmt::format("{}  {}", fmt::join(kind.domains, "+"), kind.formula));
    }
    text += "\nWith --filter: groups\n";
    rowsOf(integrandPictureGroups());
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

StudyResult startOf(const StudyOptions& options, const StudyPlan& plan) {
    if (options.resume) {
        if (!options.writesToFile())
            throw CliError("--resume needs -o FILE, beside which is FILE.state");
        return loadState(options.statePath(), plan);
    }
    std::error_code ignored;
    if (options.writesToFile() && std::filesystem::exists(options.statePath(), ignored) &&
        !isFinished(options.statePath())) {
        throw CliError(
            fmt::format("'{}' is of an unfinished study; go on with --resume, or remove "
                        "it",
                        options.statePath()));
    }
    return {0, std::vector<ErrorSums>(plan.cells())};
}

StudyPlan picturePlan(const StudyOptions& options) {
    const GaussianFilter filter(*options.filter);
    if (options.window <= 2 * filter.border()) {
        throw CliError(fmt::format(
            "--window: with --filter {} there must be more than {} pixels a side, not {}",
            filter.sigma(), 2 * filter.border(), options.window));
    }
    StudyPlan plan{makePictureSources(options.generators),
                   parsePictures(options.integrands, static_cast<unsigned>(options.window)),
                   parseCounts(*options.counts), *options.patterns, filter};
    if (plan.patterns > kMaxStudyPictures) {
        throw CliError(
            fmt::format("--patterns: with --filter there are at most {} pictures, not {}",
                        kMaxStudyPictures, plan.patterns));
    }
    if (plan.counts.size() > kMaxPictureCounts) {
        throw CliError(fmt::format("--counts: with --filter at most {} numbers of points, not {}",
                                   kMaxPictureCounts, plan.counts.size()));
    }
    return plan;
}

StudyPlan planOf(const StudyOptions& options) {
    StudyPlan plan = options.filter ? picturePlan(options)
                                    : StudyPlan{makeStudySources(options.generators),
                                                parseIntegrands(options.integrands),
                                                parseCounts(*options.counts), *options.patterns};
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
        if (!options_.writesToFile() || result_.patterns == 0) return;
        savings_.attempt([this] { saveState(options_.statePath(), plan_, result_); });
        last_ = Clock::now();
    }
    /// Whether the state of now is there to go on from.
    bool isSaved() const {
        return options_.writesToFile() && result_.patterns > 0 && !savings_.failing();
    }

private:
    using Clock = std::chrono::steady_clock;
    const StudyOptions& options_;
    const StudyPlan& plan_;
    const StudyResult& result_;
    Clock::time_point last_ = Clock::now();
    Savings savings_;
};

/// A study with all that it needs. Only rank 0 has files, and what was done before.
struct Study {
    StudyPlan plan;
    StudyResult result;
    std::unique_ptr<StudyFiles> files;
};

/// What a study counts.
const char* unitOf(const StudyPlan& plan) { return plan.filter ? "pictures" : "patterns"; }

/// Writes the results of what is finished, which rank 0 does after the run.
void writeResults(const StudyOptions& options, const Study& study) {
    if (study.result.patterns == 0) return;
    const std::vector<StudyCurve> curves =
        studyCurves(study.plan, study.result, static_cast<uint32_t>(options.fitFrom));
    study.files->write(study.plan, study.result, curves);
    if (!options.output || *options.output != "-") {
        printText(study.plan.filter ? pictureTable(study.plan, study.result, curves)
                                    : studyTable(study.plan, study.result, curves,
                                                 tableColumns(options, study.plan)));
    }
}

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

int run(const StudyOptions& options, const Ranks& ranks, Study& study) {
    Checkpoints checkpoints(options, study.plan, study.result);
    try {
        runStudy(study.plan, ranks, study.result, [&checkpoints] { checkpoints.maybeSave(); });
    } catch (const std::exception& error) {
        if (ranks.size() > 1) throw;
        checkpoints.save();
        writeResults(options, study);
        throw CliError(fmt::format("{}; after {} of {} {}", messageOf(error), study.result.patterns,
                                   study.plan.patterns, unitOf(study.plan)));
    }
    if (!ranks.isRoot()) return 0;
    checkpoints.save();
    writeResults(options, study);
    if (study.result.patterns == study.plan.patterns) return 0;
    say("interrupted after {} of {} {}{}", study.result.patterns, study.plan.patterns,
        unitOf(study.plan), checkpoints.isSaved() ? "; --resume goes on" : "");
    return kExitInterrupted;
}

int studyOnRanks(const StudyOptions& options) {
    if (options.list) {
        if (launchedRank() == 0) printText(listText());
        return 0;
    }
    return runOnRanks([&](const Ranks& ranks) { return prepare(options, ranks.isRoot()); },
                      [&](const Ranks& ranks, Study& study) { return run(options, ranks, study); });
}

} // namespace

void addStudy(CLI::App& app, int& exitCode) {
    CLI::App* const command =
        app.add_subcommand("study", "Measure the error of integrals against the number of points");
    const auto options = std::make_shared<StudyOptions>();
    addStudyOptions(*command, *options);
    command->callback([options, &exitCode] {
        options->setDefaults();
        exitCode = studyOnRanks(*options);
    });
}

} // namespace wellstrat::cli
