// SPDX-License-Identifier: Apache-2.0
//
// Who can be asked: a processor, or a GPU.

#pragma once

#include "question.h"

#include <cstdint>
#include <memory>
#include <stdexcept>
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
    Device() = default;
    virtual ~Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;

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

/// There is nothing to check on this machine.
class NoDevice : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What is checked: the first device that CUDA, Vulkan or OpenCL finds, or in a build without them
/// this processor again. Throws NoDevice if there is none.
std::unique_ptr<Device> makeChecked();

} // namespace gpu_check
