// SPDX-License-Identifier: Apache-2.0
//
// The speeds that scripts/bench --json has measured.

#pragma once

#include <string>
#include <vector>

namespace wellstrat::cli {

/// The times of one benchmark in nanoseconds.
struct BenchTime {
    std::string name;
    double median;
    double spread; ///< half the interquartile range, in percent of the median
    bool isRival;  ///< not wellstrat's
};

struct BenchResults {
    std::string processor, target; ///< the latter of batches, such as "AVX3"
    std::string date;
    std::vector<BenchTime> times; ///< in the order of their names
    double tablesMs;              ///< median of building all tables

    /// Those of 2D samples with shorter names, the fastest first: single draws, batches of 4096,
    /// and rivals.
    std::vector<BenchTime> of2DSamples() const;
};

/// Reads a file of scripts/bench --json. Throws CliError, which names --bench, for any other.
BenchResults readBench(const std::string& path);

} // namespace wellstrat::cli
