// SPDX-License-Identifier: Apache-2.0
//
// More spectra of kinds of functions, of models of pairs.

#pragma once

#include "bank_search/level_function.h"
#include "bank_search/level_spectra.h"

#include <algorithm>
#include <cstdlib>

namespace wellstrat::bank {

using levels::box;
using levels::edge;
using levels::powerOfTwo;
using levels::smooth;
using levels::smooth1D;
using levels::step1D;
using levels::toInt;

// All have a mean square of 1 beside what varies, or of 0.1 where only certain levels do.

inline constexpr double kBandMean = 0.1;

/// Detail of about 2^p periods.
inline double band1D(unsigned k, unsigned p) {
    return powerOfTwo(-2 * std::abs(toInt(k) - toInt(p)));
}

/// An edge along an axis.
inline double step(unsigned k, unsigned l) { return k > 0 && l > 0 ? 0 : box(k, l); }

/// A smooth function and an edge of x, y and z.
inline double smooth3D(unsigned k, unsigned l, unsigned j) {
    const int axes = (k > 0) + (l > 0) + (j > 0);
    return powerOfTwo(-2 * toInt(k + l + j) - std::max(axes - 1, 0));
}
inline double edge3D(unsigned k, unsigned l, unsigned j) {
    unsigned levels[] = {k, l, j};
    std::sort(levels, levels + 3);
    return powerOfTwo(2 * toInt(levels[0]) - toInt(levels[1]) - 2 * toInt(levels[2]));
}

/// A plane edge that is parallel to one of the axes.
inline double edgeOfTwoAxes(unsigned k, unsigned l, unsigned j) {
    if (k > 0 && l > 0 && j > 0) return 0;
    return j == 0 ? edge(k, l) : edge(std::max(k, l), j);
}

template <typename Of>
inline Spectrum ofX(Of of) {
    return [of](unsigned k, unsigned l, unsigned j) { return l + j > 0 ? 0.0 : of(k); };
}
template <typename Of>
inline Spectrum ofZ(Of of) {
    return [of](unsigned k, unsigned l, unsigned j) { return k + l > 0 ? 0.0 : of(j); };
}
template <typename Of>
inline Spectrum ofXY(Of of) {
    return [of](unsigned k, unsigned l, unsigned j) { return j > 0 ? 0.0 : of(k, l); };
}

/// Detail of about 2^p periods along one axis and 2^q along the other.
inline Spectrum band(unsigned p, unsigned q) {
    return ofXY([p, q](unsigned k, unsigned l) {
        if (k == 0 && l == 0) return kBandMean;
        return k == 0 || l == 0 ? 0.0 : band1D(k, p) * band1D(l, q);
    });
}

/// The same along one axis only.
inline Spectrum stripes(unsigned p) {
    return ofXY([p](unsigned k, unsigned l) {
        if (k == 0 && l == 0) return kBandMean;
        return k > 0 && l > 0 ? 0.0 : band1D(k + l, p);
    });
}

} // namespace wellstrat::bank
