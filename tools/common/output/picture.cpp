// SPDX-License-Identifier: Apache-2.0

#include "picture.h"

#include "common/command_line/errors.h"
#include "common/command_line/options.h"
#include "process.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace wellstrat::cli {
namespace {

namespace fs = std::filesystem;

/// A directory that is removed with all in it.
class TemporaryDirectory {
public:
    TemporaryDirectory() {
        std::error_code error;
        path_ = (fs::temp_directory_path(error) / "wellstrat-XXXXXX").string();
        if (error) throw fileError("use", "TMPDIR", error.value());
        if (mkdtemp(path_.data()) == nullptr) throw fileError("create", path_, errno);
    }
    ~TemporaryDirectory() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryDirectory(const TemporaryDirectory&) = delete;
    TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

    std::string file(const std::string& name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

std::string readFile(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void writeFile(const std::string& path, const std::string& bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.commit();
}

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

/// The script with its set-up. It derives the names of the data and of the picture from its own, so
/// it works wherever the three lie together.
std::string fullScript(const Plot& plot, const std::string& suffix) {
    return fmt::format(
        "# Run by gnuplot, reads the .dat file beside this one, writes the {1} file.\n"
        "stem = ARG0[1:strlen(ARG0)-3]\n"
        "data = stem.'.dat'\n"
        "set terminal {0}\n"
        "set output stem.'{1}'\n"
        "{2}",
        terminal(suffix, plot.width, plot.height), suffix, plot.script);
}

void runGnuplot(const std::string& script, const std::string& log) {
    int exitCode = 0;
    try {
        exitCode = runProcess({"gnuplot", "--default-settings", script}, log);
    } catch (const std::system_error& error) {
        throw CliError(
            fmt::format("plots need gnuplot, which cannot be run from PATH ({}); on Debian, "
                        "install gnuplot-nox",
                        error.code().message()));
    }
    if (exitCode != 0) {
        throw CliError(fmt::format("gnuplot failed (exit code {}): {}", exitCode, readFile(log)));
    }
}

} // namespace

DrawnPlot drawPlot(const Plot& plot, const std::string& suffix) {
    const TemporaryDirectory directory;
    std::string script = fullScript(plot, suffix);
    writeFile(directory.file("plot.gp"), script);
    writeFile(directory.file("plot.dat"), plot.data);
    runGnuplot(directory.file("plot.gp"), directory.file("log"));
    std::string picture = readFile(directory.file("plot" + suffix));
    if (picture.empty()) throw CliError("gnuplot wrote no picture");
    return {std::move(picture), std::move(script)};
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
