// SPDX-License-Identifier: Apache-2.0
//
// The benchmarks: wellstrat and its rivals in one process. `scripts/bench` runs them with
// repetitions and prints medians and ratios.

#include "count.h"
#include "scenarios.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/tables.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

#ifdef __clang__
constexpr char kCompiler[] = "clang " __clang_version__;
#else
constexpr char kCompiler[] = "g++ " __VERSION__;
#endif

/// Tables are built once in a process, so the script starts many.
int timeTables() {
    const auto start = std::chrono::steady_clock::now();
    wellstrat::buildTables();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    std::printf("%.3f\n", time.count());
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "--time-tables") == 0) return timeTables();
    wellstrat::buildTables();
    if (argc == 4 && std::strcmp(argv[1], "--count") == 0) {
        const auto samples = static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10));
        return wellstrat::drawForCounting(argv[2], samples) ? 0 : 2;
    }
    wellstrat::Suite::addAll();
    benchmark::AddCustomContext("batch_target", wellstrat::chosenBatchTarget());
    benchmark::AddCustomContext("compiler", kCompiler);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
