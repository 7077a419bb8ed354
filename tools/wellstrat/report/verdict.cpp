// SPDX-License-Identifier: Apache-2.0

#include "verdict.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wellstrat::cli {
namespace {

/// The place of the largest power of two among the counts; of the last one if there is none.
std::size_t lastPowerOfTwo(const std::vector<uint32_t>& counts) {
    for (std::size_t c = counts.size(); c-- > 0;) {
        if ((counts[c] & (counts[c] - 1)) == 0) return c;
    }
    return counts.size() - 1;
}

/// The geometric mean, over the integrals that both have an error of, of one generator's RMSE over
/// another's; not a number if there are none.
double relativeError(const ReportContents& contents, std::size_t generator, std::size_t other,
                     std::size_t count) {
    const std::size_t generators = contents.subjects.size();
    double logs = 0, integrals = 0;
    for (std::size_t first = 0; first < contents.curves.size(); first += generators) {
        const double a = contents.curves[first + generator].errors[count].rmse;
        const double b = contents.curves[first + other].errors[count].rmse;
        if (!(a > 0 && b > 0)) continue;
        logs += std::log(a / b);
        ++integrals;
    }
    return integrals > 0 ? std::exp(logs / integrals) : std::numeric_limits<double>::quiet_NaN();
}

} // namespace

std::string verdictOf(const ReportContents& contents) {
    const auto& subjects = contents.subjects;
    if (subjects.size() == 1) {
        return fmt::format("Nothing is compared: there are only the points of \u201c{}\u201d.",
                           subjects.front().title);
    }
    const auto random =
        std::find_if(subjects.begin(), subjects.end(),
                     [](const ReportSubject& subject) { return subject.name == "random"; });
    const auto baseline = static_cast<std::size_t>(
        (random == subjects.end() ? subjects.end() - 1 : random) - subjects.begin());
    const std::size_t count = lastPowerOfTwo(contents.plan.counts);
    std::size_t best = baseline;
    double least = 1;
    for (std::size_t g = 0; g < subjects.size(); ++g) {
        const double relative = relativeError(contents, g, baseline, count);
        if (!(relative < least)) continue;
        best = g;
        least = relative;
    }
    const std::string points = fmt::format("With {} points", contents.plan.counts[count]);
    if (best == baseline) {
        return fmt::format("{}, none has less error of integrals than \u201c{}\u201d.", points,
                           subjects[baseline].title);
    }
    return fmt::format(
        "{}, \u201c{}\u201d has the least error of integrals of these {}: {:.2g} of "
        "that of \u201c{}\u201d, in the geometric mean.",
        points, subjects[best].title, subjects.size(), least, subjects[baseline].title);
}

} // namespace wellstrat::cli
