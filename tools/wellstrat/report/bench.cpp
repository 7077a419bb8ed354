// SPDX-License-Identifier: Apache-2.0

#include "bench.h"

#include "common/command_line/errors.h"
#include "common/output/output_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace wellstrat::cli {
namespace {

constexpr std::string_view kRival = "rival: ", kBatch = "/4096";

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}
bool endsWith(std::string_view text, std::string_view end) {
    return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// The value below which the share `share` of the sorted `values` lies, between neighbors linear.
double quantile(const std::vector<double>& values, double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const std::size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

std::vector<double> timesOf(const nlohmann::json& json) {
    auto times = json.get<std::vector<double>>();
    for (const double time : times) {
        if (!(time > 0)) throw std::invalid_argument("a time is not above 0");
    }
    if (times.empty()) throw std::invalid_argument("a benchmark has no times");
    std::sort(times.begin(), times.end());
    return times;
}

BenchTime benchTime(const std::string& name, const nlohmann::json& json) {
    const std::vector<double> times = timesOf(json);
    const double median = quantile(times, 0.5);
    return {name, median, 50 * (quantile(times, 0.75) - quantile(times, 0.25)) / median,
            startsWith(name, kRival)};
}

BenchResults resultsOf(const nlohmann::json& json) {
    BenchResults results{json.at("processor").get<std::string>(),
                         json.at("context").value("batch_target", ""),
                         json.at("context").value("date", ""),
                         {},
                         quantile(timesOf(json.at("tables_ms")), 0.5)};
    for (const auto& [name, times] : json.at("ns").items()) {
        results.times.push_back(benchTime(name, times));
    }
    if (results.times.empty()) throw std::invalid_argument("there are no benchmarks");
    return results;
}

} // namespace

std::vector<BenchTime> BenchResults::of2DSamples() const {
    std::vector<BenchTime> shown;
    for (const BenchTime& time : times) {
        const bool batch = startsWith(time.name, "coherent 2D") && endsWith(time.name, kBatch);
        if (time.isRival || batch || startsWith(time.name, "scalar 2D")) shown.push_back(time);
        if (time.isRival) shown.back().name.erase(0, kRival.size());
        if (batch) shown.back().name.resize(time.name.size() - kBatch.size());
    }
    std::sort(shown.begin(), shown.end(),
              [](const BenchTime& a, const BenchTime& b) { return a.median < b.median; });
    return shown;
}

BenchResults readBench(const std::string& path) {
    declareInput(path);
    std::ifstream file(path, std::ios::binary);
    if (!file) throw fileError("read", path, errno);
    const auto refuse = [&path](const std::string& reason) {
        return CliError(fmt::format("--bench: '{}' is no file that scripts/bench --json writes: {}",
                                    path, reason));
    };
    try {
        return resultsOf(nlohmann::json::parse(file));
    } catch (const nlohmann::json::parse_error& error) {
        throw refuse(fmt::format("it is no JSON from byte {} on", error.byte));
    } catch (const nlohmann::json::exception&) {
        throw refuse("processor, context, tables_ms or ns is missing or of another kind");
    } catch (const std::invalid_argument& error) {
        throw refuse(error.what());
    }
}

} // namespace wellstrat::cli
