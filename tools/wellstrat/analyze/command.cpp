// SPDX-License-Identifier: Apache-2.0
//
// wellstrat analyze: measures a point set, of files or of a generator.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "common/command_line/progress.h"
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
domains, and of the pixels and frames of generators. The L2 discrepancies centered, wrap-around and
mixture are the square roots of what SciPy prints; star is the same. --no-... leaves measures out.

Files hold values in [0, 1) in 1 to 64 dimensions: text (one point a line, after a line of names
if there is one; # begins a comment), NumPy arrays with shape (points, dims), UTK's binary files,
or with --format raw little-endian numbers; all of them may be compressed by gzip. Unsigned
integers are fractions of 2^bits, or what --scale says. "... | wellstrat analyze -" reads a pipe.

Several sets are several files, text with a line of nothing but # between sets, NumPy arrays with
shape (sets, points, dims), or UTK's. Each is measured by itself; mean and worst of all come first.
Spectra are the mean of all sets or patterns, independence is that of the first 8.

Examples:
  wellstrat analyze --generator pmj --count 1024
  wellstrat analyze --generator random --count 256 --dims 3 --json
  wellstrat analyze --generator pmj --count 4096 --plot spectrum.png
  wellstrat analyze --generator sobol-owen --count 1024
  wellstrat analyze pixel-0.csv pixel-1.csv
  wellstrat analyze pixel-0.csv --no-star --no-l2
  wellstrat analyze paths.csv --domains 2,2,1
)";

struct AnalyzeOptions {
    PointFiles files;
    std::optional<std::string> generator;
    uint64_t dims = 0; ///< 0: not said
    uint64_t count = 4096;
    uint64_t pattern = 0;
    uint64_t realizations = 16;
    MeasureChoice choice;
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
    const bool planes = options.choice.spectra && points.dims() > 1;
    const bool pairs =
        options.choice.pairs && points.dims() <= kMaxPairDimensions && points.count() > 1;
    if (picture && !planes && !pairs) {
        throw CliError("--plot: there is nothing to draw without spectra and pair correlation");
    }
    Measures measures;
    {
        ProgressBar progress("measures");
        measures =
            measure(subject.set, options.choice, [&](double share) { progress.show(share); });
    }
    if (picture) {
        picture->draw(measuresFigure(measures, points));
        picture->commit();
    }
    printText(options.json ? measuresJson(measures, subject.name)
                           : measuresText(measures, oneLine(subject.name)));
}

/// An option for each measure.
void addChoice(CLI::App& command, MeasureChoice& choice) {
    const auto addLeftOut = [&](const char* option, bool& measure, const char* what) {
        command.add_flag_callback(
            option, [&measure] { measure = false; }, fmt::format("Leave out {}", what));
    };
    addLeftOut("--no-nets", choice.nets, "t as a net");
    addLeftOut("--no-star", choice.star, "the star discrepancy");
    addLeftOut("--no-l2", choice.l2, "the L2 discrepancies");
    addLeftOut("--no-distances", choice.distances, "the distances to the nearest point");
    addLeftOut("--no-pairs", choice.pairs, "the pair correlation");
    addLeftOut("--no-spectra", choice.spectra, "the spectra");
    addLeftOut("--no-independence", choice.independence, "independence");
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
                     "text, npy, raw or utk [what the file's suffix and first bytes say]")
        ->type_name("NAME")
        ->excludes(generator);
    command
        ->add_option("--type", options->files.options.type,
                     "Of raw numbers: floatN, uintN or intN with N bits [float32]")
        ->type_name("NAME")
        ->excludes(generator);
    command
        ->add_option("--scale", options->files.options.scale,
                     "Multiplies the numbers of files: 2^-32, 0.5 [1, or see below]")
        ->type_name("FACTOR")
        ->excludes(generator);
    command
        ->add_option("--domains", options->files.domains,
                     "Test the independence of domains: 2,2,1 splits points in 5D")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::Range(1u, UnitPoints::kMaxDimensions).description(""))
        ->type_name("DIMS,DIMS")
        ->excludes(generator);
    addChoice(*command, options->choice);
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
