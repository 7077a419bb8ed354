// SPDX-License-Identifier: Apache-2.0

#include "point_file.h"

#include "byte_source.h"
#include "common/command_line/errors.h"
#include "npy.h"
#include "wellstrat/analysis/unit_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string_view>

namespace wellstrat::cli {
namespace {

/// Collects the values of one source and complains in its name.
class PointReader {
public:
    explicit PointReader(ByteSource& source) : source_(source) {}

    template <typename... T>
    [[noreturn]] void fail(fmt::format_string<T...> format, T&&... values) const {
        throw CliError(fmt::format("'{}': {}", source_.name(),
                                   fmt::format(format, std::forward<T>(values)...)));
    }

    void setDims(std::size_t dims) {
        if (dims == 0 || dims > UnitPoints::kMaxDimensions) {
            fail("the points have {} dimensions; accepted are 1 to {}", dims,
                 UnitPoints::kMaxDimensions);
        }
        table_.dims = static_cast<unsigned>(dims);
    }

    /// Of sets of points; one set has room for kMaxFilePoints.
    void makeRoomForPatterns() { maxPoints_ = kMaxPatternNumbers / dims(); }

    void requireRoom(uint64_t patterns, uint64_t count) const {
        if (count > maxPoints_ || (count > 0 && patterns > maxPoints_ / count)) failTooMany();
    }

    /// `place` names where the value stands, such as "line 3".
    template <class Place>
    void add(double value, const Place& place) {
        if (!(value >= 0 && value < 1)) {
            fail("{}: {} is not in [0, 1)", place(), value);
        }
        if (table_.values.size() == maxPoints_ * table_.dims) failTooMany();
        table_.values.push_back(value);
    }

    std::size_t size() const { return table_.values.size(); }
    unsigned dims() const { return table_.dims; }

    PointTable finish() {
        if (table_.values.empty()) fail("holds no points");
        return std::move(table_);
    }

private:
    [[noreturn]] void failTooMany() const {
        fail("holds more than {} points, which is as many as are read", maxPoints_);
    }

    ByteSource& source_;
    PointTable table_;
    std::size_t maxPoints_ = kMaxFilePoints;
};

void skipBlanks(std::string_view& line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size()));
}

/// Splits off what stands before the next separator, which may be nothing.
std::string_view nextField(std::string_view& line) {
    skipBlanks(line);
    const std::string_view field = line.substr(0, line.find_first_of(" \t\r,;"));
    line.remove_prefix(field.size());
    return field;
}

/// Skips one comma or semicolon with the blanks before it. Was there one?
bool skipComma(std::string_view& line) {
    skipBlanks(line);
    if (line.empty() || (line.front() != ',' && line.front() != ';')) return false;
    line.remove_prefix(1);
    return true;
}

