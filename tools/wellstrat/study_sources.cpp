// SPDX-License-Identifier: Apache-2.0

#include "study_sources.h"

#include "errors.h"
#include "point_file.h"
#include "sampling.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>

namespace wellstrat::cli {
namespace {

constexpr const char* kFilePrefix = "file:";

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

/// `more` is what is accepted beside generators.
StudySourceKind findKind(const std::string& option, const std::string& name, const char* more) {
    std::vector<std::string> names;
    for (StudySourceKind& kind : studySourceKinds()) {
        if (kind.name == name) return std::move(kind);
        names.push_back(kind.name);
    }
    throw CliError(fmt::format("{}: no generator is called '{}'; there are {}{}", option, name,
                               fmt::join(names, ", "), more));
}

PointSourcePtr makeSource(const std::string& name) {
    if (name.rfind(kFilePrefix, 0) == 0) {
        PointFileOptions options;
        options.path = name.substr(std::strlen(kFilePrefix));
        return std::make_unique<FileSource>(readPatterns(options));
    }
    return findKind("--generators", name, ", file:PATH").make();
}

} // namespace

std::vector<StudySourceKind> studySourceKinds() {
    std::vector<StudySourceKind> kinds;
    for (const NamedGenerator& generator : namedGenerators()) {
        kinds.push_back({generator.name, generator.description,
                         [g = generator.generator] { return generatorSource(g); }});
    }
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
    return findKind(option, name, "");
}

std::vector<StudySource> makeStudySources(const std::vector<std::string>& names) {
    std::vector<StudySource> sources;
    for (const std::string& name : names) {
        const auto same = [&](const StudySource& source) { return source.name == name; };
        if (std::any_of(sources.begin(), sources.end(), same)) continue;
        sources.push_back({name, makeSource(name)});
    }
    return sources;
}

} // namespace wellstrat::cli
