// SPDX-License-Identifier: Apache-2.0
//
// Integrands that vary slowly from pixel to pixel, as pictures do away from silhouettes: to see
// what neighboring pixels make of their errors together (picture_error.h).
//
//     const IntegrandPicture edges = makeIntegrandPicture("edge", 76);
//     edges.at(3, 5).integral               // the true value of pixel (3, 5)

#pragma once

#include "wellstrat/analysis/integrands.h"
#include "wellstrat/platform.h"

#include <cstddef>
#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

/// An integrand for each pixel of a square picture; all have the same domains.
struct IntegrandPicture {
    std::string name;
    DomainDims domains;
    unsigned size;                 ///< pixels of a side
    std::vector<Integrand> pixels; ///< row after row

    /// That of pixel (x, y), both in [0, size).
    const Integrand& at(unsigned x, unsigned y) const { return pixels[std::size_t{y} * size + x]; }
};

constexpr unsigned kMaxPictureSize = 256;

/// A name that makeIntegrandPicture takes.
struct IntegrandPictureKind {
    std::string name;
    DomainDims domains;
    std::string formula; ///< the value, where u = sin(X / 40) and v = sin(Y / 40) at pixel (X, Y)
};

/// All of them.
WELLSTRAT_API std::vector<IntegrandPictureKind> integrandPictureKinds();

/// Names that stand for several: "2d", "4d" and "1d-3d".
WELLSTRAT_API std::vector<IntegrandGroup> integrandPictureGroups();

/// The picture called `name` of size x size pixels, `size` in [1, kMaxPictureSize]. Throws
/// std::invalid_argument, which says what is accepted, for any other name or size.
WELLSTRAT_API IntegrandPicture makeIntegrandPicture(const std::string& name, unsigned size);

} // namespace stream1
} // namespace wellstrat
