// SPDX-License-Identifier: Apache-2.0
//
// What the checks of the certificate share: lines that count, nets, and draws.

#pragma once

#include "RixRNG.h"
#include "wellstrat/analysis/certificate.h"
#include "wellstrat/analysis/nets.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace wellstrat {
inline namespace stream1 {

using CertificateLines = std::vector<CertificateLine>;

inline CertificateLine emptyLine(const std::string& promise, const std::string& subject) {
    return {promise, subject, 0, 0, {}};
}

/// Counts one check of a line. `where` is called for the first violation only.
template <class Where>
void record(CertificateLine& line, bool kept, const Where& where) {
    ++line.intervals;
    if (kept) return;
    if (line.violations++ == 0) line.firstViolation = where();
}

/// Adds what a check of nets found at a place called name().
template <class Name>
void record(CertificateLine& line, const NetReport& report, const Name& name) {
    if (line.violations == 0 && !report.holds()) {
        line.firstViolation = name() + ", " + report.firstViolation;
    }
    line.intervals += report.intervals;
    line.violations += report.violations;
}

/// What is promised of 4096 samples of a pattern, for all m and all aligned blocks in them.
struct NetPromise {
    const char* text;
    std::vector<unsigned> coordinates;
    unsigned t;
    NetBase base;
};
const std::vector<NetPromise>& netPromises();

/// A line for each of them.
CertificateLines netLines(const std::string& subject);

/// Adds what the checks of all of them find to the first lines of `lines`.
template <class Name>
void checkNets(const PointSet& points, const Name& name, CertificateLines& lines) {
    for (std::size_t i = 0; i < netPromises().size(); ++i) {
        const NetPromise& promise = netPromises()[i];
        record(lines[i],
               checkSequence(points.projection(promise.coordinates), promise.t, promise.base),
               name);
    }
}

/// Whether a drawn value is in [0, 1) and a multiple of 2^-24.
bool isUnitMultiple(float value);

/// Such a value as a fraction of 2^32; 0 for others, which are counted apart.
uint32_t fractionOf(float value);

/// Draws in every way that there is. Adds two lines, about `subject`.
class DrawChecker {
public:
    DrawChecker(CertificateLines& lines, const std::string& subject);

    /// All points of `rng`, of which point i is called name(i).
    template <class Name>
    PointSet draw(const RixRNG& rng, const Name& name) {
        resize(rng.numPts);
        rng.DrawSamples1D(xi1_);
        rng.DrawSamples2D(xi2_);
        rng.DrawSamples3D(xi3_);
        // Single draws backwards: samples do not depend on the order in which they are drawn.
        for (unsigned i = rng.numPts; i-- > 0;) {
            const Float3 xi = rng.DrawSample3D(i);
            const Float2 xy(xi.x, xi.y);
            const bool agree = xi1_[i] == xi.z && xi2_[i] == xy && xi3_[i] == xi &&
                               rng.DrawSample1D(i) == xi.z && rng.DrawSample2D(i) == xy;
            record(lines_[draws_], agree, [&] { return name(i); });
            for (unsigned c = 0; c < 3; ++c) {
                const float value = xi[static_cast<int>(c)];
                record(lines_[draws_ + 1], isUnitMultiple(value), [&] { return name(i); });
                bits_[3 * i + c] = fractionOf(value);
            }
        }
        return PointSet::fromIntegers(bits_.data(), rng.numPts, 3);
    }

private:
    void resize(std::size_t count);

    CertificateLines& lines_;
    std::size_t draws_; ///< the place of the first line
    std::vector<float> xi1_;
    std::vector<Float2> xi2_;
    std::vector<Float3> xi3_;
    std::vector<uint32_t> bits_;
};

/// Patterns that a renderer is likely to start from, and 2^32 - 0x9e3779b9, which is the one with
/// patternSeed 0: no digital shift and the simplest shuffle.
constexpr uint32_t kSpecialPatterns[] = {0,           1,           2,           0x7fffffffu,
                                         0x80000000u, 0xfffffffeu, 0xffffffffu, 0x61c88647u};

} // namespace stream1
} // namespace wellstrat
