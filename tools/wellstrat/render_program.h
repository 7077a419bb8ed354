// SPDX-License-Identifier: Apache-2.0
//
// The sub-commands that render are a program of their own, wellstrat-render: what they need takes
// long to load. `wellstrat render` becomes that program.

#pragma once

#include <CLI/App.hpp>

namespace wellstrat::cli {

/// Lists those sub-commands, with a mark where wellstrat-render is not installed.
void addRenderCommands(CLI::App& app, int& exitCode);

/// Whether the command line names one of them.
bool namesRenderCommand(int argc, char** argv);

/// Goes on as wellstrat-render in this process, with these arguments. Throws CliError if it is not
/// installed or cannot be run.
[[noreturn]] void becomeRenderProgram(char** argv);

} // namespace wellstrat::cli
