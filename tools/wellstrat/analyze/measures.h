// SPDX-License-Identifier: Apache-2.0
//
// All measures of a point set, taken at once.

#pragma once

#include "wellstrat/analysis/discrepancy.h"
#include "wellstrat/analysis/geometry.h"
#include "wellstrat/analysis/independence.h"
#include "wellstrat/analysis/spectrum.h"
#include "wellstrat/analysis/unit_points.h"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace wellstrat::cli {

/// The measures that take longest are left out beyond this: L2 discrepancies in more than three
/// dimensions, whose time grows with the square of the number of points, and there t of all aligned
/// blocks.
constexpr std::size_t kMaxSquarePoints = std::size_t{1} << 17;

/// Streams that ought to be independent, by what tells them apart, such as "patterns". They may
/// take much memory: they are made when they are tested.
struct StreamFamily {
    std::string name;
    std::function<std::vector<SampleStream>()> streams; ///< pure
};

/// What to measure.
struct MeasuredSet {
    /// The points of a realization in [0, realizations), all alike in number and dimensions. Pure;
    /// called in several threads at once. Spectra are the mean of all.
    std::function<UnitPoints(std::size_t)> points;
    std::size_t realizations;
    /// Names of the realizations, if each is to be measured by itself; else only the first one is.
    std::vector<std::string> names;
    std::vector<StreamFamily> families;
};

using Projection = std::vector<unsigned>;

/// "(x, y)", or "(x1, x4)" if there are more than three dimensions.
std::string projectionName(const Projection& projection, unsigned dims);

/// The quality of a projection as a net in base 2.
struct NetQuality {
    Projection projection;
    unsigned t;
    std::optional<unsigned> sequenceT;   ///< of all aligned blocks
    std::optional<bool> holdsBase4Boxes; ///< up to three dimensions, powers of four points
};

struct NamedL2 {
    const char* name;
    L2Kind kind;
};
constexpr std::array<NamedL2, 5> kL2Kinds{{{"star", L2Kind::star},
                                           {"centered", L2Kind::centered},
                                           {"wrap_around", L2Kind::wrapAround},
                                           {"mixture", L2Kind::mixture},
                                           {"modified", L2Kind::modified}}};

struct PlaneSpectrum {
    Projection projection;
    Periodogram periodogram;
    RadialSpectrum radial;
    SpectralPeak peak;
};

struct FamilyIndependence {
    std::string name;
    std::vector<std::string> streams; ///< their names
    unsigned gridSide;
    IndependenceReport report;
};

/// Which measures to take.
struct MeasureChoice {
    bool nets = true, star = true, l2 = true, distances = true, pairs = true, spectra = true,
         independence = true;
};

/// What was found of one set. Empty or without a value: left out, or not there for this number of
/// points or dimensions.
struct SetMeasures {
    std::vector<NetQuality> nets;
    std::array<std::optional<double>, kL2Kinds.size()> l2;
    std::optional<StarBounds> star;
    std::optional<NearestDistances> onCube, onTorus;
    std::optional<PairCorrelation> pairs;
};

struct NamedSetMeasures {
    std::string name;
    SetMeasures found;
};

/// What was found: of the first set, and of all.
struct Measures : SetMeasures {
    MeasureChoice choice;
    std::size_t count, realizations;
    unsigned dims;
    std::vector<NamedSetMeasures> sets; ///< those with names, in order
    std::vector<PlaneSpectrum> spectra;
    std::vector<FamilyIndependence> independence;
};

/// Takes the measures on all cores. The same whatever their number. `progress`, if there is any, is
/// called now and then with the share that is done, in several threads at once.
Measures measure(const MeasuredSet& set, const MeasureChoice& choice = {},
                 const std::function<void(double)>& progress = {});

} // namespace wellstrat::cli
