// SPDX-License-Identifier: Apache-2.0

#include "subjects.h"

#include "common/command_line/errors.h"
#include "points/sampling.h"
#include "wellstrat/camera.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace wellstrat::cli {
namespace {

using Streams = std::vector<SampleStream>;

std::string fileName(const std::string& path) { return path == "-" ? "standard input" : path; }

/// The patterns of some files, with their names.
class FilePatterns {
public:
    explicit FilePatterns(const PointFiles& files) {
        for (const std::string& path : files.paths) {
            PointFileOptions options = files.options;
            options.path = path;
            add(fileName(path), readPatterns(options));
        }
    }

    Streams take() { return std::move(streams_); }

private:
    void add(const std::string& name, const PatternTable& table) {
        const std::size_t count = table.pointsEach();
        const unsigned dims = table.points.dims;
        numbers_ += table.points.values.size();
        if (numbers_ > kMaxFileNumbers || streams_.size() + table.patterns > kMaxRealizations) {
            throw CliError(
                fmt::format("'{}': has, with the files before, more than {} patterns or "
                            "{} numbers, which is as many as are measured",
                            name, kMaxRealizations, kMaxFileNumbers));
        }
        if (!streams_.empty()) {
            const SampleStream& first = streams_.front();
            if (first.points.count() != count || first.points.dims() != dims) {
                throw CliError(fmt::format(
                    "'{}': has {} points in {} dimensions, the files before have {} in {}", name,
                    count, dims, first.points.count(), first.points.dims()));
            }
        }
        const double* values = table.points.values.data();
        for (std::size_t p = 0; p < table.patterns; ++p, values += count * dims) {
            streams_.push_back({table.patterns == 1 ? name : fmt::format("{} pattern {}", name, p),
                                {values, count, dims}});
        }
    }

    Streams streams_;
    std::size_t numbers_ = 0;
};

/// The coordinates of each domain.
Streams domainStreams(const UnitPoints& points, const std::vector<unsigned>& domains) {
    if (std::accumulate(domains.begin(), domains.end(), 0u) != points.dims()) {
        throw CliError(fmt::format("--domains: {} are not the {} dimensions of the points",
                                   fmt::join(domains, " + "), points.dims()));
    }
    Streams streams;
    unsigned next = 0;
    for (const unsigned dims : domains) {
        Projection coordinates(dims);
        std::iota(coordinates.begin(), coordinates.end(), next);
        next += dims;
        streams.push_back(
            {fmt::format("domain {}", streams.size()), points.projection(coordinates)});
    }
    return streams;
}

/// A generator as the families need it.
struct PatternDrawer {
    std::function<UnitPoints(uint32_t)> points, familyPoints;
    std::function<Streams()> domains; ///< of the first pattern
};

PatternDrawer ownDrawer(const NamedGenerator& generator, const GeneratedPoints& generated) {
    const auto points = [&generator, dims = generated.dims,
                         count = generated.count](uint32_t pattern) {
        return drawPoints({&generator, dims, pattern, 0, count});
    };
    const auto domains = [points, first = generated.pattern] {
        Streams streams;
        for (unsigned d = 0; d < kMaxStreams; ++d) {
            const SampleCtx domain = SampleCtx{first, 0}.NewDomain(static_cast<Scramble>(d));
            streams.push_back({fmt::format("domain {}", d), points(domain.patternid)});
        }
        return streams;
    };
    return {points, points, domains};
}

/// The first domain of other sources has the order of the sequence, the same in all patterns; the
/// second one stands for all further ones.
PatternDrawer sourceDrawer(const PointSource& source, const GeneratedPoints& generated) {
    const auto draw = [&source, dims = generated.dims, count = generated.count](uint32_t pattern,
                                                                                unsigned domains) {
        const DomainDims each(domains, dims);
        std::vector<double> values(count * totalDims(each));
        source.draw(pattern, each, count, values.data());
        return UnitPoints(values.data(), count, totalDims(each));
    };
    const DomainDims domains(kMaxIntegrandDomains, generated.dims);
    try {
        source.check(domains, generated.count, uint64_t{1} << 32);
    } catch (const std::invalid_argument& error) {
        throw CliError(fmt::format("{}: {}", generated.name, error.what()));
    }
    const auto second = [draw, dims = generated.dims](uint32_t pattern) {
        return domainStreams(draw(pattern, 2), {dims, dims})[1].points;
    };
    return {[draw](uint32_t pattern) { return draw(pattern, 1); }, second,
            [draw, domains, first = generated.pattern] {
                return domainStreams(draw(first, kMaxIntegrandDomains), domains);
            }};
}

PatternDrawer drawerOf(const PointSource& source, const GeneratedPoints& generated) {
    for (const NamedGenerator& own : namedGenerators()) {
        if (own.name == generated.name) return ownDrawer(own, generated);
    }
    return sourceDrawer(source, generated);
}

Streams firstStreams(const Streams& streams) {
    return {streams.begin(), streams.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(
                                                   streams.size(), kMaxStreams))};
}

} // namespace

Subject fileSubject(const PointFiles& files) {
    const auto patterns = std::make_shared<const Streams>(FilePatterns(files).take());
    Subject subject{fmt::format("{}", fmt::join(files.paths, ", ")), {}};
    if (files.paths.size() == 1) subject.name = fileName(files.paths.front());
    subject.set.points = [patterns](std::size_t r) { return (*patterns)[r].points; };
    subject.set.realizations = patterns->size();
    if (patterns->size() > 1) {
        for (const SampleStream& pattern : *patterns) subject.set.names.push_back(pattern.name);
        subject.set.families.push_back(
            {"patterns", [patterns] { return firstStreams(*patterns); }});
    }
    if (!files.domains.empty()) {
        Streams domains = domainStreams(patterns->front().points, files.domains);
        if (domains.size() > 1) {
            subject.set.families.push_back(
                {"domains", [streams = std::move(domains)] { return streams; }});
        }
    }
    return subject;
}

Subject generatorSubject(const GeneratedPoints& generated, const PointSource& source) {
    const PatternDrawer drawer = drawerOf(source, generated);
    const uint32_t first = generated.pattern;
    const auto patterns = [draw = drawer.familyPoints, first] {
        Streams streams;
        for (unsigned s = 0; s < kMaxStreams; ++s) {
            streams.push_back({fmt::format("pattern {}", first + s), draw(first + s)});
        }
        return streams;
    };
    const auto pixels = [draw = drawer.familyPoints] {
        Streams streams;
        for (unsigned s = 0; s < kMaxStreams; ++s) {
            const int x = static_cast<int>(s % 2), y = static_cast<int>(s / 2 % 2);
            const unsigned frame = s / 4;
            streams.push_back({fmt::format("pixel ({}, {}) frame {}", x, y, frame),
                               draw(cameraContext(x, y, frame, 0).patternid)});
        }
        return streams;
    };
    return {fmt::format("{}, pattern {}", generated.name, first),
            {[points = drawer.points, first](std::size_t r) {
                 return points(first + static_cast<uint32_t>(r));
             },
             generated.realizations,
             {},
             {{"patterns", patterns}, {"pixels and frames", pixels}, {"domains", drawer.domains}}}};
}

} // namespace wellstrat::cli
