// SPDX-License-Identifier: Apache-2.0
//
// The certificates of computed samples: those of LongProgressive and BlueProgressive.

#include "certificate_lines.h"

#include "wellstrat/blue.h"
#include "wellstrat/blue_lookup.h"
#include "wellstrat/long.h"

#include <iterator>

namespace wellstrat {
inline namespace stream1 {
namespace {

constexpr unsigned kSamples = 4096;            ///< of one check
constexpr unsigned kDomains = kJointSlots + 1; ///< the slots, and none

std::string domainName(unsigned slot) {
    return slot < kJointSlots ? ", slot " + std::to_string(slot) : ", padded";
}

/// Draws samples of a domain, given the contexts of the camera.
template <class Progressive>
class DomainDrawer {
public:
    DomainDrawer(CertificateLines& lines, const std::string& subject) : draws_(lines, subject) {}

    RixRNG derive(std::vector<SampleCtx>& camera, unsigned slot) {
        children_.resize(camera.size());
        return {RixRNG(camera, static_cast<unsigned>(camera.size()), &generator_),
                jointScramble(slot), children_};
    }

    PointSet draw(std::vector<SampleCtx>& camera, unsigned slot, const std::string& name) {
        return draws_.draw(derive(camera, slot),
                           [&](unsigned i) { return name + ", point " + std::to_string(i); });
    }

private:
    const Progressive generator_;
    std::vector<SampleCtx> children_;
    DrawChecker draws_;
};

class LongChecker {
public:
    explicit LongChecker(const std::string& patterns)
        : lines_(netLines(patterns + ", 2 blocks of 4096, m = 0..12, every aligned block")),
          drawer_(lines_, patterns) {}

    /// Samples first to first + kSamples - 1 of a domain of a pattern.
    void check(uint32_t patternid, unsigned slot, uint32_t first) {
        std::vector<SampleCtx> camera(kSamples);
        for (uint32_t i = 0; i < kSamples; ++i) camera[i] = {patternid, first + i};
        const std::string name = "pattern " + std::to_string(patternid) + domainName(slot) +
                                 ", samples from " + std::to_string(first) + " on";
        checkNets(
            drawer_.draw(camera, slot, name), [&]() -> const std::string& { return name; }, lines_);
    }

    const CertificateLines& lines() const { return lines_; }

private:
    CertificateLines lines_;
    DomainDrawer<LongProgressive> drawer_;
};

/// A domain of a tile of 64 x 64 pixels.
struct Tile {
    int column, row;
    unsigned seed, slot;
};

class BlueChecker {
public:
    explicit BlueChecker(const std::string& tiles)
        : lines_(
              netLines("4096 samples of a pixel of " + tiles + ", m = 0..12, every aligned block")),
          drawer_(lines_, tiles), nets_(lines_.size()) {
        const std::string subject = "a block of " + tiles + ", k + 2a <= 12, every aligned run";
        lines_.push_back(emptyLine(
            "(x, y) of 2^k samples of 2^a x 2^a pixels: (0,k+2a,2)-net in base 2", subject));
        lines_.push_back(emptyLine("z of the same: one point in each of 2^(k+2a) strata", subject));
    }

    void choose(const Tile& tile) {
        tile_ = tile;
        std::vector<SampleCtx> camera(kRanks);
        for (unsigned pixel = 0; pixel < kRanks; ++pixel) camera[pixel] = context(pixel, 0);
        const RixRNG domain = drawer_.derive(camera, tile.slot);
        for (unsigned pixel = 0; pixel < kRanks; ++pixel) {
            pixelAt_[ownPlace(domain.sampleCtxArray[pixel].patternid)] = pixel;
        }
    }

    /// Of the tile, the block of 2^a x 2^a pixels that `place` is in, and of the samples the run
    /// that `sampleid` is in and that makes it kSamples points.
    void check(unsigned a, uint32_t place, uint32_t sampleid) {
        const unsigned side = 1u << a, mask = kRankTileSize - side;
        const unsigned x = place & mask, y = place / kRankTileSize & mask;
        const uint32_t count = kSamples / side / side, first = sampleid & (0u - count);
        std::vector<SampleCtx> camera;
        for (uint32_t s = first; s != first + count; ++s) {
            for (unsigned row = y; row < y + side; ++row) {
                for (unsigned column = x; column < x + side; ++column) {
                    camera.push_back(context(pixelAt_[row * kRankTileSize + column], s));
                }
            }
        }
        const std::string name =
            "tile (" + std::to_string(tile_.column) + ", " + std::to_string(tile_.row) +
            ") of seed " + std::to_string(tile_.seed) + domainName(tile_.slot) + ", block (" +
            std::to_string(x / side) + ", " + std::to_string(y / side) + ") of side " +
            std::to_string(side) + ", samples from " + std::to_string(first) + " on";
        const PointSet points = drawer_.draw(camera, tile_.slot, name);
        if (a == 0) {
            checkNets(
                points, [&]() -> const std::string& { return name; }, lines_);
        } else {
            checkRuns(points, std::size_t{side} * side, name);
        }
    }

    const CertificateLines& lines() const { return lines_; }

private:
    SampleCtx context(unsigned pixel, uint32_t sampleid) const {
        constexpr int kSide = kRankTileSize;
        return blueContext(kSide * tile_.column + static_cast<int>(pixel) % kSide,
                           kSide * tile_.row + static_cast<int>(pixel) / kSide, tile_.seed,
                           sampleid);
    }

    /// Where the domain has a pixel: padded domains move the tile, each in its own way.
    unsigned ownPlace(uint32_t patternid) const {
        const uint32_t place = patternid & detail::kPlaceBits;
        if (tile_.slot < kJointSlots) return place;
        return detail::movedPlace(place, detail::placeKey(detail::stateSeed(patternid)));
    }

    /// Points that come sample by sample, with `pixels` of each.
    void checkRuns(const PointSet& points, std::size_t pixels, const std::string& name) {
        const PointSet xy = points.projection({0, 1});
        for (std::size_t size = pixels; size <= kSamples; size *= 2) {
            for (std::size_t first = 0; first < kSamples; first += size) {
                const auto run = [&] { return name + ", points from " + std::to_string(first); };
                record(lines_[nets_], checkNet(xy.block(first, size), 0), run);
                record(lines_[nets_ + 1], checkStrata(points.block(first, size), 2), run);
            }
        }
    }

    CertificateLines lines_;
    DomainDrawer<BlueProgressive> drawer_;
    std::size_t nets_; ///< the place of the first line about blocks of pixels
    Tile tile_{};
    unsigned pixelAt_[kRanks]{};
};

void report(const CertificateProgress& progress, uint64_t done, uint64_t total) {
    if (progress) progress(static_cast<double>(done) / static_cast<double>(total));
}

} // namespace

CertificateLines certifyLong(unsigned count, uint32_t seed, const CertificateProgress& progress) {
    const uint64_t total = uint64_t{kDomains} + count;
    LongChecker checker(std::to_string(total) + " patterns of long");
    for (uint64_t i = 0; i < total; ++i) {
        const uint32_t random = hashPair(seed, static_cast<uint32_t>(i));
        const uint32_t patternid = i < std::size(kSpecialPatterns) ? kSpecialPatterns[i] : random;
        const auto slot = static_cast<unsigned>(i % kDomains);
        checker.check(patternid, slot, i % 2 == 0 ? 0 : 0u - kSamples);
        checker.check(patternid, slot, mixBits(random) & (0u - kSamples));
        report(progress, i + 1, total);
    }
    return checker.lines();
}

CertificateLines certifyBlue(unsigned count, uint32_t seed, const CertificateProgress& progress) {
    const uint64_t total = uint64_t{kDomains} + count;
    BlueChecker checker(std::to_string(total) + " tiles of blue");
    for (uint64_t i = 0; i < total; ++i) {
        const uint32_t random = hashPair(seed, static_cast<uint32_t>(i)), more = mixBits(random);
        checker.choose({static_cast<int>(random & 1023u) - 512,
                        static_cast<int>(random >> 10 & 1023u) - 512, random >> 20,
                        static_cast<unsigned>(i % kDomains)});
        checker.check(0, more, i % 2 == 0 ? 0 : mixBits(more));
        checker.check(1 + static_cast<unsigned>(i % 6), more >> 12, mixBits(more));
        report(progress, i + 1, total);
    }
    return checker.lines();
}

} // namespace stream1
} // namespace wellstrat
