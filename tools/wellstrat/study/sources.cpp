// SPDX-License-Identifier: Apache-2.0

#include "sources.h"

#include "common/command_line/errors.h"
#include "common/command_line/generators.h"
#include "common/command_line/options.h"
#include "common/output/output_file.h"
#include "points/point_file.h"
#include "rivals/tile.h"
#include "rivals/zsobol.h"

#include "wellstrat/blue.h"
#include "wellstrat/joint.h"
#include "wellstrat/long.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace wellstrat::cli {
namespace {

constexpr const char* kFilePrefix = "file:";

bool startsWith(const std::string& name, const char* prefix) { return name.rfind(prefix, 0) == 0; }

/// Where the contexts of a pixel begin, as the generator says; null is the tables.
PixelPattern patternOf(const Generator* generator) {
    if (!generator) return cameraPattern;
    return [generator](int x, int y, uint32_t seed) {
        return generator->CameraContext(x, y, seed, 0).patternid;
    };
}

/// The points of a file, of one pattern or many. Domains take one coordinate after the other.
class FileSource final : public PointSource {
public:
    explicit FileSource(PatternTable table) : table_(std::move(table)) {}

    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        const unsigned dims = totalDims(domains), dimsInFile = table_.points.dims;
        const double* point =
            table_.points.values.data() + pattern * table_.pointsEach() * dimsInFile;
        for (std::size_t i = 0; i < count; ++i, point += dimsInFile) {
            std::copy(point, point + dims, points + i * dims);
        }
    }

    void check(const DomainDims& domains, std::size_t count, uint64_t patterns) const override {
        if (totalDims(domains) > table_.points.dims || count > table_.pointsEach() ||
            patterns > table_.patterns) {
            throw std::invalid_argument(fmt::format(
                "the file has {} patterns of {} points in {} dimensions, not {} of {} in {}",
                table_.patterns, table_.pointsEach(), table_.points.dims, patterns, count,
                totalDims(domains)));
        }
    }

private:
    PatternTable table_;
};

/// Names before slots, as in "joint:3+7", and the generator that these are of, as jointSource takes
/// it.
struct SlotKind {
    const char* prefix;
    const Generator* generator;
};

const std::vector<SlotKind>& slotKinds() {
    static const LongProgressive longSamples;
    static const BlueProgressive blue;
    static const std::vector<SlotKind> kinds{
        {"joint:", nullptr}, {"long:", &longSamples}, {"blue:", &blue}};
    return kinds;
}

/// What "joint:3+7" names.
StudySourceKind jointKind(const std::string& option, const std::string& name,
                          const SlotKind& kind) {
    std::vector<unsigned> slots;
    try {
        std::istringstream words(name.substr(std::strlen(kind.prefix)));
        if (name.back() == '+') throw std::invalid_argument("a slot is missing at the end");
        for (std::string word; std::getline(words, word, '+');) {
            uint64_t slot = 0;
            if (!parseNumber(word, {0, kJointSlots - 1}, slot)) {
                throw std::invalid_argument(fmt::format("'{}' is no slot", word));
            }
            slots.push_back(static_cast<unsigned>(slot));
        }
        if (slots.empty()) throw std::invalid_argument("there is no slot");
        jointSource(slots, kind.generator);
    } catch (const std::invalid_argument& error) {
        throw CliError(
            fmt::format("{}: '{}': {}; accepted are different slots from 0 to {}, as in {}3+7",
                        option, name, error.what(), kJointSlots - 1, kind.prefix));
    }
    return {name, fmt::format("slots of {}, for one domain each", name.substr(0, name.find(':'))),
            [slots, g = kind.generator] { return jointSource(slots, g); },
            patternOf(kind.generator)};
}

