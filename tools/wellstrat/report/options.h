// SPDX-License-Identifier: Apache-2.0
//
// The options of wellstrat report, and its help.

#pragma once

#include "subject.h"

#include <CLI/App.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// What --quick, the default and --thorough measure.
struct ReportEffort {
    const char* option; ///< " --quick"
    uint64_t count;     ///< points of which measures are taken
    uint64_t patterns;
    const char* counts; ///< of the study
};

struct ReportOptions {
    std::string output = "report.html";
    std::vector<std::string> generators{"pmj", "random", "sobol-owen", "halton", "jitter"};
    std::vector<std::string> integrands{"classic", "linear", "gaussian-3d", "disk^2"};
    uint64_t count = 0, patterns = 0; ///< 0: as the effort says
    bool quick = false, thorough = false;
    std::optional<std::string> bench;
    bool keepPlotFiles = false;

    const ReportEffort& effort() const;
    uint64_t patternCount() const { return patterns != 0 ? patterns : effort().patterns; }
    ReportSize size() const;
};

/// `options` must outlive `command`.
void addReportOptions(CLI::App& command, ReportOptions& options);

/// Lines for a page: the commands that give what is on it.
struct ReportCommands {
    std::string page, study;
    std::string samples; ///< of our own generators; empty if there are none among them
    std::string measures;
    std::string bench; ///< empty if there is none
};
ReportCommands reportCommands(const ReportOptions& options);

} // namespace wellstrat::cli
