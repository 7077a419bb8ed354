// SPDX-License-Identifier: Apache-2.0

#include "program.h"

#include "common/output/output_file.h"
#include "common/ranks/ranks.h"
#include "errors.h"
#include "versions.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <sstream>
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

/// Of an option that has too many or too few values.
CliError wrongNumber(const CLI::App& app, const CLI::ArgumentMismatch& error) {
    for (const CLI::App* command : app.get_subcommands()) {
        for (const CLI::Option* option : command->get_options()) {
            if (static_cast<int>(option->count()) <= option->get_items_expected_max()) continue;
            return CliError(fmt::format("{} may be given once, not {} times", option->get_name(),
                                        option->count()));
        }
    }
    const std::string text = error.what();
    return CliError(text.substr(0, text.find(':')) + " needs a value after it");
}

/// Throws if there is an option or an argument that the sub-command does not know.
void refuseUnknown(const CLI::App& command) {
    for (const std::string& word : command.remaining()) {
        if (word.size() < 2 || word[0] != '-') continue;
        throw CliError(fmt::format("{0} has no option '{1}'; {0} --help lists them",
                                   command.get_name(), word.substr(0, word.find('='))));
    }
    for (const std::string& word : command.remaining())
        throw CliError(fmt::format("'{}' is an argument too many", word));
}

/// Lets threads keep the memory that they free for their next task. Given back to the system, it
/// would be cleared each time, which takes a quarter of the time of a study.
void keepFreedMemory() {
#if defined(__GLIBC__)
    mallopt(M_MMAP_THRESHOLD, 1 << 26);
    mallopt(M_TRIM_THRESHOLD, 1 << 28);
#endif
}

/// Prints what --help and --version ask for. Throws CliError for a command line that is wrong.
void answer(const CLI::App& app, const CLI::ParseError& stop) {
    if (dynamic_cast<const CLI::Success*>(&stop) != nullptr) {
        std::ostringstream text;
        app.exit(stop, text);
        printText(text.str());
        return;
    }
    if (const auto* const mismatch = dynamic_cast<const CLI::ArgumentMismatch*>(&stop)) {
        throw wrongNumber(app, *mismatch);
    }
    if (app.get_subcommands().empty()) throw noSubcommand(app);
    refuseUnknown(*app.get_subcommands().front());
    throw CliError(stop.what());
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
    const bool isRoot = launchedRank() == 0;
    for (const Command& command : program.commands) {
        command.add(app, exitCode);
        if (!isRoot && !command.isShared) app.get_subcommands({}).back()->callback([] {});
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& stop) {
        if (isRoot) answer(app, stop);
    }
    return exitCode;
}

} // namespace wellstrat::cli
