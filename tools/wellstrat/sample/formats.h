// SPDX-License-Identifier: Apache-2.0
//
// The file formats of sample points.

#pragma once

#include "common/output/output_file.h"
#include "points/sampling.h"

#include <functional>
#include <string>

namespace wellstrat::cli {

/// csv, npy or json.
struct SampleFormat;

/// The format called `name`. Throws CliError if there is none.
const SampleFormat& findFormat(const std::string& name);

/// The format that the suffix of the file name `path` names; csv for .txt and if it has none.
/// Throws CliError if that names no format.
const SampleFormat& formatOfFile(const std::string& path);

/// Whether files of this format are not text.
bool isBinary(const SampleFormat& format);

/// Draws the samples of `run` and writes them. Memory does not grow with their number. Tells
/// `progress` now and then which part is done.
void writeSamples(const SampleRun& run, const SampleFormat& format, OutputFile& out,
                  const std::function<void(double)>& progress);

} // namespace wellstrat::cli
