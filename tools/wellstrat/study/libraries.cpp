// SPDX-License-Identifier: Apache-2.0
//
// The quasi-random sequences of the GNU Scientific Library and of Boost, which share one sequence
// over all domains: each takes further dimensions of it.

#include "sources.h"
#include "wellstrat/hash.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>

#if defined(WELLSTRAT_WITH_BOOST)
#include <boost/random/sobol.hpp>
#endif
#if defined(WELLSTRAT_WITH_GSL)
#include <gsl/gsl_qrng.h>
#endif

namespace wellstrat::cli {
namespace {

/// What a pattern does to the coordinates of a sequence that has only one.
enum class PatternShift { none, digits, modulo1 };

/// Writes the first points, coordinate after coordinate, with a library.
using DrawSequence = void (*)(unsigned dims, std::size_t count, double* points);

/// Points of a library. XOR works on the first 32 binary digits, what is below stays.
class LibrarySource final : public PointSource {
public:
    LibrarySource(DrawSequence sequence, unsigned maxDims, PatternShift shift)
        : sequence_(sequence), maxDims_(maxDims), shift_(shift) {}

    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        const unsigned dims = totalDims(domains);
        sequence_(dims, count, points);
        for (unsigned c = 0; c < dims && shift_ != PatternShift::none; ++c) {
            const uint32_t word = hashPair(pattern, c);
            for (std::size_t i = 0; i < count; ++i) {
                double& value = points[i * dims + c];
                value = shift_ == PatternShift::digits ? shiftDigits(value, word)
                                                       : shiftModulo1(value, word);
            }
        }
    }

    void check(const DomainDims& domains, std::size_t /*count*/,
               uint64_t /*patterns*/) const override {
        if (totalDims(domains) <= maxDims_) return;
        throw std::invalid_argument(
            fmt::format("it has at most {} dimensions, not {}", maxDims_, totalDims(domains)));
    }

private:
    static double shiftDigits(double value, uint32_t word) {
        const double scaled = value * 0x1p32;
        const auto digits = static_cast<uint32_t>(scaled);
        return ((digits ^ word) + (scaled - digits)) * 0x1p-32;
    }
    static double shiftModulo1(double value, uint32_t word) {
        const double sum = value + word * 0x1p-32;
        return sum < 1 ? sum : sum - 1;
    }

    DrawSequence sequence_;
    unsigned maxDims_;
    PatternShift shift_;
};

[[maybe_unused]] std::function<PointSourcePtr()> maker(DrawSequence sequence, unsigned maxDims,
                                                       PatternShift shift) {
    return [=] { return std::make_unique<LibrarySource>(sequence, maxDims, shift); };
}

#if defined(WELLSTRAT_WITH_GSL)

void drawGsl(const gsl_qrng_type* type, unsigned dims, std::size_t count, double* points) {
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(gsl_qrng_alloc(type, dims),
                                                                       gsl_qrng_free);
    if (!sequence) throw std::bad_alloc();
    for (std::size_t i = 0; i < count; ++i) gsl_qrng_get(sequence.get(), points + i * dims);
}

/// Begins with the point 0, which GSL leaves out.
void drawGslSobol(unsigned dims, std::size_t count, double* points) {
    if (count == 0) return;
    std::fill(points, points + dims, 0.0);
    drawGsl(gsl_qrng_sobol, dims, count - 1, points + dims);
}

void drawGslHalton(unsigned dims, std::size_t count, double* points) {
    drawGsl(gsl_qrng_halton, dims, count, points);
}

#endif

#if defined(WELLSTRAT_WITH_BOOST)

/// Begins with the point 0, which Boost leaves out.
void drawBoostSobol(unsigned dims, std::size_t count, double* points) {
    if (count == 0) return;
    boost::random::sobol sequence(dims);
    std::fill(points, points + dims, 0.0);
    for (std::size_t i = dims; i < count * dims; ++i) {
        points[i] = static_cast<double>(sequence() >> 11) * 0x1p-53;
    }
}

#endif

} // namespace

std::vector<StudySourceKind> librarySourceKinds() {
    std::vector<StudySourceKind> kinds;
#if defined(WELLSTRAT_WITH_GSL)
    constexpr unsigned kGslSobolDims = 40, kGslHaltonDims = 1229;
    kinds.push_back(
        {"gsl-sobol", "Sobol' of GSL", maker(drawGslSobol, kGslSobolDims, PatternShift::none)});
    kinds.push_back({"gsl-sobol-shift", "the same with a random digital shift",
                     maker(drawGslSobol, kGslSobolDims, PatternShift::digits)});
    kinds.push_back({"gsl-halton", "Halton of GSL, shifted at random",
                     maker(drawGslHalton, kGslHaltonDims, PatternShift::modulo1)});
#endif
#if defined(WELLSTRAT_WITH_BOOST)
    constexpr unsigned kBoostSobolDims = 3667;
    kinds.push_back({"boost-sobol", "Sobol' of Boost",
                     maker(drawBoostSobol, kBoostSobolDims, PatternShift::none)});
    kinds.push_back({"boost-sobol-shift", "the same with a random digital shift",
                     maker(drawBoostSobol, kBoostSobolDims, PatternShift::digits)});
#endif
    return kinds;
}

} // namespace wellstrat::cli
