// SPDX-License-Identifier: Apache-2.0
//
// Who can be asked: a processor, or a GPU.

#pragma once

#include "question.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace gpu_check {

/// How fast something was written to the memory of a device.
struct Rate {
    std::string what;
    double bytesPerSecond;
};

/// All functions throw std::runtime_error if the device fails.
class Device {
public:
    virtual ~Device() = default;

    virtual std::string name() const = 0;
    virtual std::vector<Answer> answers(const std::vector<Question>& questions) const = 0;

    /// The sum of `digest` over questions [0, count) of a kind, modulo 2^64.
    virtual uint64_t sum(Kind kind, uint32_t count) const = 0;

    /// The best of some runs each: a plain fill first, then draws of two floats. Empty where that
    /// means nothing.
    virtual std::vector<Rate> rates() const = 0;
};

/// This processor with all its threads.
std::unique_ptr<Device> makeHost();

/// What is checked: the first GPU, or in a build without CUDA this processor again. Throws
/// std::runtime_error if there is no GPU.
std::unique_ptr<Device> makeChecked();

} // namespace gpu_check