/// The one of `kinds`, or joint:SLOT+SLOT and its kin; `more` is what is accepted beside them.
StudySourceKind findKind(const std::string& option, const std::string& name,
                         std::vector<StudySourceKind> kinds, const char* more) {
    for (const SlotKind& kind : slotKinds()) {
        if (startsWith(name, kind.prefix)) return jointKind(option, name, kind);
    }
    std::vector<std::string> names;
    for (StudySourceKind& kind : kinds) {
        if (kind.name == name) return std::move(kind);
        names.push_back(kind.name);
    }
    throw CliError(
        fmt::format("{}: no generator is called '{}'; there are {}, joint:SLOT+SLOT, "
                    "long:SLOT+SLOT, blue:SLOT+SLOT{}",
                    option, name, fmt::join(names, ", "), more));
}

StudySource makeSource(const std::string& name) {
    if (startsWith(name, kFilePrefix)) {
        PointFileOptions options;
        options.path = name.substr(std::strlen(kFilePrefix));
        if (options.path != "-") declareInput(options.path);
        return {name, std::make_unique<FileSource>(readPatterns(options)), cameraPattern, ""};
    }
    const StudySourceKind kind = findKind("--generators", name, studySourceKinds(), ", file:PATH");
    return {name, kind.make(), cameraPattern, kind.description};
}

StudySource makePictureSource(const std::string& name) {
    if (startsWith(name, kFilePrefix)) {
        throw CliError(
            fmt::format("--generators: '{}': the points of a file are for no pixels; "
                        "leave it or --filter out",
                        name));
    }
    std::vector<StudySourceKind> kinds = studySourceKinds();
    for (StudySourceKind& kind : rivalSourceKinds()) kinds.push_back(std::move(kind));
    const StudySourceKind kind = findKind("--generators", name, std::move(kinds), "");
    return {name, kind.make(), kind.patternOf, kind.description};
}

/// What make(name) gives for each name, repetitions dropped.
template <typename Make>
std::vector<StudySource> makeAll(const std::vector<std::string>& names, Make make) {
    std::vector<StudySource> sources;
    for (const std::string& name : eachOnce(names)) sources.push_back(make(name));
    return sources;
}

} // namespace

std::vector<StudySourceKind> studySourceKinds() {
    std::vector<StudySourceKind> kinds;
    for (const NamedGenerator& generator : namedGenerators()) {
        kinds.push_back({generator.name, generator.description,
                         [g = generator.generator] { return generatorSource(g); },
                         patternOf(generator.generator)});
    }
    kinds.push_back({"joint", "the tables, domains stratified together: slots 0, 1, 2, ...",
                     [] { return jointSource(); }});
    kinds.push_back({"long-words", "long with all 32 bits of a sample, of which floats have 24",
                     sequenceSource});
    const auto addSobol = [&](const char* name, const char* description,
                              SobolRandomization randomization) {
        kinds.push_back({name, description, [=] { return sobolSource(randomization); }});
    };
    addSobol("sobol-owen", "Sobol' with exact Owen scrambling", SobolRandomization::owen);
    addSobol("sobol-shift", "Sobol' with a random digital shift", SobolRandomization::digitalShift);
    addSobol("sobol", "Sobol', the same points for each pattern", SobolRandomization::none);
    kinds.push_back({"halton", "Halton, shifted at random", haltonSource});
    kinds.push_back({"jitter", "jittered grids, new ones for each N", jitteredSource});
    for (StudySourceKind& kind : librarySourceKinds()) kinds.push_back(std::move(kind));
    return kinds;
}

std::vector<StudySourceKind> rivalSourceKinds() {
    return {{"zsobol", "one Sobol' sequence over all pixels, knows N (Ahmed and Wonka 2020)",
             rivals::zsobolSource, rivals::zsobolPattern},
            {"tile", "from a tile annealed at first use (Heitz et al. 2019)", rivals::tileSource,
             rivals::tilePattern}};
}

StudySourceKind findStudySource(const std::string& option, const std::string& name) {
    return findKind(option, name, studySourceKinds(), "");
}

std::vector<StudySource> makeStudySources(const std::vector<std::string>& names) {
    return makeAll(names, makeSource);
}

std::vector<StudySource> makePictureSources(const std::vector<std::string>& names) {
    return makeAll(names, makePictureSource);
}

} // namespace wellstrat::cli
