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

struct Command {
    AddCommand add;
    bool isShared =
        false; ///< by the processes of mpirun; else rank 0 runs it, and others do nothing
};
constexpr bool kShared = true;

struct Program {
    const char *name, *description, *examples;
    std::vector<Command> commands;
};

/// Runs the sub-command that the command line names; of several processes, rank 0 alone says what
/// is wrong with that line. Returns the exit code; throws std::exception.
int runProgram(const Program& program, int argc, char** argv);

} // namespace wellstrat::cli
