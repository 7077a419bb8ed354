// SPDX-License-Identifier: Apache-2.0
//
// What `wellstrat analyze` can measure: the points of files, and of a generator.

#pragma once

#include "measures.h"
#include "points/point_file.h"
#include "wellstrat/analysis/point_source.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat::cli {

/// A point set and its name.
struct Subject {
    std::string name;
    MeasuredSet set;
};

/// More realizations than this are not measured.
constexpr std::size_t kMaxRealizations = 4096;

/// The streams of a family whose independence is tested: the first so many.
constexpr unsigned kMaxStreams = 8;

/// Files are alike in points and dimensions. Each holds a realization, or several of them as an
/// array of NumPy with the axes (patterns, points, coordinates).
struct PointFiles {
    std::vector<std::string> paths;
    PointFileOptions options;      ///< of all; its path is not used
    std::vector<unsigned> domains; ///< the dimensions of the domains that a point consists of, each
                                   ///< at least 1; none: a point is a single domain
};

/// Families: patterns, if there are several; domains, if there are several. Throws CliError.
Subject fileSubject(const PointFiles& files);

/// Points of consecutive patterns of a generator, any that a study can compare.
struct GeneratedPoints {
    std::string name;
    unsigned dims; ///< 1, 2 or 3
    uint64_t count;
    uint32_t pattern; ///< the first one
    uint64_t realizations;
};

/// Families are what a renderer combines: patterns in a row, neighboring pixels and frames, and
/// domains of one context. Our own generators are drawn from as `sample` does. `source` is the
/// generator; it must outlive the subject. Throws CliError if it cannot draw these points.
Subject generatorSubject(const GeneratedPoints& generated, const PointSource& source);

} // namespace wellstrat::cli
