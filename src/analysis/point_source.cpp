// SPDX-License-Identifier: Apache-2.0

#include "wellstrat/analysis/point_source.h"

#include "RixRNG.h"
#include "wellstrat/joint.h"
#include "wellstrat/owen.h"
#include "wellstrat/sequence.h"
#include "wellstrat/sobol.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace wellstrat {
inline namespace stream1 {
namespace {

/// The seed of a domain of a pattern, for generators that have no domains of their own.
uint32_t domainSeed(uint32_t pattern, uint32_t domain) {
    return hashPair(hashPair(0x73747564u, pattern), domain); // "stud"
}

double toUnitDouble(uint32_t fraction) { return fraction * 0x1p-32; }

/// The middle of what a fraction of 32 bits stands for.
double toMiddle(uint32_t fraction) { return (fraction + 0.5) * 0x1p-32; }

/// Independent words, from a seed and a counter.
class HashStream {
public:
    explicit HashStream(uint32_t seed) : seed_(seed) {}
    uint32_t word() { return hashPair(seed_, counter_++); }
    double uniform() { return toUnitDouble(word()); }
    /// Uniform in [0, n), but for a bias of n / 2^32.
    std::size_t below(std::size_t n) {
        return static_cast<std::size_t>((uint64_t{word()} * n) >> 32);
    }

private:
    uint32_t seed_, counter_ = 0;
};

/// Draws the domains one after the other: draw(domain, its dimensions, its first coordinate, the
/// distance between points).
template <typename Draw>
void forEachDomain(const DomainDims& domains, double* points, Draw draw) {
    const unsigned stride = totalDims(domains);
    for (uint32_t domain = 0; domain < domains.size(); ++domain) {
        draw(domain, domains[domain], points, stride);
        points += domains[domain];
    }
}

using Contexts = std::vector<SampleCtx>;

void drawAll(const RixRNG& rng, std::vector<float>& xis) { rng.DrawSamples1D(xis); }
void drawAll(const RixRNG& rng, std::vector<Float2>& xis) { rng.DrawSamples2D(xis); }
void drawAll(const RixRNG& rng, std::vector<Float3>& xis) { rng.DrawSamples3D(xis); }

double coordinate(float xi, unsigned /*c*/) { return double(xi); }
template <typename Sample>
double coordinate(const Sample& xi, unsigned c) {
    return double(xi[static_cast<int>(c)]);
}

template <typename Sample>
void drawDomain(const RixRNG& rng, unsigned dims, double* out, unsigned stride) {
    std::vector<Sample> xis(rng.numPts);
    drawAll(rng, xis);
    for (std::size_t i = 0; i < xis.size(); ++i) {
        for (unsigned c = 0; c < dims; ++c) out[i * stride + c] = coordinate(xis[i], c);
    }
}

class GeneratorSource final : public PointSource {
public:
    /// Domain d is derived by scrambles[d], or beyond them by d, from a camera with the generator.
    explicit GeneratorSource(const Generator* generator, std::vector<Scramble> scrambles = {})
        : generator_(generator), scrambles_(std::move(scrambles)) {}

    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        if (count == 0) return;
        const auto n = static_cast<unsigned>(count);
        Contexts contexts(n), children(n);
        for (unsigned i = 0; i < n; ++i) contexts[i] = {pattern, i};
        const RixRNG camera(contexts, n, generator_);
        forEachDomain(domains, points,
                      [&](uint32_t domain, unsigned dims, double* out, unsigned stride) {
                          const auto drawAny = dims == 1   ? drawDomain<float>
                                               : dims == 2 ? drawDomain<Float2>
                                                           : drawDomain<Float3>;
                          drawAny({camera, scrambleOf(domain), children}, dims, out, stride);
                      });
    }

private:
    Scramble scrambleOf(uint32_t domain) const {
        return domain < scrambles_.size() ? scrambles_[domain] : static_cast<Scramble>(domain);
    }

    const Generator* generator_;
    std::vector<Scramble> scrambles_;
};

class SequenceSource final : public PointSource {
public:
    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        forEachDomain(domains, points,
                      [&](uint32_t domain, unsigned dims, double* out, unsigned stride) {
                          drawDomain(derivePattern(pattern, static_cast<Scramble>(domain)), dims,
                                     count, out, stride);
                      });
    }

private:
    static void drawDomain(uint32_t pattern, unsigned dims, std::size_t count, double* out,
                           unsigned stride) {
        constexpr Coordinate kAxes[] = {Coordinate::x, Coordinate::y, Coordinate::z};
        const Coordinate* const axes = dims == 1 ? kAxes + 2 : kAxes;
        for (std::size_t i = 0; i < count; ++i) {
            for (unsigned c = 0; c < dims; ++c) {
                out[i * stride + c] =
                    toMiddle(sequenceBits(pattern, static_cast<uint32_t>(i), axes[c]));
            }
        }
    }
};

