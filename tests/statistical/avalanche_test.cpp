// SPDX-License-Identifier: Apache-2.0
//
// Avalanche: flipping any input bit flips every output bit with probability 0.5 +- 0.01, for
// inputs that are random and for inputs that count up, as pixels and sampleids do. Guards against
// hashes under which neighbors stay neighbors.
//
// With 2^18 trials the frequency of a fair bit has a standard deviation of 0.001: it is off by more
// than 0.01 with probability 1e-23.

#include "wellstrat/camera.h"
#include "wellstrat/domain.h"
#include "wellstrat/hash.h"
#include "wellstrat/lookup.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>

namespace {

using namespace wellstrat;

constexpr uint32_t kTrials = 1u << 18;
constexpr double kTolerance = 0.01;

/// For each of 32 bit positions how many of the words added have that bit. The counts are held
/// bit-sliced: plane k has bit k of all 32 counts.
class BitCounter {
public:
    void add(uint32_t word) {
        for (unsigned k = 0; word != 0; ++k) {
            const uint32_t carry = plane_[k] & word;
            plane_[k] ^= word;
            word = carry;
        }
    }
    uint32_t count(unsigned bit) const {
        uint32_t count = 0;
        for (unsigned k = 0; k < 32; ++k) count |= ((plane_[k] >> bit) & 1u) << k;
        return count;
    }

private:
    uint32_t plane_[32] = {};
};

struct Words {
    uint32_t a, b;
};

struct RandomWords {
    std::mt19937 engine{1};
    Words operator()(uint32_t /*trial*/) {
        const auto a = static_cast<uint32_t>(engine());
        return {a, static_cast<uint32_t>(engine())};
    }
};

struct CountingWords {
    Words operator()(uint32_t trial) const { return {trial & 0xfffu, trial >> 12}; }
};

template <typename Hash, typename Inputs>
void expectAvalanche(const char* what, Hash hash, unsigned inputBits, Inputs inputs) {
    BitCounter flips[64];
    for (uint32_t trial = 0; trial < kTrials; ++trial) {
        const Words in = inputs(trial);
        const uint32_t out = hash(in.a, in.b);
        for (unsigned bit = 0; bit < inputBits; ++bit) {
            const uint32_t a = in.a ^ (bit < 32 ? 1u << bit : 0);
            const uint32_t b = in.b ^ (bit < 32 ? 0 : 1u << (bit - 32));
            flips[bit].add(out ^ hash(a, b));
        }
    }
    for (unsigned in = 0; in < inputBits; ++in) {
        for (unsigned out = 0; out < 32; ++out) {
            const double rate = static_cast<double>(flips[in].count(out)) / kTrials;
            EXPECT_NEAR(rate, 0.5, kTolerance) << what << " in " << in << " out " << out;
        }
    }
}

template <typename Hash>
void expectAvalanche(Hash hash, unsigned inputBits = 64) {
    expectAvalanche("random inputs,", hash, inputBits, RandomWords{});
    expectAvalanche("counting inputs,", hash, inputBits, CountingWords{});
}

TEST(Avalanche, MixBits) {
    expectAvalanche([](uint32_t a, uint32_t b) { return mixBits(a ^ (b << 12)); }, 32);
}

TEST(Avalanche, PermuteBitsInTheWordAndInTheKey) {
    expectAvalanche([](uint32_t a, uint32_t b) { return permuteBits(a, permutationKey(b)); });
}

TEST(Avalanche, HashPair) {
    expectAvalanche([](uint32_t a, uint32_t b) { return hashPair(a, b); });
}

// Deriving alone mixes little; the hash of the draw mixes the rest.
TEST(Avalanche, SeedOfADomainInThePatternAndInTheScramble) {
    expectAvalanche([](uint32_t a, uint32_t b) {
        return patternSeed(derivePattern(a, static_cast<Scramble>(b)));
    });
}

TEST(Avalanche, DistributionInThePatternAndInTheSampleid) {
    expectAvalanche([](uint32_t a, uint32_t b) {
        return SampleCtx{a, b}.NewDomainDistrib(static_cast<Scramble>(0x2d96c92bu), 0).patternid;
    });
}

TEST(Avalanche, CameraInThePixelAndInTheFrame) {
    expectAvalanche([](uint32_t a, uint32_t b) {
        const auto x = static_cast<int>(a & 0xffffu), y = static_cast<int>(a >> 16);
        return cameraContext(x, y, b, 0).patternid;
    });
}

TEST(Avalanche, CameraInThePixelAndInTheSeed) {
    expectAvalanche([](uint32_t a, uint32_t b) {
        const auto x = static_cast<int>(a & 0xffffu), y = static_cast<int>(a >> 16);
        return cameraContext(x, y, 0, 0, b).patternid;
    });
}

TEST(Avalanche, UnstratifiedSamplesInThePatternAndInTheSampleid) {
    for (Coordinate c : {Coordinate::x, Coordinate::y, Coordinate::z}) {
        expectAvalanche([c](uint32_t a, uint32_t b) { return randomBits(a, b, c); });
    }
}

} // namespace