/// The start of a field as it may be shown: of other programs' files, which may be no text at all.
std::string shown(std::string_view field) {
    constexpr std::size_t kShown = 40;
    std::string text(field.substr(0, kShown));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

/// The numbers of a line.
void readRow(const PointReader& reader, std::string_view line, std::size_t number,
             std::vector<double>& row) {
    row.clear();
    for (bool afterComma = false;; afterComma = skipComma(line)) {
        const std::string_view field = nextField(line);
        if (field.empty()) {
            if (line.empty() && !afterComma) return;
            reader.fail("line {}: a value is missing beside a comma or semicolon", number);
        }
        double value = 0;
        const char* const end = field.data() + field.size();
        const auto [stop, error] = std::from_chars(field.data(), end, value);
        if (error != std::errc() || stop != end) {
            reader.fail(
                "line {}: '{}' is no number; accepted are points, one a line, their "
                "coordinates separated by commas or blanks, and comments after #",
                number, shown(field));
        }
        row.push_back(value);
    }
}

PointTable readText(ByteSource& source) {
    constexpr std::size_t kMaxLine = 4096;
    PointReader reader(source);
    std::string line;
    std::vector<double> row;
    for (std::size_t number = 1; source.readLine(line, kMaxLine); ++number) {
        if (line.size() == kMaxLine) {
            reader.fail("line {} is longer than {} bytes; accepted is one point a line", number,
                        kMaxLine - 1);
        }
        readRow(reader, std::string_view(line).substr(0, line.find('#')), number, row);
        if (row.empty()) continue;
        if (reader.dims() == 0) reader.setDims(row.size());
        if (row.size() != reader.dims()) {
            reader.fail("line {} has {} values, the lines before have {}", number, row.size(),
                        reader.dims());
        }
        for (const double value : row) {
            reader.add(value, [&] { return fmt::format("line {}", number); });
        }
    }
    return reader.finish();
}

/// A kind of binary floating-point numbers.
struct BinaryType {
    unsigned bytes;
    bool bigEndian;

    double decode(const char* from) const {
        uint64_t bits = 0;
        for (unsigned i = 0; i < bytes; ++i) {
            const auto byte = static_cast<unsigned char>(from[bigEndian ? i : bytes - 1 - i]);
            bits = bits << 8 | byte;
        }
        if (bytes == sizeof(double)) return bitsAs<double>(bits);
        return static_cast<double>(bitsAs<float>(static_cast<uint32_t>(bits)));
    }

private:
    template <class Real, class Bits>
    static Real bitsAs(Bits bits) {
        static_assert(sizeof(Real) == sizeof(Bits));
        Real value;
        std::memcpy(&value, &bits, sizeof value);
        return value;
    }
};

/// Reads numbers to the end and adds them in the order of the points.
void readNumbers(ByteSource& source, PointReader& reader, const BinaryType& type) {
    char bytes[8];
    for (;;) {
        const std::size_t got = source.read(bytes, type.bytes);
        if (got == 0) break;
        const std::size_t point = reader.size() / reader.dims();
        if (got < type.bytes) reader.fail("ends within a number, in point {}", point);
        reader.add(type.decode(bytes), [&] { return fmt::format("point {}", point); });
    }
    if (reader.size() % reader.dims() != 0) {
        reader.fail("ends within a point: there are {} numbers, {} for each point", reader.size(),
                    reader.dims());
    }
}

PointTable readRaw(ByteSource& source, const PointFileOptions& options) {
    if (options.type != "float32" && options.type != "float64") {
        throw CliError(fmt::format("--type: neither float32 nor float64: '{}'", options.type));
    }
    if (!options.dims) throw CliError("raw numbers need --dims, the number of each point's");
    PointReader reader(source);
    reader.setDims(*options.dims);
    readNumbers(source, reader, {options.type == "float32" ? 4u : 8u, false});
    return reader.finish();
}

/// Numbers stored with the first of the three axes fastest, in the order of the points.
void sortFortranOrder(PatternTable& table) {
    const std::vector<double> values = table.points.values;
    const std::size_t patterns = table.patterns, count = table.pointsEach();
    double* to = table.points.values.data();
    for (std::size_t p = 0; p < patterns; ++p) {
        for (std::size_t i = 0; i < count; ++i) {
            for (unsigned d = 0; d < table.points.dims; ++d) {
                *to++ = values[p + patterns * (i + count * d)];
            }
        }
    }
}

PatternTable readNpy(ByteSource& source) {
    PointReader reader(source);
    NpyArray array;
    try {
        array = readNpyHeader([&](char* to, std::size_t size) { return source.read(to, size); });
    } catch (const CliError& error) {
        reader.fail("{}", error.what());
    }
    if (array.type != "<f4" && array.type != ">f4" && array.type != "<f8" && array.type != ">f8") {
        reader.fail("is an array of '{}'; accepted are float32 and float64, '<f4' and '<f8'",
                    array.type);
    }
    const std::size_t axes = array.shape.size();
    if (axes < 1 || axes > 3) {
        reader.fail(
            "is an array with {} axes; accepted are one (points in 1D), two (points, "
            "coordinates) and three (patterns, points, coordinates)",
            axes);
    }
    const uint64_t patterns = axes == 3 ? array.shape[0] : 1;
    const uint64_t count = array.shape[axes == 3 ? 1 : 0];
    reader.setDims(axes == 1 ? 1 : array.shape.back());
    reader.requireRoom(1, count);
    if (axes == 3) reader.makeRoomForPatterns();
    reader.requireRoom(patterns, count);
    readNumbers(source, reader, {array.type[2] == '4' ? 4u : 8u, array.type[0] == '>'});
    const uint64_t numbers = patterns * count * reader.dims();
    if (reader.size() != numbers) {
        reader.fail("has {} numbers, where its header says {}", reader.size(), numbers);
    }
    PatternTable table{reader.finish(), patterns};
    if (array.fortranOrder) sortFortranOrder(table);
    return table;
}

constexpr std::string_view kFormats[] = {"text", "npy", "raw"};

std::string_view formatOf(const PointFileOptions& options, ByteSource& source) {
    if (options.format) {
        for (const std::string_view format : kFormats) {
            if (format == *options.format) return format;
        }
        throw CliError(fmt::format("--format: none of text, npy, raw: '{}'", *options.format));
    }
    const std::string suffix = std::filesystem::path(options.path).extension().string();
    if (suffix == ".npy" || source.startsWith(kNpyMagic)) return "npy";
    return suffix == ".bin" || suffix == ".raw" ? "raw" : "text";
}

} // namespace

PatternTable readPatterns(const PointFileOptions& options) {
    ByteSource source(options.path);
    const std::string_view format = formatOf(options, source);
    if (options.dims && format != "raw") {
        throw CliError(fmt::format(
            "--dims goes with --generator or raw numbers; the dimensions of '{}' are its own",
            source.name()));
    }
    if (format == "npy") return readNpy(source);
    return {format == "raw" ? readRaw(source, options) : readText(source)};
}

} // namespace wellstrat::cli
