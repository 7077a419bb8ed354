// SPDX-License-Identifier: Apache-2.0
//
// What the programs of the command line tool share: NAME SUBCOMMAND [OPTIONS].

#pragma once

#include <CLI/App.hpp>

#include <vector>

namespace wellstrat::cli {

/// Adds a sub-command to `app`. When the command line names it, parsing runs it; it throws CliError
/// if it cannot do what was asked, and sets `exitCode` if that is to be other than 0. `exitCode`
/// must outlive `app`.
using AddCommand = void (*)(CLI::App& app, int& exitCode);

struct Program {
    const char *name, *description, *examples;
    std::vector<AddCommand> commands;
};

/// Runs the sub-command that the command line names. Returns the exit code; throws
/// std::exception.
int runProgram(const Program& program, int argc, char** argv);

} // namespace wellstrat::cli
