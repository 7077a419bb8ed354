// SPDX-License-Identifier: Apache-2.0

#include "point_file.h"

#include "binary_points.h"
#include "npy.h"
#include "text_points.h"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <string_view>

namespace wellstrat::cli {
namespace {

constexpr std::string_view kFormats[] = {"text", "npy", "raw", "utk"};

std::string_view formatOf(const PointFileOptions& options, ByteSource& source) {
    if (options.format) {
        for (const std::string_view format : kFormats) {
            if (format == *options.format) return format;
        }
        throw CliError(fmt::format("--format: none of text, npy, raw, utk: '{}'", *options.format));
    }
    std::filesystem::path path = options.path;
    if (path.extension() == ".gz") path = path.stem();
    const std::string suffix = path.extension().string();
    if (suffix == ".npy" || source.startsWith(kNpyMagic)) return "npy";
    if (source.startsWith(kUtkMagic)) return "utk";
    return suffix == ".bin" || suffix == ".raw" ? "raw" : "text";
}

template <class Number>
std::optional<Number> parsed(std::string_view text) {
    Number value{};
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size()) return {};
    return value;
}

std::optional<double> scaleOf(const PointFileOptions& options) {
    if (!options.scale) return {};
    constexpr std::string_view kPower = "2^";
    const std::string_view text = *options.scale;
    std::optional<double> scale;
    if (text.substr(0, kPower.size()) != kPower) {
        scale = parsed<double>(text);
    } else if (const auto exponent = parsed<int>(text.substr(kPower.size()))) {
        scale = std::ldexp(1.0, *exponent);
    }
    if (scale && std::isfinite(*scale) && *scale > 0) return scale;
    throw CliError(
        fmt::format("--scale: '{}' is neither a positive number nor a power such as 2^-32", text));
}

PatternTable readRaw(ByteSource& source, const PointFileOptions& options) {
    const std::optional<NumberType> type = numberTypeNamed(options.type);
    if (!type) {
        throw CliError(fmt::format("--type: none of {}: '{}'", kNumberTypeNames, options.type));
    }
    if (!options.dims) throw CliError("raw numbers need --dims, the number of each point's");
    return readRawPoints(source, *type, *options.dims, scaleOf(options));
}

} // namespace

PatternTable readPatterns(const PointFileOptions& options) {
    ByteSource source(options.path);
    const std::string_view format = formatOf(options, source);
    if (format == "raw") return readRaw(source, options);
    if (options.dims) {
        throw CliError(fmt::format(
            "--dims goes with --generator or raw numbers; the dimensions of '{}' are its own",
            source.name()));
    }
    if (format == "npy") return readNpyPoints(source, scaleOf(options));
    if (format == "utk") return readUtkPoints(source, scaleOf(options));
    return readTextPoints(source, scaleOf(options));
}

} // namespace wellstrat::cli
