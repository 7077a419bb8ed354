// SPDX-License-Identifier: Apache-2.0
//
// Pictures drawn by gnuplot.
//
// gnuplot runs as a child process on files in memory, whose names we chose, so no string of the
// user ever reaches it: neither a shell, nor its script, nor its file names, in which a leading "|"
// or "<" would start a program.

#pragma once

#include "output_file.h"

#include <deque>
#include <string>

namespace wellstrat::cli {

/// What to draw. The script finds the terminal and the output set up, and the name of the data
/// file in its variable `data`.
struct Plot {
    std::string script;
    std::string data;
    unsigned width, height; ///< pixels; in vector formats 1/96 inch
};

/// What gnuplot made of a plot.
struct DrawnPlot {
    std::string picture; ///< the bytes of the picture's file
    std::string script;  ///< all of it: beside it, as NAME.gp, lies the data as NAME.dat
};

/// Runs gnuplot for the format that `suffix` stands for: .png, .svg or .pdf. Throws CliError if
/// gnuplot is missing or fails. Says so if gnuplot finds no fonts.
DrawnPlot drawPlot(const Plot& plot, const std::string& suffix);

/// A picture file; with `keepFiles` also the data and the script beside it, with the picture's
/// suffix replaced by .dat and .gp, so that "gnuplot NAME.gp" draws the picture again.
class Picture {
public:
    /// Throws CliError if the suffix of `path` is none of .png, .svg, .pdf, or if the directory
    /// cannot be written. `option` is named in the message.
    Picture(const std::string& option, const std::string& path, bool keepFiles);

    /// Draws, and returns the bytes of the picture. Throws CliError as drawPlot does.
    std::string draw(const Plot& plot);

    /// Puts the files under their names.
    void commit();

private:
    std::string suffix_;
    std::deque<OutputFile> files_; ///< the picture, then data and script if they are kept
};

} // namespace wellstrat::cli
