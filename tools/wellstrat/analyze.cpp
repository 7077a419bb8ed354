// SPDX-License-Identifier: Apache-2.0
//
// wellstrat analyze: measures a point set, of a file or of a generator.

#include "commands.h"
#include "errors.h"
#include "measures.h"
#include "measures_figure.h"
#include "measures_report.h"
#include "options.h"
#include "point_file.h"
#include "sample_figure.h"
#include "sampling.h"
#include "wellstrat/camera.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Measures: t as a net in base 2, of each projection; star and L2 discrepancies; distances to the
nearest point; pair correlation; spectra of each 2D projection; and of generators the independence
of patterns, pixels and domains.

Files hold values in [0, 1): text (one point a line, # starts a comment), NumPy arrays of float32 or
float64 with shape (points, dims), or with --format raw little-endian numbers. Points of another
program come through a pipe with "... | wellstrat analyze -".

Examples:
  wellstrat analyze --generator pmj --count 1024
  wellstrat analyze --generator random --count 256 --dims 3 --json
  wellstrat analyze --generator pmj --count 4096 --plot spectrum.png
)";

constexpr size_t kStreams = 8;

struct AnalyzeOptions {
    PointFileOptions file;
    std::optional<std::string> generator;
    uint64_t dims = 0; ///< 0: not said
    uint64_t count = 4096;
    uint64_t pattern = 0;
    uint64_t realizations = 16;
    bool json = false;
    std::optional<std::string> plot;
    bool keepPlotFiles = false;
};

/// A point set and its name.
struct Subject {
    std::string name;
    MeasuredSet set;
};

Subject fileSubject(const AnalyzeOptions& options) {
    PointFileOptions file = options.file;
    if (options.dims != 0) file.dims = static_cast<unsigned>(options.dims);
    const PointTable table = readPoints(file);
    const auto points =
        std::make_shared<const UnitPoints>(table.values.data(), table.count(), table.dims);
    const std::string name = file.path == "-" ? "standard input" : file.path;
    return {name, {[points](std::size_t) { return *points; }, 1, {}}};
}

/// What a generator gives for a context and its successors.
class GeneratorPoints {
public:
    GeneratorPoints(const NamedGenerator& generator, unsigned dims, uint64_t count)
        : run_{&generator, dims, 0, 0, count} {}

    UnitPoints operator()(uint32_t pattern) const {
        SampleRun run = run_;
        run.pattern = pattern;
        std::vector<double> values;
        values.reserve(run.count * run.dims);
        drawSamples(run, [&](const float* xi) { values.insert(values.end(), xi, xi + run.dims); });
        return {values.data(), run.count, run.dims};
    }

private:
    SampleRun run_;
};

/// Streams that a renderer combines: of patterns in a row, of neighboring pixels and frames, of
/// domains of one context.
std::vector<std::pair<std::string, std::vector<SampleStream>>>
streamFamilies(const GeneratorPoints& points, uint32_t pattern) {
    std::vector<SampleStream> patterns, pixels, domains;
    for (unsigned s = 0; s < kStreams; ++s) {
        patterns.push_back({fmt::format("pattern {}", pattern + s), points(pattern + s)});
        const int x = static_cast<int>(s % 2), y = static_cast<int>(s / 2 % 2);
        const unsigned frame = s / 4;
        pixels.push_back({fmt::format("pixel ({}, {}) frame {}", x, y, frame),
                          points(cameraContext(x, y, frame, 0).patternid)});
        domains.push_back(
            {fmt::format("domain {}", s),
             points(SampleCtx{pattern, 0}.NewDomain(static_cast<Scramble>(s)).patternid)});
    }
    return {{"patterns", std::move(patterns)},
            {"pixels and frames", std::move(pixels)},
            {"domains", std::move(domains)}};
}

Subject generatorSubject(const AnalyzeOptions& options) {
    const unsigned dims = options.dims == 0 ? 2 : static_cast<unsigned>(options.dims);
    if (dims > 3) throw CliError(fmt::format("--dims: generators have 1 to 3, not {}", dims));
    const NamedGenerator& generator = findGenerator("--generator", *options.generator);
    const GeneratorPoints points(generator, dims, options.count);
    const auto pattern = static_cast<uint32_t>(options.pattern);
    const auto realization = [points, pattern](std::size_t r) {
        return points(pattern + static_cast<uint32_t>(r));
    };
    return {fmt::format("{}, pattern {}", generator.name, pattern),
            {realization, options.realizations, streamFamilies(points, pattern)}};
}

void analyze(const AnalyzeOptions& options) {
    if (options.file.path.empty() == !options.generator) {
        throw CliError(
            "say what to analyze: a file, - for the standard input, or --generator; "
            "one of them");
    }
    std::unique_ptr<Picture> picture;
    if (options.plot) {
        picture = std::make_unique<Picture>("--plot", *options.plot, options.keepPlotFiles);
    }
    const Subject subject = options.generator ? generatorSubject(options) : fileSubject(options);
    const UnitPoints points = subject.set.points(0);
    if (picture && points.count() > kMaxFigurePoints) {
        throw CliError(fmt::format("--plot: at most {} points can be drawn, not {}",
                                   kMaxFigurePoints, points.count()));
    }
    if (picture && points.count() == 1 && points.dims() == 1) {
        throw CliError("--plot: there is nothing to draw of one point in one dimension");
    }
    const Measures measures = measure(subject.set);
    if (picture) picture->draw(measuresFigure(measures, points));
    printText(options.json ? measuresJson(measures, subject.name)
                           : measuresText(measures, oneLine(subject.name)));
    if (picture) picture->commit();
}

} // namespace

void addAnalyze(CLI::App& app, int& /*exitCode*/) {
    CLI::App* const command = app.add_subcommand("analyze", "Measure a point set");
    const auto options = std::make_shared<AnalyzeOptions>();
    CLI::Option* const file =
        command->add_option("FILE", options->file.path, "The points, - for the standard input")
            ->type_name("");
    CLI::Option* const generator =
        command->add_option("--generator", options->generator, "A generator instead of a file")
            ->type_name("NAME")
            ->excludes(file);
    addNumber(*command, "--count", options->count, {1, kMaxFilePoints}, "How many samples [4096]")
        ->needs(generator);
    addNumber(*command, "--dims", options->dims, {1, UnitPoints::kMaxDimensions},
              "Dimensions of samples [2], or of raw numbers");
    addNumber(*command, "--pattern", options->pattern, {0, kMaxWord}, "The first pattern [0]")
        ->needs(generator);
    addNumber(*command, "--realizations", options->realizations, {1, 4096},
              "How many patterns the spectra are the mean of [16]")
        ->needs(generator);
    command
        ->add_option("--format", options->file.format,
                     "text, npy or raw [what the file's suffix and first bytes say]")
        ->type_name("NAME")
        ->excludes(generator);
    command
        ->add_option("--type", options->file.type, "Of raw numbers: float32 or float64 [float32]")
        ->type_name("NAME")
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
