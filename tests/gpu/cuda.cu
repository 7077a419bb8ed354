// SPDX-License-Identifier: Apache-2.0

#include "cuda_memory.h"
#include "cuda_rates.h"
#include "device.h"

namespace gpu_check {
namespace {

constexpr unsigned kThreads = 256;

__global__ void answerAll(const DeviceTables* tables, const Question* questions, Answer* answers,
                          uint32_t count) {
    const uint32_t i = blockIdx.x * kThreads + threadIdx.x;
    if (i < count) answers[i] = answer(*tables, questions[i]);
}

/// Adds up the digests of a kind; each thread takes every so many-th question.
__global__ void addDigests(const DeviceTables* tables, Kind kind, uint32_t count,
                           unsigned long long* total) {
    unsigned long long sum = 0;
    const uint64_t step = uint64_t{gridDim.x} * kThreads;
    for (uint64_t i = blockIdx.x * kThreads + threadIdx.x; i < count; i += step) {
        sum += digest(*tables, kind, static_cast<uint32_t>(i));
    }
    atomicAdd(total, sum);
}

cudaDeviceProp firstGpu() {
    int count = 0;
    if (cudaGetDeviceCount(&count) != cudaSuccess || count == 0) {
        throw NoDevice("there is no GPU that CUDA can use");
    }
    cudaDeviceProp properties;
    require(cudaGetDeviceProperties(&properties, 0), "cannot ask the GPU");
    require(cudaSetDevice(0), "cannot use the GPU");
    return properties;
}

class Gpu final : public Device {
public:
    Gpu() : properties_(firstGpu()), tables_(1) {
        const auto block = std::make_unique<DeviceTables>();
        wellstrat::copyDeviceTables(block.get(), wellstrat::DeviceDraws::all);
        tables_.copyFrom(block.get());
    }

    std::string name() const override {
        return std::string(properties_.name) + ", sm_" + std::to_string(properties_.major) +
               std::to_string(properties_.minor);
    }

    std::vector<Answer> answers(const std::vector<Question>& questions) const override {
        DeviceArray<Question> input(questions.size());
        DeviceArray<Answer> output(questions.size());
        input.copyFrom(questions.data());
        const auto count = static_cast<uint32_t>(questions.size());
        answerAll<<<(count + kThreads - 1) / kThreads, kThreads>>>(tables_.data(), input.data(),
                                                                   output.data(), count);
        finish();
        std::vector<Answer> result(questions.size());
        output.copyTo(result.data());
        return result;
    }

    uint64_t sum(Kind kind, uint32_t count) const override {
        unsigned long long total = 0;
        DeviceArray<unsigned long long> sum(1);
        sum.copyFrom(&total);
        const auto blocks = static_cast<unsigned>(properties_.multiProcessorCount) * 8;
        addDigests<<<blocks, kThreads>>>(tables_.data(), kind, count, sum.data());
        finish();
        sum.copyTo(&total);
        return total;
    }

    std::vector<Rate> rates() const override { return writeRates(tables_.data()); }

private:
    cudaDeviceProp properties_;
    DeviceArray<DeviceTables> tables_;
};

} // namespace

std::unique_ptr<Device> makeChecked() { return std::make_unique<Gpu>(); }

} // namespace gpu_check
