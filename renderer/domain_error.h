// SPDX-License-Identifier: Apache-2.0
//
// How much of the error of a picture comes from which sample domain: its main effects.
//
// A path is a function f of the samples of its domains. Its analysis of variance (Sobol' 1993,
// "Sensitivity estimates for nonlinear mathematical models") is f = f_0 + sum of f_d(x_d) + terms
// of several domains. A pixel is a mean over paths, so the mean of f_d over the samples of domain d
// is a part of its error. Where domains are scrambled independently of each other, these parts are
// independent of all others, however the samples of different domains are paired: their mean
// squares add up, and the sum is a floor for the mean squared error of any generator that has the
// same points in each domain.
//
// Two pictures that share the samples of domain d and nothing else have the mean square of f_d as
// their covariance.

#pragma once

#include "film.h"

#include <RixRNG.h>

#include <optional>
#include <string>
#include <vector>

namespace wellstrat::render {

struct PathDomain {
    std::string name; ///< such as "light 0", of bounce 0
    RixRNG::Scramble scramble;
};

/// The stratified domains of sampling_domains.h, of paths of `depth` bounces of indirect light.
std::vector<PathDomain> pathDomains(unsigned depth);

/// The samples of the tables, but of other patterns: all domains are independent of those that a
/// picture has without this generator, except for one if there is a scramble, and what is derived
/// from it. Roulette, which draws from no generator, stays as it is.
class RenewedGenerator final : public OrderedGenerator {
public:
    explicit RenewedGenerator(std::optional<RixRNG::Scramble> kept) : kept_(kept) {}

    float OrderedSample1D(const SampleCtx& sc, unsigned i, Order order) const override;
    Float2 OrderedSample2D(const SampleCtx& sc, unsigned i, Order order) const override;
    Float3 OrderedSample3D(const SampleCtx& sc, unsigned i, Order order) const override;
    /// The tag of what is kept is 1.
    Order ChildOrder(Order parent, RixRNG::Scramble scramble, unsigned split) const override;

private:
    std::optional<RixRNG::Scramble> kept_;
};

/// The mean colors of all pixels: three numbers each, row by row.
using Colors = std::vector<float>;

Colors colorsOf(const Film& film);

/// An estimate and its standard error.
struct Measured {
    double value, standardError;
};

/// The covariance of a[k] and b[k], pictures that share some of their samples while those of
/// different k are independent: its mean over all pixels and colors. Unbiased. `a` and `b` have
/// equally many pictures, at least 2, of one size.
Measured covariance(const std::vector<Colors>& a, const std::vector<Colors>& b);

} // namespace wellstrat::render
