// SPDX-License-Identifier: Apache-2.0

#include "report_subject.h"

#include "errors.h"
#include "progress.h"
#include "subjects.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <utility>

namespace wellstrat::cli {
namespace {

UnitPoints drawDomains(const PointSource& source, uint32_t pattern, const DomainDims& domains,
                       std::size_t count) {
    const unsigned dims = totalDims(domains);
    std::vector<double> values(count * dims);
    source.draw(pattern, domains, count, values.data());
    return {values.data(), count, dims};
}

/// Domain `domain` of several 2D domains.
UnitPoints planeOf(const UnitPoints& points, unsigned domain) {
    return points.projection({2 * domain, 2 * domain + 1});
}

/// The families that generatorSubject takes of our own generators. The first domain of others has
/// the order of the sequence, the same in all patterns; the second one stands for all further ones.
StreamFamilies familiesOf(const PointSource& source, std::size_t count) {
    const auto second = [&](uint32_t pattern) {
        return planeOf(drawDomains(source, pattern, {2, 2}, count), 1);
    };
    const UnitPoints all = drawDomains(source, 0, DomainDims(kMaxIntegrandDomains, 2), count);
    std::vector<SampleStream> domains;
    for (unsigned d = 0; d < kMaxIntegrandDomains; ++d) {
        domains.push_back({fmt::format("domain {}", d), planeOf(all, d)});
    }
    return streamFamilies(second, 0, std::move(domains));
}

const NamedGenerator* ownGenerator(const std::string& name) {
    for (const NamedGenerator& generator : namedGenerators()) {
        if (generator.name == name) return &generator;
    }
    return nullptr;
}

/// Patterns from 0 on: of our own generators as `sample` and `analyze` draw them.
MeasuredSet setOf(const StudySource& source, unsigned dims, std::size_t count,
                  std::size_t realizations) {
    if (const NamedGenerator* const own = ownGenerator(source.name)) {
        return generatorSubject({own, dims, count, 0, realizations}).set;
    }
    const PointSource& points = *source.source;
    return {[&points, dims, count](std::size_t r) {
                return drawDomains(points, static_cast<uint32_t>(r), {dims}, count);
            },
            realizations, familiesOf(points, count)};
}

std::string descriptionOf(const std::string& name) {
    for (const StudySourceKind& kind : studySourceKinds()) {
        if (kind.name == name) return kind.description;
    }
    throw CliError(fmt::format(
        "--generators: '{}' has too few patterns for a report; see 'wellstrat analyze'", name));
}

void measurePlane(const StudySource& source, const ReportSize& size, ReportSubject& subject) {
    subject.inPlane = measure(setOf(source, 2, size.count, 1));
}

void measureCube(const StudySource& source, const ReportSize& size, ReportSubject& subject) {
    MeasuredSet set = setOf(source, 3, size.count, size.realizations);
    set.families.clear();
    subject.inCube = measure(set);
}

} // namespace

std::vector<ReportSubject> measureSubjects(const std::vector<StudySource>& sources,
                                           const ReportSize& size) {
    std::vector<ReportSubject> subjects;
    for (const StudySource& source : sources) {
        const auto stream = [&source](unsigned dims, std::size_t count) {
            return SampleStream{source.name, setOf(source, dims, count, 1).points(0)};
        };
        subjects.push_back({source.name,
                            descriptionOf(source.name),
                            stream(1, kLinePoints),
                            stream(2, kPlanePoints),
                            stream(3, kCubePoints),
                            {},
                            {}});
    }
    ProgressBar progress("measures");
    std::atomic<std::size_t> done{0};
    const std::size_t tasks = 2 * subjects.size();
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
        const auto measureOne = task % 2 == 0 ? measureCube : measurePlane;
        measureOne(sources[task / 2], size, subjects[task / 2]);
        progress.show(static_cast<double>(++done) / static_cast<double>(tasks));
    });
    return subjects;
}

} // namespace wellstrat::cli
