// SPDX-License-Identifier: Apache-2.0

#include "domain_error.h"

#include "sampling_domains.h"

#include "wellstrat/hash.h"

#include <RixRNGProgressive.h>

#include <cmath>
#include <numeric>

namespace wellstrat::render {
namespace {

/// The tag of an order whose patterns are not renewed.
constexpr uint32_t kKept = 1;

/// Any number: it makes patterns that no picture has by itself.
constexpr uint32_t kRenewal = 1;

uint32_t patternOf(const SampleCtx& sc, Order order) {
    return order.tag == kKept ? sc.patternid : hashPair(sc.patternid, kRenewal);
}

Colors meanOf(const std::vector<Colors>& pictures) {
    std::vector<double> sums(pictures.front().size());
    for (const Colors& picture : pictures) {
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += double{picture[i]};
    }
    Colors mean(sums.size());
    for (std::size_t i = 0; i < sums.size(); ++i) {
        mean[i] = static_cast<float>(sums[i] / static_cast<double>(pictures.size()));
    }
    return mean;
}

} // namespace

std::vector<PathDomain> pathDomains(unsigned depth) {
    std::vector<PathDomain> domains{
        {"pixel filter", kPixelFilterScramble}, {"lens", kLensScramble}, {"time", kTimeScramble}};
    for (unsigned bounce = 0; bounce <= depth; ++bounce) {
        const std::string number = ' ' + std::to_string(bounce);
        domains.push_back({"light" + number, lightScramble(bounce)});
        domains.push_back({"environment" + number, environmentScramble(bounce)});
        domains.push_back({"bxdf" + number, bxdfScramble(bounce)});
    }
    return domains;
}

float RenewedGenerator::OrderedSample1D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return RixProgressiveSample1D(patternOf(sc, order), sc.sampleid);
}

Float2 RenewedGenerator::OrderedSample2D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return RixProgressiveSample2D(patternOf(sc, order), sc.sampleid);
}

Float3 RenewedGenerator::OrderedSample3D(const SampleCtx& sc, unsigned /*i*/, Order order) const {
    return RixProgressiveSample3D(patternOf(sc, order), sc.sampleid);
}

Order RenewedGenerator::ChildOrder(Order parent, RixRNG::Scramble scramble,
                                   unsigned /*split*/) const {
    if (scramble == kept_) parent.tag = kKept;
    return parent;
}

Colors colorsOf(const Film& film) {
    Colors colors;
    colors.reserve(3 * film.pixels().size());
    for (unsigned y = 0; y < film.height(); ++y) {
        for (unsigned x = 0; x < film.width(); ++x) {
            const Float3 mean = film.mean(x, y);
            colors.insert(colors.end(), {mean.x, mean.y, mean.z});
        }
    }
    return colors;
}

Measured covariance(const std::vector<Colors>& a, const std::vector<Colors>& b) {
    const Colors meanA = meanOf(a), meanB = meanOf(b);
    const auto count = static_cast<double>(a.size());
    std::vector<double> products;
    for (std::size_t k = 0; k < a.size(); ++k) {
        double sum = 0;
        for (std::size_t i = 0; i < meanA.size(); ++i) {
            sum += (double{a[k][i]} - double{meanA[i]}) * (double{b[k][i]} - double{meanB[i]});
        }
        // Differences from the mean of K pictures are too small by 1 - 1 / K in mean square.
        products.push_back(sum / static_cast<double>(meanA.size()) * count / (count - 1));
    }
    const double mean = std::accumulate(products.begin(), products.end(), 0.0) / count;
    double deviations = 0;
    for (const double x : products) deviations += (x - mean) * (x - mean);
    return {mean, std::sqrt(deviations / (count - 1) / count)};
}

} // namespace wellstrat::render
