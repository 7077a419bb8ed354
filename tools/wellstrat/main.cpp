// SPDX-License-Identifier: Apache-2.0
//
// The command line tool: wellstrat SUBCOMMAND [OPTIONS].

#include "commands.h"
#include "errors.h"
#include "versions.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace {

using namespace wellstrat::cli;

constexpr auto kExamples = R"(Examples:
  wellstrat sample --dims 2 --count 16
  wellstrat sample --compare random,pmj --count 256 --plot compare.png
  wellstrat verify
  wellstrat tables --export tables.npy
  wellstrat report --quick -o report.html
  wellstrat SUBCOMMAND --help

Exit codes: 0 done, 1 a promise does not hold (verify), 2 error.
)";

/// The plain formatter without the lists of what an option needs and excludes.
class HelpFormatter : public CLI::Formatter {
    std::string make_option_opts(const CLI::Option* option) const override {
        return (option->get_type_size() == 0 ? "" : " " + option->get_type_name()) +
               (option->get_required() ? " (required)" : "");
    }
};

int fail(const char* message) {
    fmt::print(stderr, "wellstrat: {}\n", oneLine(message));
    return kExitError;
}

/// Names the sub-commands that there are.
CliError noSubcommand(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
    const std::vector<std::string> unknown = app.remaining();
    return CliError(fmt::format("{}; there are {}",
                                unknown.empty() ? "a sub-command is required"
                                                : fmt::format("'{}' is no sub-command", unknown[0]),
                                fmt::join(names, ", ")));
}

int run(int argc, char** argv) {
    int exitCode = 0;
    CLI::App app("Well-stratified samples for renderers.", "wellstrat");
    app.set_version_flag("--version", versionLine(), "Print the versions and exit");
    app.set_help_flag("-h,--help", "Print this help and exit");
    app.formatter(std::make_shared<HelpFormatter>());
    app.get_formatter()->column_width(26);
    app.footer(kExamples);
    app.require_subcommand(1);
    for (const auto add :
         {addSample, addVerify, addTables, addAnalyze, addInfo, addStudy, addReport, addBank})
        add(app, exitCode);
#if defined(WELLSTRAT_WITH_RENDERER)
    for (const auto add : {addRender, addMerge, addCompare, addDomains}) add(app, exitCode);
#endif
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& request) {
        return app.exit(request);
    } catch (const CLI::ParseError&) {
        if (app.get_subcommands().empty()) throw noSubcommand(app);
        throw;
    }
    return exitCode;
}

/// Lets threads keep the memory that they free for their next task. Given back to the system, it
/// would be cleared each time, which takes a quarter of the time of a study.
void keepFreedMemory() {
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, 1 << 26);
    mallopt(M_TRIM_THRESHOLD, 1 << 28);
#endif
}

} // namespace

int main(int argc, char** argv) {
    try {
        keepFreedMemory();
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        return fail("out of memory");
    } catch (const std::exception& error) {
        return fail(error.what());
    }
}
