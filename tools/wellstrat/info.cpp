// SPDX-License-Identifier: Apache-2.0
//
// wellstrat info: what this build is and what its tables cost.

#include "commands.h"
#include "common/command_line/versions.h"
#include "common/output/output_file.h"
#include "wellstrat/tables.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples = R"(Examples:
  wellstrat info
  wellstrat info --json
)";

std::string compiler() {
#if defined(__clang__)
    return "Clang " __clang_version__;
#elif defined(__GNUC__)
    return "GCC " __VERSION__;
#else
    return "unknown";
#endif
}

/// The tables of a process are built once, so this is the time of the first call.
double buildMilliseconds() {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    buildTables();
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

std::string jsonInfo(double milliseconds) {
    nlohmann::ordered_json info = versionedJson();
    info["compiler"] = compiler();
    info["tables"] = {{"count", kTableCount},
                      {"points_per_table", kTableSize},
                      {"dimensions", 3},
                      {"bytes", tableBytes()},
                      {"build_ms", milliseconds}};
    info["stratified_samples_per_pattern"] = kStratifiedSamples;
    return info.dump(2) + "\n";
}

std::string textInfo(double milliseconds) {
    return fmt::format(
        "{}\n"
        "compiler            {}\n"
        "tables              {} of {} three-dimensional points\n"
        "table memory        {:.1f} MiB\n"
        "table build time    {:.1f} ms, measured now\n"
        "stratified samples  {} for each pattern\n",
        versionLine(), compiler(), kTableCount, kTableSize,
        static_cast<double>(tableBytes()) / (1 << 20), milliseconds, kStratifiedSamples);
}

void printInfo(bool json) {
    const double milliseconds = buildMilliseconds();
    printText(json ? jsonInfo(milliseconds) : textInfo(milliseconds));
}

} // namespace

void addInfo(CLI::App& app, int& /*exitCode*/) {
    CLI::App* const command = app.add_subcommand("info", "Print versions, memory and build time");
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "Print JSON");
    command->footer(kExamples);
    command->callback([json] { printInfo(*json); });
}

} // namespace wellstrat::cli
