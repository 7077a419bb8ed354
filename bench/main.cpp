// SPDX-License-Identifier: Apache-2.0
//
// The benchmarks: wellstrat and its rivals in one process. `scripts/bench` runs them with
// repetitions and prints medians and ratios.

#include "batches.h"

#include "RixRNG.h"
#include "wellstrat/batch_target.h"
#include "wellstrat/tables.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace {

/// Tables are built once in a process, so the script starts many.
int timeTables() {
    const auto start = std::chrono::steady_clock::now();
    wellstrat::buildTables();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    std::printf("%.3f\n", time.count());
    return 0;
}

/// Draws `samples` 2D samples, or just makes their contexts, for a program that counts
/// instructions.
int count(const std::string& path, unsigned samples) {
    using wellstrat::SampleCtx;
    constexpr auto scramble = static_cast<wellstrat::Scramble>(0x2d96c92bu);
    std::vector<SampleCtx> contexts(samples);
    for (unsigned i = 0; i < samples; ++i) contexts[i] = {HashToUnsigned(1, i), 7};
    std::vector<RtFloat2> xis(samples);
    const RixRNG rng(contexts.data(), samples);
    if (path == "scalar") {
        for (unsigned i = 0; i < samples; ++i) xis[i] = rng.DrawSample2D(i);
    } else if (path == "chain") {
        SampleCtx sc = contexts[0];
        for (RtFloat2& xi : xis) {
            sc = sc.NewDomain(scramble);
            xi = wellstrat::sample2D(sc.patternid, sc.sampleid);
        }
    } else if (path == "batch") {
        rng.DrawSamples2D(xis.data());
    } else if (path != "nothing") {
        std::fprintf(stderr, "wellstrat_bench: --count takes scalar, chain, batch or nothing\n");
        return 2;
    }
    benchmark::DoNotOptimize(xis.data());
    return 0;
}

} // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "--time-tables") == 0) return timeTables();
    wellstrat::buildTables();
    if (argc == 4 && std::strcmp(argv[1], "--count") == 0) {
        return count(argv[2], static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10)));
    }
    wellstrat::registerBatches();
    benchmark::AddCustomContext("batch_target", wellstrat::chosenBatchTarget());
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
