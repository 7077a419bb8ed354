// SPDX-License-Identifier: Apache-2.0
//
// wellstrat tables: exports the tables for other renderers.

#include "wellstrat/device_tables.h"

#include "commands.h"
#include "common/command_line/errors.h"
#include "common/command_line/options.h"
#include "common/command_line/progress.h"
#include "common/command_line/versions.h"
#include "common/output/output_file.h"
#include "points/npy.h"

#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace wellstrat::cli {
namespace {

constexpr auto kExamples =
    R"(The tables are an array of 384 x 4096 x 3 numbers: table, sample, coordinate (x, y, z), in this
order, the coordinate running fastest. uint32 values are fractions of 2^32 and multiples of 2^8;
float32 values are the same fractions in [0, 1).
  .npy  NumPy array of shape (384, 4096, 3)
  .h    C header that defines the array wellstrat_tables
  .bin  the 4718592 numbers alone, 4 bytes each, little-endian: the number of (table, sample,
        coordinate) begins at byte 4 * ((table * 4096 + sample) * 3 + coordinate)

With --layout they are what draws in GPU kernels read, uint32 words in the order of memory (.npy
with one axis, or .bin): 'xy' has 384 x 4096 words for 2D draws, each of which stands for x and y
of a point, 'z' as many for 1D draws, and 'words' the former and then the latter. 'device' is all
that kernels and shaders of any generator look up, DeviceTables of wellstrat/device_tables.h, and
'computed' its beginning, which is enough for long and blue. docs/gpu.md says how to read them.

Examples:
  wellstrat tables --export tables.npy
  wellstrat tables --export tables.bin --type float32
  wellstrat tables --export wellstrat_tables.h
  wellstrat tables --export xy.bin --layout xy
)";

constexpr unsigned kCoordinates = 3;

using Buffer = fmt::memory_buffer;

/// Appends one number. The first coordinate of a point has c = 0.
using AppendNumber = void (*)(Buffer& out, uint32_t value, unsigned c);

void appendWord(Buffer& out, uint32_t value, unsigned /*c*/) { appendLittleEndian(out, value); }

void appendFloat(Buffer& out, uint32_t value, unsigned /*c*/) {
    appendLittleEndian(out, toUnitFloat(value));
}

/// What stands around a coordinate of a point in C.
const char* before(unsigned c) { return c == 0 ? "\n{" : " "; }
const char* after(unsigned c) { return c == kCoordinates - 1 ? "}," : ","; }

void appendWordLiteral(Buffer& out, uint32_t value, unsigned c) {
    fmt::format_to(std::back_inserter(out), "{}0x{:08x}u{}", before(c), value, after(c));
}

/// All values are multiples of 2^-24, which nine significant digits tell apart.
void appendFloatLiteral(Buffer& out, uint32_t value, unsigned c) {
    fmt::format_to(std::back_inserter(out), "{}{:#.9g}f{}", before(c), toUnitFloat(value),
                   after(c));
}

/// `open` and `close` stand around each table.
void writeTables(OutputFile& out, AppendNumber append, const char* open = "",
                 const char* close = "") {
    Buffer buffer;
    ProgressBar progress("tables");
    for (unsigned table = 0; table < kTableCount; ++table) {
        out.write(open);
        for (unsigned index = 0; index < kTableSize; ++index) {
            for (unsigned c = 0; c < kCoordinates; ++c) {
                append(buffer, tableValue(table, index, static_cast<Coordinate>(c)), c);
            }
        }
        out.write({buffer.data(), buffer.size()});
        out.write(close);
        buffer.clear();
        progress.show((table + 1.0) / kTableCount);
    }
}

void writeHeader(OutputFile& out, bool floats) {
    out.write(fmt::format(
        "/* The sample tables of {0}: {1} tables of {2} points (x, y, z), as\n"
        "   {3}. Made by \"wellstrat tables\". Include it in one source file. */\n"
        "#ifndef WELLSTRAT_TABLES_H\n"
        "#define WELLSTRAT_TABLES_H\n\n"
        "{4}"
        "#define WELLSTRAT_TABLE_COUNT {1}\n"
        "#define WELLSTRAT_TABLE_SIZE {2}\n\n"
        "static const {5} wellstrat_tables[{1}][{2}][{6}] = {{\n",
        versionLine(), kTableCount, kTableSize, floats ? "floats in [0, 1)" : "fractions of 2^32",
        floats ? "" : "#include <stdint.h>\n\n", floats ? "float" : "uint32_t", kCoordinates));
    writeTables(out, floats ? appendFloatLiteral : appendWordLiteral, "{", "\n},\n");
    out.write("};\n\n#endif\n");
}

/// The words of a layout, as they are in memory.
std::vector<uint32_t> wordsOf(const std::string& layout) {
    const auto part = [](DeviceDraws draws) {
        std::vector<uint32_t> words(deviceTableBytes(draws) / sizeof(uint32_t));
        copyDeviceTables(words.data(), draws);
        return words;
    };
    const uint32_t* const words = tables();
    if (layout == "words") return {words, words + 2 * kTablePoints};
    if (layout == "xy") return {words, words + kTablePoints};
    if (layout == "z") return {words + kTablePoints, words + 2 * kTablePoints};
    if (layout == "device") return part(DeviceDraws::all);
    if (layout == "computed") return part(DeviceDraws::computed);
    throw CliError(
        fmt::format("--layout: neither words, xy, z, device nor computed: '{}'", layout));
}

void exportWords(const std::string& path, const std::string& layout) {
    const std::vector<uint32_t> words = wordsOf(layout);
    const std::string suffix = requireSuffix("--export", path, {".npy", ".bin"});
    OutputFile out(path);
    if (suffix == ".npy") out.write(npyHeader("<u4", {words.size()}));
    Buffer buffer;
    for (const uint32_t word : words) appendLittleEndian(buffer, word);
    out.write({buffer.data(), buffer.size()});
    out.commit();
}

void exportTables(const std::string& path, const std::string& type) {
    if (type != "uint32" && type != "float32") {
        throw CliError(fmt::format("--type: neither uint32 nor float32: '{}'", type));
    }
    const bool floats = type == "float32";
    const std::string suffix = requireSuffix("--export", path, {".npy", ".h", ".bin"});
    OutputFile out(path);
    if (suffix == ".h") {
        writeHeader(out, floats);
    } else {
        if (suffix == ".npy") {
            out.write(npyHeader(floats ? "<f4" : "<u4", {kTableCount, kTableSize, kCoordinates}));
        }
        writeTables(out, floats ? appendFloat : appendWord);
    }
    out.commit();
}

} // namespace

void addTables(CLI::App& app, int& /*exitCode*/) {
    CLI::App* const command = app.add_subcommand("tables", "Export the tables");
    const auto path = std::make_shared<std::string>();
    const auto type = std::make_shared<std::string>("uint32");
    const auto layout = std::make_shared<std::string>();
    command->add_option("--export", *path, "The file to write: FILE.npy, FILE.h or FILE.bin")
        ->type_name("FILE")
        ->required();
    auto* const typeOption =
        command->add_option("--type", *type, "uint32 or float32 [uint32]")->type_name("NAME");
    const auto* const layoutOption =
        command
            ->add_option("--layout", *layout, "What kernels read: words, xy, z, device or computed")
            ->type_name("NAME")
            ->excludes(typeOption);
    command->footer(kExamples);
    command->callback([path, type, layout, layoutOption] {
        if (layoutOption->empty()) {
            exportTables(*path, *type);
        } else {
            exportWords(*path, *layout);
        }
    });
}

} // namespace wellstrat::cli
