// SPDX-License-Identifier: Apache-2.0

#include "formats.h"

#include "common/command_line/errors.h"
#include "common/command_line/options.h"
#include "common/command_line/versions.h"
#include "points/npy.h"

#include <fmt/ranges.h>

#include <filesystem>
#include <iterator>
#include <string_view>

namespace wellstrat::cli {

using Buffer = fmt::memory_buffer;

struct SampleFormat {
    const char* name;
    bool binary;
    void (*begin)(Buffer& out, const SampleRun& run);
    void (*point)(Buffer& out, const SampleRun& run, const float* xi, bool first);
    void (*end)(Buffer& out);
};

namespace {

void append(Buffer& out, std::string_view text) {
    out.append(text.data(), text.data() + text.size());
}

/// Nine significant digits tell all floats apart.
void appendNumbers(Buffer& out, const SampleRun& run, const float* xi, const char* separator) {
    fmt::format_to(std::back_inserter(out), "{:.9g}", fmt::join(xi, xi + run.dims, separator));
}

void noBegin(Buffer& /*out*/, const SampleRun& /*run*/) {}
void noEnd(Buffer& /*out*/) {}

void csvPoint(Buffer& out, const SampleRun& run, const float* xi, bool /*first*/) {
    appendNumbers(out, run, xi, ",");
    out.push_back('\n');
}

void npyBegin(Buffer& out, const SampleRun& run) {
    append(out, npyHeader("<f4", {run.count, run.dims}));
}

void npyPoint(Buffer& out, const SampleRun& run, const float* xi, bool /*first*/) {
    for (unsigned d = 0; d < run.dims; ++d) appendLittleEndian(out, xi[d]);
}

void jsonBegin(Buffer& out, const SampleRun& run) {
    nlohmann::ordered_json json = versionedJson();
    json["generator"] = run.generator->name;
    json["dims"] = run.dims;
    json["pattern"] = run.pattern;
    json["first"] = run.first;
    json["count"] = run.count;
    std::string text = json.dump(2);
    text.erase(text.rfind("\n}")); // the points follow one by one
    append(out, text);
    append(out, ",\n  \"points\": [");
}

void jsonPoint(Buffer& out, const SampleRun& run, const float* xi, bool first) {
    append(out, first ? "\n    [" : ",\n    [");
    appendNumbers(out, run, xi, ", ");
    out.push_back(']');
}

void jsonEnd(Buffer& out) { append(out, "\n  ]\n}\n"); }

constexpr SampleFormat kFormats[] = {
    {"csv", false, noBegin, csvPoint, noEnd},
    {"npy", true, npyBegin, npyPoint, noEnd},
    {"json", false, jsonBegin, jsonPoint, jsonEnd},
};

void flush(Buffer& buffer, OutputFile& out) {
    out.write({buffer.data(), buffer.size()});
    buffer.clear();
}

} // namespace

const SampleFormat& findFormat(const std::string& name) {
    for (const SampleFormat& format : kFormats) {
        if (name == format.name) return format;
    }
    throw CliError(fmt::format("--format: neither csv nor npy nor json: '{}'", name));
}

const SampleFormat& formatOfFile(const std::string& path) {
    if (std::filesystem::path(path).extension().empty()) return kFormats[0];
    const std::string suffix = requireSuffix("--output", path, {".csv", ".txt", ".npy", ".json"});
    for (const SampleFormat& format : kFormats) {
        if (suffix == std::string(".") + format.name) return format;
    }
    return kFormats[0];
}

bool isBinary(const SampleFormat& format) { return format.binary; }

void writeSamples(const SampleRun& run, const SampleFormat& format, OutputFile& out,
                  const std::function<void(double)>& progress) {
    constexpr size_t kFlushBytes = size_t{1} << 16;
    Buffer buffer;
    uint64_t done = 0;
    format.begin(buffer, run);
    drawSamples(run, [&](const float* xi) {
        format.point(buffer, run, xi, done == 0);
        ++done;
        if (buffer.size() < kFlushBytes) return;
        flush(buffer, out);
        progress(static_cast<double>(done) / static_cast<double>(run.count));
    });
    format.end(buffer);
    flush(buffer, out);
}

} // namespace wellstrat::cli
