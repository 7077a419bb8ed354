// SPDX-License-Identifier: Apache-2.0
//
// The sub-commands. To add one: write its file, declare it here, list it in main.cpp.

#pragma once

#include <CLI/App.hpp>

namespace wellstrat::cli {

// See AddCommand.
void addSample(CLI::App& app, int& exitCode);
void addVerify(CLI::App& app, int& exitCode);
void addTables(CLI::App& app, int& exitCode);
void addAnalyze(CLI::App& app, int& exitCode);
void addInfo(CLI::App& app, int& exitCode);
void addStudy(CLI::App& app, int& exitCode);
void addReport(CLI::App& app, int& exitCode);
void addBank(CLI::App& app, int& exitCode);
void addRanks(CLI::App& app, int& exitCode);

} // namespace wellstrat::cli
