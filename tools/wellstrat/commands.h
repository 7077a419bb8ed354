// SPDX-License-Identifier: Apache-2.0
//
// The sub-commands. To add one: write its file, declare it here, list it in main.cpp.

#pragma once

#include <CLI/App.hpp>

namespace wellstrat::cli {

/// Each adds its sub-command to `app`. When the command line names it, parsing runs it; it throws
/// CliError if it cannot do what was asked, and sets `exitCode` if that is to be other than 0.
/// `exitCode` must outlive `app`.
void addSample(CLI::App& app, int& exitCode);
void addVerify(CLI::App& app, int& exitCode);
void addTables(CLI::App& app, int& exitCode);
void addAnalyze(CLI::App& app, int& exitCode);
void addInfo(CLI::App& app, int& exitCode);
void addStudy(CLI::App& app, int& exitCode);
void addReport(CLI::App& app, int& exitCode);
void addBank(CLI::App& app, int& exitCode);
// Where the renderer is built:
void addRender(CLI::App& app, int& exitCode);
void addMerge(CLI::App& app, int& exitCode);
void addCompare(CLI::App& app, int& exitCode);
void addDomains(CLI::App& app, int& exitCode);

} // namespace wellstrat::cli
