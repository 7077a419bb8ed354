// SPDX-License-Identifier: Apache-2.0

#include "subject.h"

#include "analyze/subjects.h"
#include "common/command_line/errors.h"
#include "common/command_line/progress.h"
#include "common/output/readable_names.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <utility>

namespace wellstrat::cli {
namespace {

/// Patterns from 0 on.
MeasuredSet setOf(const StudySource& source, unsigned dims, std::size_t count,
                  std::size_t realizations) {
    return generatorSubject({source.name, dims, count, 0, realizations}, *source.source).set;
}

void refuseFiles(const std::vector<StudySource>& sources) {
    for (const StudySource& source : sources) {
        if (!source.description.empty()) continue;
        throw CliError(fmt::format(
            "--generators: '{}' has too few patterns for a report; see 'wellstrat analyze'",
            source.name));
    }
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
    refuseFiles(sources);
    std::vector<ReportSubject> subjects;
    for (const StudySource& source : sources) {
        const auto stream = [&source](unsigned dims, std::size_t count) {
            return SampleStream{generatorTitle(source.name),
                                setOf(source, dims, count, 1).points(0)};
        };
        subjects.push_back({source.name,
                            generatorTitle(source.name),
                            source.description,
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
