// SPDX-License-Identifier: Apache-2.0
//
// The options of wellstrat study, and its help.

#pragma once

#include <CLI/App.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

struct StudyOptions {
    std::vector<std::string> generators, integrands;
    std::optional<std::string> counts;
    std::string table = "16,64,256,1024,4096";
    std::optional<uint64_t> patterns;
    std::optional<double> filter; ///< of a study of pictures
    uint64_t window = 76;
    uint64_t fitFrom = 16;
    uint64_t saveEvery = 30;
    std::optional<std::string> output;
    std::optional<std::string> plot;
    bool keepPlotFiles = false;
    bool resume = false;
    bool list = false;

    /// Sets what was not given, and depends on whether there are pictures.
    void setDefaults();

    bool writesToFile() const { return output && *output != "-"; }
    /// Of a study that writes to a file.
    std::string statePath() const { return *output + ".state"; }
};

/// `options` must outlive `command`.
void addStudyOptions(CLI::App& command, StudyOptions& options);

} // namespace wellstrat::cli
