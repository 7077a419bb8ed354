// SPDX-License-Identifier: Apache-2.0

#include "options.h"

#include "common/command_line/generators.h"
#include "common/command_line/options.h"
#include "common/command_line/shell_word.h"
#include "study/plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(The page needs neither a network nor scripts: its pictures are in the file. It shows points over
their strata, projections, spectra, errors of integrals, independence, nets, discrepancies, and
speed if it was measured, says how to read them, and which commands give the same numbers.
Generators and integrands are those of 'wellstrat study --list'.

Examples:
  wellstrat report --quick -o report.html
  wellstrat report --generators pmj,sobol-owen --thorough
  wellstrat report --bench bench.json           after scripts/bench --json bench.json
)";

constexpr ReportEffort kQuick{" --quick", 256, 50, "pow2:4..1024,6,12,24,48,96,192,384,768"};
constexpr ReportEffort kUsual{"", 1024, 500, "pow2:4..4096,6,12,24,48,96,192,384,768,1536,3072"};
constexpr ReportEffort kThorough{" --thorough", 4096, 5000, kUsual.counts};

/// Spectra change little beyond so many patterns.
constexpr uint64_t kMaxSpectrumPatterns = 100;

std::string listWord(const std::vector<std::string>& names) {
    return shellWord(fmt::format("{}", fmt::join(names, ",")));
}

bool isAmong(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string sampleCommands(const std::string& generator) {
    std::string text;
    for (const auto& [dims, count] :
         {std::pair(2, kPlanePoints), std::pair(3, kCubePoints), std::pair(1, kLinePoints)}) {
        text += fmt::format(
            "wellstrat sample --generator {0} --count {1} --dims {2} --plot {0}-{2}d.svg\n",
            generator, count, dims);
    }
    return text;
}

std::string analyzeCommands(const std::string& generator, const ReportSize& size) {
    return fmt::format(
        "wellstrat analyze --generator {0} --dims 2 --count {1}\n"
        "wellstrat analyze --generator {0} --dims 3 --count {1} "
        "--realizations {2} --plot {0}.png\n",
        generator, size.count, size.realizations);
}

} // namespace

const ReportEffort& ReportOptions::effort() const {
    return quick ? kQuick : (thorough ? kThorough : kUsual);
}

ReportSize ReportOptions::size() const {
    return {count != 0 ? count : effort().count, std::min(patternCount(), kMaxSpectrumPatterns)};
}

ReportCommands reportCommands(const ReportOptions& options) {
    const ReportSize size = options.size();
    const std::string what =
        fmt::format("--generators {} --integrands {} --patterns {}", listWord(options.generators),
                    listWord(options.integrands), options.patternCount());
    ReportCommands commands;
    commands.page =
        fmt::format("wellstrat report {} --count {}{}", what, size.count, options.effort().option);
    if (options.bench) {
        commands.page += " --bench " + shellWord(*options.bench);
        commands.bench = "scripts/bench --json " + shellWord(*options.bench);
    }
    commands.page += " --keep-plot-files -o report.html";
    commands.study = fmt::format("wellstrat study {} --counts {} -o errors.csv --plot errors.svg",
                                 what, options.effort().counts);
    for (const NamedGenerator& generator : namedGenerators()) {
        if (!isAmong(options.generators, generator.name)) continue;
        commands.samples += sampleCommands(generator.name);
    }
    for (const std::string& generator : options.generators) {
        commands.measures += analyzeCommands(generator, size);
    }
    return commands;
}

void addReportOptions(CLI::App& command, ReportOptions& options) {
    command.add_option("-o,--output", options.output, "The page: FILE.html [report.html]")
        ->type_name("FILE");
    const auto addNames = [&](const char* flag, std::vector<std::string>& names,
                              const std::string& description) {
        command.add_option(flag, names, fmt::format("{} [{}]", description, fmt::join(names, ",")))
            ->delimiter(',')
            ->allow_extra_args(false)
            ->type_name("NAME,NAME");
    };
    addNames("--generators", options.generators, "What to compare");
    addNames("--integrands", options.integrands, "Integrands and groups");
    addNumber(command, "--patterns", options.patterns, {2, kMaxStudyPatterns},
              "Patterns of errors [500]; of spectra at most 100");
    addNumber(command, "--count", options.count, {4, kMaxReportPoints},
              "Points of all other measures, a power of two [1024]");
    CLI::Option* const quick =
        command.add_flag("--quick", options.quick, "50 patterns, 256 points, errors up to 1024");
    command.add_flag("--thorough", options.thorough, "5000 patterns, 4096 points")->excludes(quick);
    command
        .add_option("--bench", options.bench,
                    "Show the speeds in this file of scripts/bench --json FILE")
        ->type_name("FILE");
    command.add_flag("--keep-plot-files", options.keepPlotFiles,
                     "Keep the pictures, report-NAME.svg, with .dat and .gp files");
    command.footer(kExamples);
}

} // namespace wellstrat::cli
