// SPDX-License-Identifier: Apache-2.0
//
// Do streams of samples, such as two domains of a pixel or two pixels, know of each other?
//
// Sample i of one stream is used together with sample i of another. Each coordinate of the one
// against each of the other is a set of points in the unit square, of which two things are asked:
//
//     correlation   Pearson's, against its standard deviation
//     chi-square    of the counts in a grid of cells. Sees dependence without correlation. Counts
//                   that are too even are dependence, too
//
// Streams are independent if a nested shuffle of the order of one (Owen 1995: halves of halves of
// the indices, each swapped or not by a coin) changes nothing in what is likely. That is so for
// random points, and for nets in scrambled order, whose order keeps blocks together and so is not
// quite random. From the shuffles follow the variance of the correlation, exactly, whatever the
// values are, and the counts of two nets: where each aligned block of as many points as the grid
// has rows visits each row once, in one order but for nested shuffles, and each column likewise,
// the counts are numbers of heads of fair coins, and chi-square is the sum of (heads - tails)^2 /
// coins. All other pairs are contingency tables: chi-square is that of Pearson (1900) against what
// rows and columns lead to expect, as in random orders. The one case that is neither, two
// coordinates stratified in time otherwise than by nested shuffles, such as Halton's, may look
// less independent than it is.
//
// The distribution of chi-square, which is continuous, holds counts that are very even for far too
// unlikely, down to impossible. Their probability is therefore at least that of exactly these
// counts: a product of binomial ones, or, if rows and columns are given, that of Fisher (1922).

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
    double correlationDeviation;  ///< its standard deviation if independent; 0 if it must be 0
    double chiSquare; ///< over its expectation, the degrees of freedom; 1 if these are 0
    double correlationProbability; ///< of a correlation at least as far from 0, if independent
    double chiSquareProbability;   ///< of a chi-square at least as far out on its side, twice

    /// Of the more unlikely of both, both having been tried: a correction of Bonferroni's.
    WELLSTRAT_API double probability() const;
};

struct IndependenceReport {
    std::size_t pairs = 0;             ///< coordinate pairs tested
    double correlationSpread = 0;      ///< root mean square of correlations, each over its
                                       ///< standard deviation; about 1
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
