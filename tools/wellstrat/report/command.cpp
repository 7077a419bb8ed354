// SPDX-License-Identifier: Apache-2.0
//
// wellstrat report: a page that shows generators in pictures and tables.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/interrupt.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "common/command_line/progress.h"
#include "common/command_line/versions.h"
#include "common/output/output_file.h"
#include "common/output/page_plots.h"
#include "common/ranks/run_on_ranks.h"
#include "options.h"
#include "sections.h"
#include "verdict.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr std::size_t kMaxGenerators = 12;
constexpr uint32_t kFitFrom = 16;

void checkOptions(const ReportOptions& options) {
    const uint64_t count = options.size().count;
    if ((count & (count - 1)) != 0) {
        throw CliError(fmt::format("--count: {} is no power of two", count));
    }
    if (options.generators.size() > kMaxGenerators) {
        throw CliError(fmt::format("--generators: at most {} can be compared, not {}",
                                   kMaxGenerators, options.generators.size()));
    }
}

StudyPlan planOf(const ReportOptions& options) {
    StudyPlan plan{makeStudySources(options.generators), parseIntegrands(options.integrands),
                   parseCounts(options.effort().counts), options.patternCount()};
    if (plan.integrands.size() > kMaxPlottedIntegrands) {
        throw CliError(fmt::format("--integrands: at most {} can be drawn, not {}",
                                   kMaxPlottedIntegrands, plan.integrands.size()));
    }
    checkPlan(plan);
    return plan;
}

void addGenerators(const std::vector<ReportSubject>& subjects, HtmlPage& page) {
    HtmlTable table{"What is compared.", {"generator", "its points", "name in commands"}, {}};
    for (const ReportSubject& subject : subjects) {
        table.rows.push_back({subject.title, subject.description, "`" + subject.name + "`"});
    }
    page.table(table);
}

void addCommands(const ReportOptions& options, HtmlPage& page) {
    const ReportCommands commands = reportCommands(options);
    const auto add = [&page](const char* what, const std::string& lines) {
        if (lines.empty()) return;
        page.paragraph(what);
        page.code(lines);
    };
    page.section("How to make this again");
    add("The page, and beside it the data and the gnuplot script of each picture:", commands.page);
    add("Errors of integrals, with all digits:", commands.study);
    add("Points of our own generators:", commands.samples);
    add("Measures: in the plane independence and discrepancies; in three dimensions spectra, "
        "nets and discrepancies:",
        commands.measures);
    add("Speed, on the machine at hand:", commands.bench);
    page.paragraph(versionLine() +
                   ". The same stream version has the same samples on every machine, and the "
                   "numbers do not depend on how many threads compute them.");
}

std::string pageOf(const ReportOptions& options, const ReportContents& contents,
                   const std::optional<BenchResults>& bench, const DrawReportPlot& draw) {
    HtmlPage page("Samples in pictures and numbers", verdictOf(contents),
                  fmt::format("How well {} generators of samples distribute their points, and what "
                              "that does to the error of integrals. Made by {}.",
                              contents.subjects.size(), versionLine()));
    ReportWriter report{contents, draw, page};
    addGenerators(contents.subjects, page);
    addPoints(report);
    addSpectra(report);
    addErrors(report);
    addIndependence(report);
    addNets(report);
    addDiscrepancies(report);
    if (bench) addSpeed(report, *bench);
    addCommands(options, page);
    return page.finish();
}

/// A report with all that it needs. Only rank 0 has the file.
struct Report {
    std::optional<BenchResults> bench;
    StudyPlan plan;
    std::unique_ptr<OutputFile> file;
};

Report prepare(const ReportOptions& options, bool root) {
    checkOptions(options);
    requireSuffix("--output", options.output, {".html"});
    Report report;
    if (options.bench) report.bench = readBench(*options.bench);
    report.plan = planOf(options);
    if (root) report.file = std::make_unique<OutputFile>(options.output);
    return report;
}

int run(const ReportOptions& options, const Ranks& ranks, const Report& report) {
    const StudyPlan& plan = report.plan;
    StudyResult result{0, std::vector<ErrorSums>(plan.cells())};
    runStudy(plan, ranks, result, [] {});
    if (!ranks.isRoot()) return 0;
    if (result.patterns < plan.patterns) {
        say("interrupted");
        return kExitInterrupted;
    }
    const ReportContents contents{options.size(), measureSubjects(plan.sources, options.size()),
                                  plan, result, studyCurves(plan, result, kFitFrom)};
    PagePlots plots(options.output, options.keepPlotFiles);
    ProgressBar progress("pictures");
    const std::size_t pictures =
        kPicturesPerGenerator * plan.sources.size() + plan.integrands.size() + kOtherPictures;
    std::size_t done = 0;
    const DrawReportPlot draw = [&](const std::string& name, const Plot& plot) {
        progress.show(static_cast<double>(++done) / static_cast<double>(pictures));
        return plots.draw(name, plot);
    };
    report.file->write(pageOf(options, contents, report.bench, draw));
    report.file->commit();
    plots.commit();
    return 0;
}

} // namespace

void addReport(CLI::App& app, int& exitCode) {
    CLI::App* const command =
        app.add_subcommand("report", "Show generators in pictures and tables, as one HTML page");
    const auto options = std::make_shared<ReportOptions>();
    addReportOptions(*command, *options);
    command->callback([options, &exitCode] {
        exitCode = runOnRanks(
            [&](const Ranks& ranks) { return prepare(*options, ranks.isRoot()); },
            [&](const Ranks& ranks, const Report& report) { return run(*options, ranks, report); });
    });
}

} // namespace wellstrat::cli
