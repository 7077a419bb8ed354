// SPDX-License-Identifier: Apache-2.0
//
// wellstrat sample: writes and draws samples.

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/options.h"
#include "common/command_line/progress.h"
#include "figure.h"
#include "formats.h"
#include "points/sampling.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <unistd.h>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(A 2D sample is (x, y) of the 3D sample with the same number, a 1D sample is its z.
Formats: csv has a line for each sample and digits enough to give the same float again; npy is an
array of float32 and shape (count, dims); json states beside the points how to draw them again.
With --plot, samples are written only if -o or --format is given. The strips along the axes of a
plot show the 1D strata: blue with one point, orange with more, blank with none.

Examples:
  wellstrat sample --dims 2 --count 16
  wellstrat sample --dims 3 --count 4096 --pattern 0xc0ffee -o points.npy
  wellstrat sample --dims 1 --count 64 --first 4096 --format json
  wellstrat sample --dims 2 --count 1024 --plot points.png
  wellstrat sample --compare random,pmj --count 256 --plot compare.png
)";

constexpr uint64_t kSampleIds = uint64_t{1} << 32;

struct SampleOptions {
    uint64_t dims = 2;
    uint64_t count = 0;
    uint64_t first = 0;
    uint64_t pattern = 0;
    std::string generator = "pmj";
    std::vector<std::string> compare;
    std::optional<std::string> format;
    std::optional<std::string> output;
    std::optional<std::string> plot;
    bool keepPlotFiles = false;
};

constexpr size_t kMaxCompared = 4;

void checkCounts(const SampleOptions& options) {
    if (options.first + options.count > kSampleIds) {
        throw CliError(fmt::format("--first {} and --count {} go beyond the last sample, 2^32 - 1",
                                   options.first, options.count));
    }
    if (options.plot && options.count > kMaxFigurePoints) {
        throw CliError(fmt::format("--plot: at most {} samples can be drawn, not {}",
                                   kMaxFigurePoints, options.count));
    }
    if (options.compare.size() > kMaxCompared) {
        throw CliError(fmt::format("--compare: at most {} generators, not {}", kMaxCompared,
                                   options.compare.size()));
    }
}

/// The runs to draw: one for --generator or each one of --compare.
std::vector<SampleRun> sampleRuns(const SampleOptions& options) {
    const bool compares = !options.compare.empty();
    const std::vector<std::string> names =
        compares ? eachOnce(options.compare) : std::vector<std::string>{options.generator};
    std::vector<SampleRun> runs;
    for (const std::string& name : names) {
        const NamedGenerator& generator =
            findGenerator(compares ? "--compare" : "--generator", name, sampleGenerators());
        runs.push_back({&generator, static_cast<unsigned>(options.dims),
                        static_cast<uint32_t>(options.pattern), options.first, options.count});
    }
    return runs;
}

/// Opens both outputs before anything is drawn, and names them only when both are complete.
void sample(const SampleOptions& options) {
    checkCounts(options);
    const std::vector<SampleRun> runs = sampleRuns(options);
    const std::string output = options.output.value_or("-");
    const SampleFormat& format =
        options.format ? findFormat(*options.format) : formatOfFile(output);
    const bool writes = !options.plot || options.output || options.format;
    const bool toTerminal = output == "-" && isatty(STDOUT_FILENO) != 0;
    if (writes && isBinary(format) && toTerminal) {
        throw CliError("--format npy is binary and does not go to a terminal; use -o FILE");
    }
    std::unique_ptr<OutputFile> file;
    std::unique_ptr<Picture> picture;
    if (writes) file = std::make_unique<OutputFile>(output);
    if (options.plot) {
        picture = std::make_unique<Picture>("--plot", *options.plot, options.keepPlotFiles);
        std::vector<SampleStream> streams;
        streams.reserve(runs.size());
        for (const SampleRun& run : runs) {
            streams.push_back({run.generator->name, drawPoints(run)});
        }
        picture->draw(sampleFigure(streams));
    }
    if (file) {
        std::optional<ProgressBar> bar; // which would stand among the samples on a terminal
        if (!toTerminal) bar.emplace("samples");
        writeSamples(runs.front(), format, *file, [&](double share) {
            if (bar) bar->show(share);
        });
        file->commit();
    }
    if (picture) picture->commit();
}

std::string generatorHelp() {
    std::string help = "Where samples come from [pmj]";
    for (const NamedGenerator& generator : sampleGenerators()) {
        help += fmt::format("\n  {}: {}", generator.name, generator.description);
    }
    return help;
}

} // namespace

void addSample(CLI::App& app, int& /*exitCode*/) {
    CLI::App* const command = app.add_subcommand("sample", "Write or draw samples");
    const auto options = std::make_shared<SampleOptions>();
    addNumber(*command, "--dims", options->dims, {1, 3}, "Dimensions: 1, 2 or 3 [2]");
    addNumber(*command, "--count", options->count, {1, kSampleIds}, "How many samples")->required();
    addNumber(*command, "--first", options->first, {0, kMaxWord}, "Number of the first sample [0]");
    addNumber(*command, "--pattern", options->pattern, {0, kMaxWord},
              "The pattern, decimal or 0x and hexadecimal [0]");
    CLI::Option* const generator =
        command->add_option("--generator", options->generator, generatorHelp())->type_name("NAME");
    CLI::Option* const format =
        command
            ->add_option("--format", options->format,
                         "csv, npy or json [what the suffix of -o says, csv without one]")
            ->type_name("NAME");
    CLI::Option* const output =
        command->add_option("-o,--output", options->output, "The file to write [standard output]")
            ->type_name("FILE");
    CLI::Option* const plot =
        command
            ->add_option("--plot", options->plot,
                         "Draw the samples over their strata: FILE.png, FILE.svg or FILE.pdf")
            ->type_name("FILE");
    command
        ->add_option("--compare", options->compare,
                     "Plot samples of up to four generators side by side")
        ->delimiter(',')
        ->type_name("NAME,NAME")
        ->allow_extra_args(false)
        ->needs(plot)
        ->excludes(generator)
        ->excludes(format)
        ->excludes(output);
    command
        ->add_flag("--keep-plot-files", options->keepPlotFiles,
                   "Keep the data (FILE.dat) and the gnuplot script (FILE.gp) of the plot")
        ->needs(plot);
    command->footer(kExamples);
    command->callback([options] { sample(*options); });
}

} // namespace wellstrat::cli
