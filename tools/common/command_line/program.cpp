// SPDX-License-Identifier: Apache-2.0

#include "program.h"

#include "errors.h"
#include "versions.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace wellstrat::cli {
namespace {

/// The plain formatter without the lists of what an option needs and excludes.
class HelpFormatter : public CLI::Formatter {
    std::string make_option_opts(const CLI::Option* option) const override {
        return (option->get_type_size() == 0 ? "" : " " + option->get_type_name()) +
               (option->get_required() ? " (required)" : "");
    }
};

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

/// Lets threads keep the memory that they free for their next task. Given back to the system, it
/// would be cleared each time, which takes a quarter of the time of a study.
void keepFreedMemory() {
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, 1 << 26);
    mallopt(M_TRIM_THRESHOLD, 1 << 28);
#endif
}

} // namespace

int runProgram(const Program& program, int argc, char** argv) {
    keepFreedMemory();
    int exitCode = 0;
    CLI::App app(program.description, program.name);
    app.set_version_flag("--version", versionLine(program.name), "Print the versions and exit");
    app.set_help_flag("-h,--help", "Print this help and exit");
    app.formatter(std::make_shared<HelpFormatter>());
    app.get_formatter()->column_width(26);
    app.footer(program.examples);
    app.require_subcommand(1);
    for (const AddCommand add : program.commands) add(app, exitCode);
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

} // namespace wellstrat::cli
