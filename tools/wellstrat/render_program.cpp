// SPDX-License-Identifier: Apache-2.0

#include "render_program.h"

#include "common/command_line/errors.h"
#include "common/command_line/program_files.h"
#include "common/command_line/render_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include <unistd.h>

namespace wellstrat::cli {

void addRenderCommands(CLI::App& app, int& /*exitCode*/) {
    const char* const mark = findProgram(kRenderProgram) ? "" : " (not installed)";
    for (const RenderCommand& command : kRenderCommands) {
        app.add_subcommand(command.name, fmt::format("{}{}", command.description, mark));
    }
}

bool namesRenderCommand(int argc, char** argv) {
    const auto isFlag = [](std::string_view argument) { return argument.substr(0, 1) == "-"; };
    char** const end = argv + argc;
    char** const named = std::find_if_not(std::min(argv + 1, end), end, isFlag);
    return named != end &&
           std::any_of(std::begin(kRenderCommands), std::end(kRenderCommands),
                       [&](const RenderCommand& c) { return std::string_view(*named) == c.name; });
}

void becomeRenderProgram(char** argv) {
    const std::optional<std::string> path = findProgram(kRenderProgram);
    if (!path) {
        throw CliError(fmt::format("the sub-commands that render are not installed; install {}",
                                   kRenderProgram));
    }
    std::string name = "wellstrat"; // so that it calls itself by the name it was called by
    argv[0] = name.data();
    execv(path->c_str(), argv);
    throw fileError("run", *path, errno);
}

} // namespace wellstrat::cli
