// SPDX-License-Identifier: Apache-2.0

#include "picture.h"

#include "common/command_line/errors.h"
#include "common/command_line/messages.h"
#include "common/command_line/options.h"
#include "memory_file.h"
#include "process.h"

#include <fmt/format.h>

#include <optional>
#include <system_error>
#include <utility>

namespace wellstrat::cli {
namespace {

std::string terminal(const std::string& suffix, unsigned width, unsigned height) {
    if (suffix == ".png") {
        return fmt::format("pngcairo size {},{} font 'sans,11'", width, height);
    }
    if (suffix == ".svg") {
        return fmt::format("svg size {},{} font 'sans,14' background rgb 'white'", width, height);
    }
    return fmt::format("pdfcairo size {:.3f}in,{:.3f}in font 'sans,11'", width / 96.0,
                       height / 96.0);
}

/// Undoes what gnuplotrc and ~/.gnuplot may have set, also what `reset` leaves.
constexpr auto kDefaults =
    "reset\n"
    "set encoding utf8\n"
    "unset decimalsign\n"
    "unset minussign\n"
    "set colorsequence default\n"
    "do for [i = 1:8] { set linetype i linewidth 1 dashtype solid pointtype i pointsize default "
    "}\n";

/// The script as it is kept. It derives the names of the data and of the picture from its own, so
/// it works wherever the three lie together.
std::string keptScript(const Plot& plot, const std::string& suffix) {
    return fmt::format(
        "# Run by gnuplot, reads the .dat file beside this one, writes the {1} file.\n"
        "{3}"
        "stem = ARG0[1:strlen(ARG0)-3]\n"
        "data = stem.'.dat'\n"
        "set terminal {0}\n"
        "set output stem.'{1}'\n"
        "{2}",
        terminal(suffix, plot.width, plot.height), suffix, plot.script, kDefaults);
}

/// Two small pictures, with a letter and without, which are the same if there are no fonts.
class FontTrial {
public:
    std::string script() const {
        return fmt::format(
            "unset output\n"
            "reset\n"
            "set terminal pngcairo size 40,40 font 'sans,11'\n"
            "unset border; unset tics; unset key\n"
            "set output '{}'\n"
            "plot [0:1] [0:1] 2\n"
            "set output '{}'\n"
            "set label 'W' at 0.5,0.5\n"
            "replot\n"
            "unset output\n",
            without_.path(), with_.path());
    }
    bool hasFonts() const { return with_.read() != without_.read(); }

private:
    MemoryFile with_, without_;
};

void runGnuplot(const std::string& script) {
    const MemoryFile file(script), log;
    int exitCode = 0;
    try {
        exitCode = runProcess({"gnuplot", "--default-settings", file.path()}, log.descriptor());
    } catch (const std::system_error& error) {
        throw CliError(
            fmt::format("plots need gnuplot, which cannot be run from PATH ({}); on Debian, "
                        "install gnuplot-nox",
                        error.code().message()));
    }
    if (exitCode != 0) {
        throw CliError(fmt::format("gnuplot failed (exit code {}): {}", exitCode, log.read()));
    }
}

/// Once is enough.
void sayNoFonts() {
    static const bool isSaid =
        (say("gnuplot finds no fonts, so there is no text in the picture; on Debian, install "
             "fonts-dejavu-core"),
         true);
    static_cast<void>(isSaid);
}

} // namespace

DrawnPlot drawPlot(const Plot& plot, const std::string& suffix) {
    const MemoryFile data(plot.data), picture;
    std::string script =
        fmt::format("{}data = '{}'\nset terminal {}\nset output '{}'\n{}", kDefaults, data.path(),
                    terminal(suffix, plot.width, plot.height), picture.path(), plot.script);
    std::optional<FontTrial> trial; // who looks at an SVG has fonts of his own
    if (suffix != ".svg") script += trial.emplace().script();
    runGnuplot(script);
    DrawnPlot drawn{picture.read(), keptScript(plot, suffix)};
    if (drawn.picture.empty()) throw CliError("gnuplot wrote no picture");
    if (trial && !trial->hasFonts()) sayNoFonts();
    return drawn;
}

Picture::Picture(const std::string& option, const std::string& path, bool keepFiles)
    : suffix_(requireSuffix(option, path, {".png", ".svg", ".pdf"})) {
    files_.emplace_back(path);
    if (!keepFiles) return;
    const std::string stem = path.substr(0, path.size() - suffix_.size());
    files_.emplace_back(stem + ".dat");
    files_.emplace_back(stem + ".gp");
}

std::string Picture::draw(const Plot& plot) {
    DrawnPlot drawn = drawPlot(plot, suffix_);
    files_[0].write(drawn.picture);
    if (files_.size() > 1) {
        files_[1].write(plot.data);
        files_[2].write(drawn.script);
    }
    return std::move(drawn.picture);
}

void Picture::commit() {
    for (OutputFile& file : files_) file.commit();
}

} // namespace wellstrat::cli
