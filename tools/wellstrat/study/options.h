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
    std::vector<std::string> generators{"pmj", "random"};
    std::vector<std::string> integrands{"classic"};
    std::string counts = "pow2:4..4096";
    std::string table = "16,64,256,1024,4096";
    uint64_t patterns = 1000;
    uint64_t fitFrom = 16;
    uint64_t saveEvery = 30;
    std::optional<std::string> output;
    std::optional<std::string> plot;
    bool keepPlotFiles = false;
    bool resume = false;
    bool list = false;

    bool writesToFile() const { return output && *output != "-"; }
    /// Of a study that writes to a file.
    std::string statePath() const { return *output + ".state"; }
};

/// `options` must outlive `command`.
void addStudyOptions(CLI::App& command, StudyOptions& options);

} // namespace wellstrat::cli
