// SPDX-License-Identifier: Apache-2.0

#include "sources.h"

#include "common/command_line/errors.h"
#include "common/command_line/generators.h"
#include "common/command_line/options.h"
#include "common/output/output_file.h"
#include "points/point_file.h"

#include "wellstrat/joint.h"

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
constexpr const char* kJointPrefix = "joint:";

bool startsWith(const std::string& name, const char* prefix) { return name.rfind(prefix, 0) == 0; }

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

/// What "joint:3+7" names.
StudySourceKind jointKind(const std::string& option, const std::string& name) {
    std::vector<unsigned> slots;
    try {
        std::istringstream words(name.substr(std::strlen(kJointPrefix)));
        if (name.back() == '+') throw std::invalid_argument("a slot is missing at the end");
        for (std::string word; std::getline(words, word, '+');) {
            uint64_t slot = 0;
            if (!parseNumber(word, {0, kJointSlots - 1}, slot)) {
                throw std::invalid_argument(fmt::format("'{}' is no slot", word));
            }
            slots.push_back(static_cast<unsigned>(slot));
        }
        if (slots.empty()) throw std::invalid_argument("there is no slot");
        jointSource(slots);
    } catch (const std::invalid_argument& error) {
        throw CliError(
            fmt::format("{}: '{}': {}; accepted are different slots from 0 to {}, as in "
                        "joint:3+7",
                        option, name, error.what(), kJointSlots - 1));
    }
    return {name, "", [slots] { return jointSource(slots); }};
}

/// `more` is what is accepted beside generators.
StudySourceKind findKind(const std::string& option, const std::string& name, const char* more) {
    if (startsWith(name, kJointPrefix)) return jointKind(option, name);
    std::vector<std::string> names;
    for (StudySourceKind& kind : studySourceKinds()) {
        if (kind.name == name) return std::move(kind);
        names.push_back(kind.name);
    }
    throw CliError(fmt::format("{}: no generator is called '{}'; there are {}{}", option, name,
                               fmt::join(names, ", "), more));
}

PointSourcePtr makeSource(const std::string& name) {
    if (startsWith(name, kFilePrefix)) {
        PointFileOptions options;
        options.path = name.substr(std::strlen(kFilePrefix));
        if (options.path != "-") declareInput(options.path);
        return std::make_unique<FileSource>(readPatterns(options));
    }
    return findKind("--generators", name, ", joint:SLOT+SLOT, file:PATH").make();
}

} // namespace

std::vector<StudySourceKind> studySourceKinds() {
    std::vector<StudySourceKind> kinds;
    for (const NamedGenerator& generator : namedGenerators()) {
        kinds.push_back({generator.name, generator.description,
                         [g = generator.generator] { return generatorSource(g); }});
    }
    kinds.push_back({"joint", "the tables, domains stratified together: slots 0, 1, 2, ...",
                     [] { return jointSource(); }});
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

StudySourceKind findStudySource(const std::string& option, const std::string& name) {
    return findKind(option, name, ", joint:SLOT+SLOT");
}

std::vector<StudySource> makeStudySources(const std::vector<std::string>& names) {
    std::vector<StudySource> sources;
    for (const std::string& name : eachOnce(names)) sources.push_back({name, makeSource(name)});
    return sources;
}

} // namespace wellstrat::cli