class SobolSource final : public PointSource {
public:
    explicit SobolSource(SobolRandomization randomization) : randomization_(randomization) {}

    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        const uint32_t origin = randomization_ == SobolRandomization::none ? 0 : pattern;
        forEachDomain(
            domains, points, [&](uint32_t domain, unsigned dims, double* out, unsigned stride) {
                const uint32_t seed = domainSeed(origin, domain);
                for (std::size_t i = 0; i < count; ++i) {
                    const auto index = static_cast<uint32_t>(i);
                    const uint32_t place =
                        domain == 0 ? index : owenScramble(index, hashPair(seed, kSobolDimensions));
                    for (unsigned c = 0; c < dims; ++c) {
                        const uint32_t value = sobolSample(matrices_[c], place);
                        out[i * stride + c] = randomized(value, hashPair(seed, c));
                    }
                }
            });
    }

private:
    double randomized(uint32_t value, uint32_t seed) const {
        switch (randomization_) {
        case SobolRandomization::digitalShift: return toMiddle(value ^ seed);
        case SobolRandomization::owen: return toMiddle(owenScramble(value, seed));
        default: return toUnitDouble(value);
        }
    }

    SobolRandomization randomization_;
    std::array<SobolMatrix, kSobolDimensions> matrices_{sobolMatrix(0), sobolMatrix(1),
                                                        sobolMatrix(2)};
};

constexpr std::array<unsigned, 3 * kMaxIntegrandDomains> kPrimes{2,  3,  5,  7,  11, 13, 17, 19,
                                                                 23, 29, 31, 37, 41, 43, 47};

/// The digits of `index` in `base`, mirrored at the point.
double radicalInverse(uint32_t index, unsigned base) {
    double scale = 1, value = 0;
    for (; index != 0; index /= base) {
        scale /= base;
        value += index % base * scale;
    }
    return value;
}

class HaltonSource final : public PointSource {
public:
    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        const unsigned dims = totalDims(domains);
        for (unsigned c = 0; c < dims; ++c) {
            const double shift = toUnitDouble(domainSeed(pattern, c));
            for (std::size_t i = 0; i < count; ++i) {
                const double value = radicalInverse(static_cast<uint32_t>(i), kPrimes[c]) + shift;
                points[i * dims + c] = value < 1 ? value : value - 1;
            }
        }
    }
};

/// Draws `count` points, one in each cell, cell after cell.
void jitter(HashStream& random, unsigned dims, std::size_t count, double* out, unsigned stride) {
    const auto slabs = static_cast<std::size_t>(
        std::max(1.0, std::round(std::pow(static_cast<double>(count), 1.0 / dims))));
    for (std::size_t slab = 0; slab < slabs; ++slab) {
        const std::size_t begin = count * slab / slabs, end = count * (slab + 1) / slabs;
        const auto first = static_cast<double>(begin), width = static_cast<double>(end - begin);
        for (std::size_t i = begin; i < end; ++i) {
            out[i * stride] = (first + random.uniform() * width) / static_cast<double>(count);
        }
        if (dims > 1 && end > begin) {
            jitter(random, dims - 1, end - begin, out + begin * stride + 1, stride);
        }
    }
}

class JitteredSource final : public PointSource {
public:
    void draw(uint32_t pattern, const DomainDims& domains, std::size_t count,
              double* points) const override {
        if (count == 0) return;
        forEachDomain(
            domains, points, [&](uint32_t domain, unsigned dims, double* out, unsigned stride) {
                HashStream random(domainSeed(pattern, domain));
                jitter(random, dims, count, out, stride);
                // The order of a single domain's points makes no difference to an integral.
                for (std::size_t i = count - 1; domain > 0 && i > 0; --i) {
                    const std::size_t j = random.below(i + 1);
                    std::swap_ranges(out + i * stride, out + i * stride + dims, out + j * stride);
                }
            });
    }
    bool isProgressive() const override { return false; }
};

} // namespace

PointSource::~PointSource() = default;

void PointSource::check(const DomainDims& /*domains*/, std::size_t /*count*/,
                        uint64_t /*patterns*/) const {}

PointSourcePtr generatorSource(const Generator* generator) {
    return std::make_unique<GeneratorSource>(generator);
}

PointSourcePtr jointSource(const std::vector<unsigned>& slots, const Generator* generator) {
    static const JointProgressive joint;
    std::vector<Scramble> scrambles;
    for (const unsigned slot : slots) {
        const Scramble scramble = jointScramble(slot);
        if (slot >= kJointSlots) {
            throw std::invalid_argument("slots are 0 to " + std::to_string(kJointSlots - 1) +
                                        ", not " + std::to_string(slot));
        }
        if (std::count(scrambles.begin(), scrambles.end(), scramble) > 0) {
            throw std::invalid_argument("slot " + std::to_string(slot) +
                                        " comes twice; each is for one domain");
        }
        scrambles.push_back(scramble);
    }
    for (unsigned slot = 0; slots.empty() && slot < kJointSlots; ++slot) {
        scrambles.push_back(jointScramble(slot));
    }
    return std::make_unique<GeneratorSource>(generator != nullptr ? generator : &joint,
                                             std::move(scrambles));
}

PointSourcePtr sequenceSource() { return std::make_unique<SequenceSource>(); }

PointSourcePtr sobolSource(SobolRandomization randomization) {
    return std::make_unique<SobolSource>(randomization);
}

PointSourcePtr haltonSource() { return std::make_unique<HaltonSource>(); }

PointSourcePtr jitteredSource() { return std::make_unique<JitteredSource>(); }

} // namespace stream1
} // namespace wellstrat
