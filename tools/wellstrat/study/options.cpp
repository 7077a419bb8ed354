// SPDX-License-Identifier: Apache-2.0

#include "options.h"

#include "common/command_line/options.h"
#include "plan.h"

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(Each integrand is estimated by the mean over the first N points of each pattern; the RMSE is
over patterns 0, 1, 2, ... Integrands: 'wellstrat study --list'. A product over several domains is
written disk^3 or disk*linear; classic, edges, sines, boxes, pixels, products, 1d and 3d stand for
several. Counts: 4,16,100 or all:1..4096 or pow2:4..4096.

With --filter, a pattern is a pixel, and a generator's errors are judged as pictures: the integrands
vary slowly from pixel to pixel, and the RMSE is that of the estimates minus the true values after a
Gaussian of SIGMA pixels, inside a border of 3 SIGMA, over pictures 0, 1, 2, ... The table shows it
relative to the first generator. 2d, 4d and 1d-3d stand for several integrands.

The +- of a slope says how well a line fits; not how certain the slope is: errors at neighboring N
come from the same patterns.

Ctrl-C writes the results of the patterns that are finished. Beside them is FILE.state, from which
the same command with --resume goes on, also with more --patterns when all are finished. Built with
MPI, the same command under mpirun splits the work. Threads and processes change no bit of the
results.

Examples:
  wellstrat study --list
  wellstrat study --integrands disk,gaussian --counts pow2:4..1024
  wellstrat study --generators pmj,halton --integrands disk^2 --counts all:1..64 -o results.csv
  wellstrat study --integrands classic --patterns 100 --plot error.svg
  wellstrat study --filter 2 --generators pmj,zsobol,tile --integrands 2d

Exit codes: 0 done, 2 error, 130 interrupted.
)";

void addSubjects(CLI::App& command, StudyOptions& options) {
    const auto addNames = [&](const char* flag, std::vector<std::string>& names,
                              const char* description) {
        command.add_option(flag, names, description)
            ->delimiter(',')
            ->allow_extra_args(false)
            ->type_name("NAME,NAME");
    };
    addNames("--generators", options.generators,
             "What draws the points [pmj,random; with --filter pmj,zsobol]");
    addNames("--integrands", options.integrands,
             "Integrands and groups [classic; with --filter 2d]");
    command
        .add_option("--counts", options.counts,
                    "Numbers of points [pow2:4..4096; with --filter pow2:1..64]")
        ->type_name("COUNTS");
    addNumber(command, "--patterns", options.patterns, {1, kMaxStudyPatterns},
              "Patterns of each generator [1000]; with --filter pictures [20]");
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
    command.add_flag("--resume", options.resume, "Go on from FILE.state, also of a finished study");
    addNumber(command, "--save-every", options.saveEvery, {0, 86400},
              "Seconds between savings of FILE.state while it runs [30]");
}

} // namespace

void StudyOptions::setDefaults() {
    if (generators.empty()) generators = {"pmj", filter ? "zsobol" : "random"};
    if (integrands.empty()) integrands = {filter ? "2d" : "classic"};
    if (!counts) counts = filter ? "pow2:1..64" : "pow2:4..4096";
    if (!patterns) patterns = filter ? 20 : 1000;
}

void addStudyOptions(CLI::App& command, StudyOptions& options) {
    command.add_flag("--list", options.list, "Print generators and integrands and exit");
    addSubjects(command, options);
    CLI::Option* const filter =
        addReal(command, "--filter", options.filter, {0, GaussianFilter::kMaxSigma},
                "Measure pictures, after a Gaussian of SIGMA pixels; 0: none")
            ->type_name("SIGMA");
    addNumber(command, "--window", options.window, {1, kMaxPictureSize},
              "Pixels of a side of the pictures [76]")
        ->needs(filter);
    command
        .add_option("--table", options.table,
                    "Numbers of points in the printed table [16,64,256,1024,4096]")
        ->type_name("COUNTS")
        ->excludes(filter);
    addNumber(command, "--fit-from", options.fitFrom, {1, kMaxStudyPoints},
              "Fit slopes from this number of points on [16]");
    addOutputs(command, options);
    command.footer(kExamples);
}

} // namespace wellstrat::cli
