// SPDX-License-Identifier: Apache-2.0
//
// What else one could call for a 2D sample: each fills an array of 4096.

#include "scenarios.h"

#include <boost/random/sobol.hpp>
#include <boost/random/uniform_01.hpp>
#include <gsl/gsl_qrng.h>

#include <cstdlib>
#include <random>

namespace wellstrat {
namespace {

constexpr std::size_t kSamples = 4096;

template <typename Next>
void fill(benchmark::State& state, Next next) {
    std::vector<RtFloat2> xis(kSamples);
    for (auto _ : state) {
        for (RtFloat2& xi : xis) xi = next();
        benchmark::ClobberMemory();
    }
    reportItems(state, kSamples);
}

/// O'Neill 2014, "PCG: A Family of Simple Fast Space-Efficient Statistically Good Algorithms for
/// Random Number Generation", section 6.3: PCG-XSH-RR with 64 bits of state.
class Pcg32 {
public:
    uint32_t operator()() {
        const uint64_t old = state_;
        state_ = old * 6364136223846793005ull + 1442695040888963407ull;
        const auto word = static_cast<uint32_t>(((old >> 18) ^ old) >> 27);
        const auto rotation = static_cast<uint32_t>(old >> 59);
        return (word >> rotation) | (word << (-rotation & 31u));
    }

private:
    uint64_t state_ = 0x853c49e6748fea9bull;
};

void stores(benchmark::State& state) {
    fill(state, [] { return RtFloat2(0.5f, 0.5f); });
}
BENCHMARK(stores)->Name("rival: store a constant");

void drand48Rival(benchmark::State& state) {
    fill(state, [] {
        const auto x = static_cast<float>(drand48());
        return RtFloat2(x, static_cast<float>(drand48()));
    });
}
BENCHMARK(drand48Rival)->Name("rival: drand48");

void mersenneTwister(benchmark::State& state) {
    std::mt19937 engine(1);
    std::uniform_real_distribution<float> uniform;
    fill(state, [&] {
        const float x = uniform(engine);
        return RtFloat2(x, uniform(engine));
    });
}
BENCHMARK(mersenneTwister)->Name("rival: std::mt19937");

void pcg32(benchmark::State& state) {
    Pcg32 engine;
    fill(state, [&] {
        const float x = toUnitFloat(engine());
        return RtFloat2(x, toUnitFloat(engine()));
    });
}
BENCHMARK(pcg32)->Name("rival: PCG32");

void gslSobol(benchmark::State& state) {
    gsl_qrng* sequence = gsl_qrng_alloc(gsl_qrng_sobol, 2);
    fill(state, [&] {
        double point[2];
        gsl_qrng_get(sequence, point);
        return RtFloat2(static_cast<float>(point[0]), static_cast<float>(point[1]));
    });
    gsl_qrng_free(sequence);
}
BENCHMARK(gslSobol)->Name("rival: GSL gsl_qrng_sobol");

void boostSobol(benchmark::State& state) {
    boost::random::sobol engine(2);
    boost::random::uniform_01<float> uniform;
    // It ends after 2^64 points, far beyond any run.
    fill(state, [&] {
        const float x = uniform(engine);
        return RtFloat2(x, uniform(engine));
    });
}
BENCHMARK(boostSobol)->Name("rival: boost::random::sobol");

} // namespace
} // namespace wellstrat
