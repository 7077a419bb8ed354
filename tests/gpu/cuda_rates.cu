// SPDX-License-Identifier: Apache-2.0

#include "cuda_rates.h"

#include "cuda_memory.h"

#include <algorithm>

#if WELLSTRAT_CURAND
#include <curand.h>
#endif

namespace gpu_check {
namespace {

using wellstrat::Float2;

constexpr std::size_t kSamples = std::size_t{1} << 28; // 2 GiB
constexpr unsigned kThreads = 256, kPairs = 4;
constexpr unsigned kSamplesPerBlock = kThreads * kPairs * 2;
constexpr unsigned kSamplesPerPattern = 256;
constexpr int kRuns = 10;

static_assert(kSamples % kSamplesPerBlock == 0, "whole blocks");
static_assert(kSamplesPerPattern == 32 * kPairs * 2, "a warp has one pattern");

struct Fill {
    __device__ Float2 operator()(uint32_t, uint32_t) const { return {0.25f, 0.75f}; }
};
struct Table {
    const DeviceTables* tables;
    __device__ Float2 operator()(uint32_t patternid, uint32_t sampleid) const {
        return wellstrat::sample2D(tables->words, patternid, sampleid);
    }
};
struct Joint {
    const DeviceTables* tables;
    __device__ Float2 operator()(uint32_t patternid, uint32_t sampleid) const {
        return wellstrat::jointSample2D(tables->words, tables->jointOrders, patternid, sampleid, 1,
                                        1);
    }
};
struct Long {
    __device__ Float2 operator()(uint32_t patternid, uint32_t sampleid) const {
        return wellstrat::sequenceSample2D(patternid, sampleid);
    }
};
struct LongSlot {
    const DeviceTables* tables;
    __device__ Float2 operator()(uint32_t patternid, uint32_t sampleid) const {
        return wellstrat::jointSequenceSample2D(tables->slotOrders, patternid, sampleid, 1, 1);
    }
};
struct Blue {
    const DeviceTables* tables;
    __device__ Float2 operator()(uint32_t patternid, uint32_t sampleid) const {
        return wellstrat::blueSample2D(tables->blueTables, patternid, sampleid);
    }
};

/// The first samples of many patterns, one after another. A warp draws those of one pattern, each
/// thread two at a time, which it writes as one word of 16 bytes.
template <typename Draw>
__global__ void write(Draw draw, float4* out) {
    const uint32_t warp = (blockIdx.x * kThreads + threadIdx.x) / 32, lane = threadIdx.x % 32;
    const uint32_t pattern = wellstrat::mixBits(warp);
    for (uint32_t k = 0; k < kPairs; ++k) {
        const uint32_t pair = 32 * k + lane;
        const Float2 a = draw(pattern, 2 * pair), b = draw(pattern, 2 * pair + 1);
        out[std::size_t{warp} * (kSamplesPerPattern / 2) + pair] = make_float4(a.x, a.y, b.x, b.y);
    }
}

/// The time of an event on the device.
class Event {
public:
    Event() { require(cudaEventCreate(&event_), "no event"); }
    ~Event() { cudaEventDestroy(event_); }
    Event(const Event&) = delete;
    Event& operator=(const Event&) = delete;

    void record() { require(cudaEventRecord(event_), "cannot record an event"); }
    double secondsSince(const Event& other) {
        require(cudaEventSynchronize(event_), "a kernel failed");
        float milliseconds = 0.0f;
        require(cudaEventElapsedTime(&milliseconds, other.event_, event_), "cannot take the time");
        return static_cast<double>(milliseconds) * 1e-3;
    }

private:
    cudaEvent_t event_;
};

/// The best of some runs of what writes kSamples pairs of floats, after one that is not measured.
template <typename Write>
Rate measure(const char* what, const Write& writeAll) {
    double best = 0.0;
    Event start, end;
    for (int run = 0; run <= kRuns; ++run) {
        start.record();
        writeAll();
        end.record();
        const double seconds = end.secondsSince(start);
        if (run > 0) best = std::max(best, kSamples * sizeof(Float2) / seconds);
    }
    return {what, best};
}

template <typename Draw>
Rate measureDraws(const char* what, Draw draw, const DeviceArray<float4>& out) {
    return measure(what, [&] {
        write<<<kSamples / kSamplesPerBlock, kThreads>>>(draw, out.data());
        require(cudaGetLastError(), "cannot start a kernel");
    });
}

#if WELLSTRAT_CURAND
void requireCurand(curandStatus_t status) {
    if (status == CURAND_STATUS_SUCCESS) return;
    throw std::runtime_error("cuRAND failed with status " + std::to_string(status));
}

Rate measureCurand(const DeviceArray<float4>& out) {
    curandGenerator_t generator;
    requireCurand(curandCreateGenerator(&generator, CURAND_RNG_QUASI_SCRAMBLED_SOBOL32));
    requireCurand(curandSetQuasiRandomGeneratorDimensions(generator, 2));
    const Rate rate = measure("cuRAND scrambled Sobol' 32", [&] {
        requireCurand(curandSetGeneratorOffset(generator, 0));
        requireCurand(
            curandGenerateUniform(generator, reinterpret_cast<float*>(out.data()), 2 * kSamples));
    });
    requireCurand(curandDestroyGenerator(generator));
    return rate;
}
#endif

} // namespace

std::vector<Rate> writeRates(const DeviceTables* tables) {
    const DeviceArray<float4> out(kSamples / 2);
    std::vector<Rate> rates = {
        measureDraws("fill", Fill{}, out),
        measureDraws("long", Long{}, out),
        measureDraws("long, slot", LongSlot{tables}, out),
        measureDraws("blue", Blue{tables}, out),
        measureDraws("pmj", Table{tables}, out),
        measureDraws("joint, slot", Joint{tables}, out),
    };
#if WELLSTRAT_CURAND
    rates.push_back(measureCurand(out));
#endif
    return rates;
}

} // namespace gpu_check
