// SPDX-License-Identifier: Apache-2.0

#include "device.h"

#include <algorithm>
#include <atomic>
#include <thread>

namespace gpu_check {
namespace {

class Host final : public Device {
public:
    Host() : tables_(std::make_unique<DeviceTables>()) {
        wellstrat::copyDeviceTables(tables_.get(), wellstrat::DeviceDraws::all);
    }

    std::string name() const override {
        return std::to_string(threads_) + " threads of this processor";
    }

    std::vector<Answer> answers(const std::vector<Question>& questions) const override {
        std::vector<Answer> result;
        result.reserve(questions.size());
        for (const Question& question : questions) result.push_back(answer(*tables_, question));
        return result;
    }

    uint64_t sum(Kind kind, uint32_t count) const override {
        std::atomic<uint64_t> total{0};
        std::vector<std::thread> others;
        const auto sumOf = [&](uint32_t thread) {
            uint64_t sum = 0;
            for (uint64_t i = thread; i < count; i += threads_) {
                sum += digest(*tables_, kind, static_cast<uint32_t>(i));
            }
            total += sum;
        };
        for (unsigned thread = 1; thread < threads_; ++thread) others.emplace_back(sumOf, thread);
        sumOf(0);
        for (std::thread& other : others) other.join();
        return total;
    }

    std::vector<Rate> rates() const override { return {}; }

private:
    const unsigned threads_ = std::max(1u, std::thread::hardware_concurrency());
    std::unique_ptr<DeviceTables> tables_;
};

} // namespace

std::unique_ptr<Device> makeHost() { return std::make_unique<Host>(); }

} // namespace gpu_check
