// SPDX-License-Identifier: Apache-2.0

#include "tile_search.h"

#include "error_field.h"
#include "wellstrat/hash.h"
#include "wellstrat/owen.h"
#include "wellstrat/sobol.h"

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

namespace wellstrat::rivals {
namespace {

constexpr double kPi = 3.14159265358979323846;

using TilePoint = std::array<uint32_t, 2>;

class Random {
public:
    explicit Random(uint32_t seed) : engine_(seed) {}
    double uniform() { return static_cast<double>(engine_()) * 0x1p-32; }
    uint32_t word() { return static_cast<uint32_t>(engine_()); }
    unsigned pixel() { return word() % kTilePixels; }

private:
    std::mt19937 engine_;
};

/// 1 on one side of a line through the square, 0 on the other.
class HalfPlane {
public:
    explicit HalfPlane(Random& random) {
        const double angle = 2 * kPi * random.uniform();
        x_ = std::cos(angle);
        y_ = std::sin(angle);
        bound_ = x_ * random.uniform();
        bound_ += y_ * random.uniform();
    }
    bool contains(double x, double y) const { return x_ * x + y_ * y < bound_; }

private:
    double x_, y_, bound_;
};

/// The temperature falls from a tenth of the mean rise of random steps to a thousandth of that, as
/// `proposals` go by.
class Annealing {
public:
    Annealing(Random& random, std::size_t proposals) : random_(random), proposals_(proposals) {}

    /// propose() returns the rise of a random step, which accept() makes.
    template <typename Propose, typename Accept>
    void run(Propose propose, Accept accept) {
        constexpr unsigned kTrials = 1000;
        double start = 0;
        for (unsigned i = 0; i < kTrials; ++i) start += std::fabs(propose()) / kTrials;
        for (std::size_t i = 0; i < proposals_; ++i) {
            const double done = static_cast<double>(i) / static_cast<double>(proposals_);
            const double temperature = 0.1 * start * std::pow(1e-3, done);
            const double rise = propose();
            if (rise <= 0 || random_.uniform() < std::exp(-rise / temperature)) accept();
        }
    }

private:
    Random& random_;
    std::size_t proposals_;
};

class Search {
public:
    explicit Search(uint32_t seed) : random_(seed) {
        for (uint32_t i = 0; i < kTileSamples; ++i) {
            points_[i] = {tileCoordinate(seed, i, 0), tileCoordinate(seed, i, 1)};
        }
        for (unsigned h = 0; h < kTileIntegrands; ++h) integrands_.emplace_back(random_);
        for (TilePixel& pixel : tile_) {
            pixel = {{random_.word(), random_.word()}, random_.word() % kTileSamples};
        }
        normalize();
    }

    void anneal() {
        std::vector<TileErrors> errors;
        for (const TilePixel& pixel : tile_) errors.push_back(errorsOf(pixel));
        ErrorField field(std::move(errors));
        unsigned p = 0, q = 0;
        bool swaps = false;
        TilePixel changed{};
        TileErrors change{};
        Annealing(random_, kProposals * std::size_t{kTilePixels})
            .run(
                [&] {
                    swaps = random_.word() >> 30 != 0;
                    p = random_.pixel();
                    if (swaps) {
                        q = random_.pixel();
                        return field.riseOfSwap(p, q);
                    }
                    changed = tile_[p];
                    changed.rank = random_.word() % kTileSamples;
                    change = difference(errorsOf(changed), field[p]);
                    return field.rise(p, change);
                },
                [&] {
                    if (swaps) {
                        field.swap(p, q);
                        std::swap(tile_[p], tile_[q]);
                    } else {
                        field.add(p, change);
                        tile_[p] = changed;
                    }
                });
    }

    std::vector<TilePixel> tile() const { return tile_; }

private:
    static constexpr std::size_t kProposals = 512; ///< for each pixel

    TileErrors estimatesOf(const TilePixel& pixel) const {
        TileErrors estimates{};
        std::array<float, kTileIntegrands> sums{};
        unsigned done = 0;
        for (unsigned level = 0; level < kTileLevels; ++level) {
            const unsigned count = 1u << level;
            for (; done < count; ++done) {
                const TilePoint& point = points_[done ^ pixel.rank];
                const double x = (point[0] ^ pixel.scrambling[0]) * 0x1p-32;
                const double y = (point[1] ^ pixel.scrambling[1]) * 0x1p-32;
                for (unsigned h = 0; h < kTileIntegrands; ++h) {
                    sums[h] += integrands_[h].contains(x, y) ? 1.0F : 0.0F;
                }
            }
            for (unsigned h = 0; h < kTileIntegrands; ++h) {
                estimates[level * kTileIntegrands + h] = sums[h] / static_cast<float>(count);
            }
        }
        return estimates;
    }

    TileErrors errorsOf(const TilePixel& pixel) const {
        TileErrors errors = difference(estimatesOf(pixel), integrals_);
        for (unsigned e = 0; e < kTileErrors; ++e) errors[e] *= scales_[e / kTileIntegrands];
        return errors;
    }

    /// Takes the mean over all pixels as the integrals, which is as good as exact, and scales the
    /// levels: each weighs 0.8 of the one before, with half as many samples.
    void normalize() {
        scales_.fill(1);
        for (const TilePixel& pixel : tile_) {
            addTimes(integrals_, 1.0F / kTilePixels, estimatesOf(pixel));
        }
        for (unsigned h = 0; h < kTileIntegrands; ++h) {
            for (unsigned level = 0; level + 1 < kTileLevels; ++level) {
                integrals_[level * kTileIntegrands + h] =
                    integrals_[(kTileLevels - 1) * kTileIntegrands + h];
            }
        }
        std::array<double, kTileLevels> squares{};
        for (const TilePixel& pixel : tile_) {
            const TileErrors errors = errorsOf(pixel);
            for (unsigned e = 0; e < kTileErrors; ++e) {
                squares[e / kTileIntegrands] += double(errors[e]) * double(errors[e]);
            }
        }
        for (unsigned level = 0; level < kTileLevels; ++level) {
            const double rms = std::sqrt(squares[level] / kTilePixels);
            scales_[level] = static_cast<float>(std::pow(0.8, level) / rms);
        }
    }

    std::array<TilePoint, kTileSamples> points_;
    Random random_;
    std::vector<HalfPlane> integrands_;
    TileErrors integrals_{};
    std::array<float, kTileLevels> scales_{};
    std::vector<TilePixel> tile_ = std::vector<TilePixel>(kTilePixels);
};

} // namespace

uint32_t tileCoordinate(uint32_t seed, uint32_t index, unsigned c) {
    static const std::array<SobolMatrix, kSobolDimensions> matrices{sobolMatrix(0), sobolMatrix(1),
                                                                    sobolMatrix(2)};
    const uint32_t place = owenScramble(index, hashPair(seed, kSobolDimensions));
    return owenScramble(sobolSample(matrices[c], place), hashPair(seed, c));
}

std::vector<TilePixel> optimizeTile(uint32_t seed) {
    Search search(seed);
    search.anneal();
    return search.tile();
}

} // namespace wellstrat::rivals
