// SPDX-License-Identifier: Apache-2.0

#include "binary_points.h"

#include "npy.h"

#include <array>
#include <cstring>
#include <vector>

namespace wellstrat::cli {
namespace {

void setScale(PointReader& reader, const NumberType& type, std::optional<double> scale) {
    if (!scale) scale = type.usualScale();
    if (!scale) {
        reader.fail(
            "holds signed integers, 'int{}', which could mean more than one thing; say what "
            "to multiply them by, such as --scale 2^-{}",
            8 * type.bytes, 8 * type.bytes - 1);
    }
    reader.setScale(*scale);
}

/// Adds numbers to the end of the source, in sets of `setSize` numbers.
void readNumbers(ByteSource& source, PointReader& reader, const NumberType& type,
                 uint64_t setSize) {
    char bytes[sizeof(uint64_t)];
    for (;;) {
        const std::size_t got = source.read(bytes, type.bytes);
        if (got == 0) break;
        const std::size_t point = reader.size() / reader.dims();
        const auto place = [&] { return fmt::format("point {}", point); };
        if (got < type.bytes) reader.fail("ends within a number, in {}", place());
        reader.add(type.decode(bytes), place);
        if (reader.size() % setSize == 0) reader.endSet(place);
    }
}

/// The sets after a header that says how many there are.
void readSets(ByteSource& source, PointReader& reader, const NumberType& type, uint64_t sets,
              uint64_t count) {
    reader.requireRoom(sets, count);
    const uint64_t setSize = count * reader.dims();
    readNumbers(source, reader, type, std::max<uint64_t>(setSize, 1));
    if (reader.size() != sets * setSize) {
        reader.fail("has {} numbers, where its header says {}", reader.size(), sets * setSize);
    }
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

/// UTK's codes of types are their places here.
constexpr std::array<const char*, 6> kUtkTypes{"int32",  "int64",   "uint32",
                                               "uint64", "float32", "float64"};

uint32_t readWord(ByteSource& source, const PointReader& reader) {
    char bytes[sizeof(uint32_t)];
    if (source.read(bytes, sizeof bytes) != sizeof bytes) reader.fail("ends within the UTK header");
    uint32_t word = 0;
    for (unsigned i = sizeof bytes; i-- > 0;) {
        word = word << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return word;
}

} // namespace

PatternTable readRawPoints(ByteSource& source, const NumberType& type, unsigned dims,
                           std::optional<double> scale) {
    PointReader reader(source);
    reader.setDims(dims);
    setScale(reader, type, scale);
    readNumbers(source, reader, type, kMaxFileNumbers);
    if (reader.size() % dims != 0) {
        reader.fail("ends within a point: there are {} numbers, {} for each point", reader.size(),
                    dims);
    }
    reader.endSet([] { return "the end"; });
    return reader.finish();
}

PatternTable readNpyPoints(ByteSource& source, std::optional<double> scale) {
    PointReader reader(source);
    NpyArray array;
    try {
        array = readNpyHeader([&](char* to, std::size_t size) { return source.read(to, size); });
    } catch (const CliError& error) {
        reader.fail("{}", error.what());
    }
    const std::optional<NumberType> type = numberTypeOfNumpy(array.type);
    if (!type) {
        reader.fail("is an array of '{}'; accepted are {}", array.type, kNumberTypeNames);
    }
    const std::size_t axes = array.shape.size();
    if (axes < 1 || axes > 3) {
        reader.fail(
            "is an array with {} axes; accepted are one (points in 1D), two (points, "
            "coordinates) and three (patterns, points, coordinates)",
            axes);
    }
    setScale(reader, *type, scale);
    reader.setDims(axes == 1 ? 1 : array.shape.back());
    readSets(source, reader, *type, axes == 3 ? array.shape[0] : 1, array.shape[axes == 3 ? 1 : 0]);
    PatternTable table = reader.finish();
    if (array.fortranOrder) sortFortranOrder(table);
    return table;
}

PatternTable readUtkPoints(ByteSource& source, std::optional<double> scale) {
    PointReader reader(source);
    source.skip(kUtkMagic);
    const uint32_t code = readWord(source, reader) & 0xffu; // the other bytes are not used
    const uint32_t sets = readWord(source, reader);
    const uint32_t count = readWord(source, reader);
    reader.setDims(readWord(source, reader));
    if (code >= kUtkTypes.size()) {
        reader.fail("holds UTK's numbers of type {}; accepted are 0 to {}", code,
                    kUtkTypes.size() - 1);
    }
    const NumberType type = *numberTypeNamed(kUtkTypes[code]);
    setScale(reader, type, scale);
    readSets(source, reader, type, sets, count);
    return reader.finish();
}

} // namespace wellstrat::cli
