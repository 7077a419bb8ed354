// SPDX-License-Identifier: Apache-2.0
//
// The sub-commands that render. To add one: write its file, declare it here, list it in main.cpp,
// and name it in common/command_line/render_commands.h.

#pragma once

#include <CLI/App.hpp>

namespace wellstrat::cli {

// See AddCommand.
void addRender(CLI::App& app, int& exitCode);
void addMerge(CLI::App& app, int& exitCode);
void addCompare(CLI::App& app, int& exitCode);
void addDomains(CLI::App& app, int& exitCode);

} // namespace wellstrat::cli
