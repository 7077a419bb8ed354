// SPDX-License-Identifier: Apache-2.0
//
// Do streams of samples, such as two domains of a pixel or two pixels, know of each other?
//
// Sample i of one stream is used together with sample i of another. Each coordinate of the one
// against each of the other is a set of points in the unit square, of which two things are asked:
//
//     correlation   Pearson's, against its spread under a random order, 1 / sqrt(N - 1)
//     chi-square    of the counts in a grid of cells, against what their rows and columns lead to
//                   expect (Pearson 1900; the test of independence in a contingency table). Sees
//                   dependence without correlation. Counts that are too even are dependence, too;
//                   but the distribution of chi-square, which is continuous, holds them for far
//                   too unlikely, down to impossible. Their probability is therefore at least that
//                   of exactly these counts, if rows and columns are given (Fisher 1922)
//
// The order of well-stratified streams is not quite random (a nested shuffle keeps blocks
// together), so that probabilities of pairs of them are a yardstick more than a test of a
// hypothesis.

#pragma once

#include "wellstrat/analysis/unit_points.h"
#include "wellstrat/platform.h"

#include <cstddef>
#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

struct SampleStream {
    std::string name;
    UnitPoints points;
};

/// What was found of one coordinate of a stream and one of another.
struct CoordinatePair {
    std::size_t first, second;    ///< streams, by their place in the list
    unsigned firstDim, secondDim; ///< coordinates
    double correlation;           ///< in [-1, 1]; 0 if a coordinate is constant
    double chiSquare; ///< over its expectation, the degrees of freedom; 1 if these are 0
    double correlationProbability; ///< of a correlation at least as far from 0, if independent
    double chiSquareProbability;   ///< of a chi-square at least as far out on its side, twice

    /// Of the more unlikely of both, both having been tried: a correction of Bonferroni's.
    WELLSTRAT_API double probability() const;
};

struct IndependenceReport {
    std::size_t pairs = 0;             ///< coordinate pairs tested
    double correlationSpread = 0;      ///< root mean square correlation * sqrt(N - 1); about 1
    double meanChiSquare = 0;          ///< mean of CoordinatePair::chiSquare; about 1
    std::vector<CoordinatePair> worst; ///< the most unlikely first

    /// Of the worst pair, all having been tried: at most 1. Small means dependence.
    WELLSTRAT_API double probability() const;
};

/// Tests each coordinate of each stream against each coordinate of all others, with a grid of
/// gridSide^2 cells, and names the `worstCount` most unlikely pairs; of those too unlikely for a
/// double, whose probability is 0, the most correlated ones first. Throws PointError for less
/// than two streams, different numbers of points, less than three points, and a gridSide outside
/// [2, 1024]. Time: 2 steps a point and pair of coordinates.
WELLSTRAT_API IndependenceReport testIndependence(const std::vector<SampleStream>& streams,
                                                  unsigned gridSide, std::size_t worstCount);

/// The largest power of two from 2 to 32 that leaves eight points or more a cell, or else 2.
WELLSTRAT_API unsigned usualGridSide(std::size_t count);

} // namespace stream1
} // namespace wellstrat
