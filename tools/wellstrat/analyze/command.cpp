// SPDX-License-Identifier: Apache-2.0
//
// wellstrat analyze: measures a point set, of files or of a generator.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "figure.h"
#include "measures.h"
#include "results.h"
#include "sample/figure.h"
#include "study/sources.h"
#include "subjects.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Measures: t as a net in base 2, of each projection; star and L2 discrepancies; distances to the
nearest point; pair correlation; spectra of each 2D projection; independence of patterns and
domains, and of the pixels and frames of generators. Spectra are the mean of all realizations,
independence is that of the first 8, all else is of the first one. The L2 discrepancies centered,
wrap-around and mixture are the square roots of what SciPy prints; star is the same.

Files hold values in [0, 1): text (one point a line, # starts a comment), NumPy arrays of float32 or
float64 with shape (points, dims), or with --format raw little-endian numbers. Points of another
program come through a pipe with "... | wellstrat analyze -". Realizations, such as patterns of
another generator, are several files or NumPy arrays with shape (patterns, points, dims).

Examples:
  wellstrat analyze --generator pmj --count 1024
  wellstrat analyze --generator random --count 256 --dims 3 --json
  wellstrat analyze --generator pmj --count 4096 --plot spectrum.png
  wellstrat analyze --generator sobol-owen --count 1024
  wellstrat analyze pixel-0.csv pixel-1.csv
  wellstrat analyze paths.csv --domains 2,2,1
)";

struct AnalyzeOptions {
    PointFiles files;
    std::optional<std::string> generator;
    uint64_t dims = 0; ///< 0: not said
    uint64_t count = 4096;
    uint64_t pattern = 0;
    uint64_t realizations = 16;
    bool json = false;
    std::optional<std::string> plot;
    bool keepPlotFiles = false;
};

/// `source` is the generator that the options name, if any.
Subject subjectOf(const AnalyzeOptions& options, const PointSource* source) {
    if (options.files.paths.empty() == !options.generator) {
        throw CliError(
            "say what to analyze: files, - for the standard input, or --generator; "
            "one of them");
    }
    if (source) {
        const unsigned dims = options.dims == 0 ? 2 : static_cast<unsigned>(options.dims);
        if (dims > 3) throw CliError(fmt::format("--dims: generators have 1 to 3, not {}", dims));
        return generatorSubject({*options.generator, dims, options.count,
                                 static_cast<uint32_t>(options.pattern), options.realizations},
                                *source);
    }
    PointFiles files = options.files;
    if (options.dims != 0) files.options.dims = static_cast<unsigned>(options.dims);
    return fileSubject(files);
}

void analyze(const AnalyzeOptions& options) {
    for (const std::string& path : options.files.paths) {
        if (path != "-") declareInput(path);
    }
    std::unique_ptr<Picture> picture;
    if (options.plot) {
        picture = std::make_unique<Picture>("--plot", *options.plot, options.keepPlotFiles);
    }
    PointSourcePtr source;
    if (options.generator) source = findStudySource("--generator", *options.generator).make();
    const Subject subject = subjectOf(options, source.get());
    const UnitPoints points = subject.set.points(0);
    if (picture && points.count() > kMaxFigurePoints) {
        throw CliError(fmt::format("--plot: at most {} points can be drawn, not {}",
                                   kMaxFigurePoints, points.count()));
    }
    if (picture && points.count() == 1 && points.dims() == 1) {
        throw CliError("--plot: there is nothing to draw of one point in one dimension");
    }
    const Measures measures = measure(subject.set);
    if (picture) {
        picture->draw(measuresFigure(measures, points));
        picture->commit();
    }
    printText(options.json ? measuresJson(measures, subject.name)
                           : measuresText(measures, oneLine(subject.name)));
}

} // namespace

void addAnalyze(CLI::App& app, int& /*exitCode*/) {
    CLI::App* const command = app.add_subcommand("analyze", "Measure a point set");
    const auto options = std::make_shared<AnalyzeOptions>();
    CLI::Option* const file =
        command->add_option("FILE", options->files.paths, "The points, - for the standard input")
            ->type_name("...");
    CLI::Option* const generator = command
                                       ->add_option("--generator", options->generator,
                                                    "A generator of 'wellstrat study --list'")
                                       ->type_name("NAME")
                                       ->excludes(file);
    addNumber(*command, "--count", options->count, {1, kMaxFilePoints}, "How many samples [4096]")
        ->needs(generator);
    addNumber(*command, "--dims", options->dims, {1, UnitPoints::kMaxDimensions},
              "Dimensions of samples [2], or of raw numbers");
    addNumber(*command, "--pattern", options->pattern, {0, kMaxWord}, "The first pattern [0]")
        ->needs(generator);
    addNumber(*command, "--realizations", options->realizations, {1, kMaxRealizations},
              "How many patterns the spectra are the mean of [16]")
        ->needs(generator);
    command
        ->add_option("--format", options->files.options.format,
                     "text, npy or raw [what the file's suffix and first bytes say]")
        ->type_name("NAME")
        ->excludes(generator);
    command
        ->add_option("--type", options->files.options.type,
                     "Of raw numbers: float32 or float64 [float32]")
        ->type_name("NAME")
        ->excludes(generator);
    command
        ->add_option("--domains", options->files.domains,
                     "Test the independence of domains: 2,2,1 splits points in 5D")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::Range(1u, UnitPoints::kMaxDimensions).description(""))
        ->type_name("DIMS,DIMS")
        ->excludes(generator);
    command->add_flag("--json", options->json, "Print JSON");
    CLI::Option* const plot =
        command
            ->add_option(
                "--plot", options->plot,
                "Draw points, spectra and pair correlation: FILE.png, FILE.svg or FILE.pdf")
            ->type_name("FILE");
    command
        ->add_flag("--keep-plot-files", options->keepPlotFiles,
                   "Keep the data (FILE.dat) and the gnuplot script (FILE.gp) of the plot")
        ->needs(plot);
    command->footer(kExamples);
    command->callback([options] { analyze(*options); });
}

} // namespace wellstrat::cli
