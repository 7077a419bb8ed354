// SPDX-License-Identifier: Apache-2.0
//
// A device that answers questions and no more: what the host makes of it.

#pragma once

#include "device.h"

#include <algorithm>

namespace gpu_check {

class AskedDevice : public Device {
public:
    uint64_t sum(Kind kind, uint32_t count) const override {
        constexpr uint32_t kAtOnce = 1u << 16;
        uint64_t total = 0;
        for (uint32_t first = 0; first < count;) {
            const uint32_t end = first + std::min(kAtOnce, count - first);
            std::vector<Question> questions;
            for (uint32_t i = first; i < end; ++i) questions.push_back(randomQuestion(kind, i));
            const std::vector<Answer> given = answers(questions);
            for (uint32_t i = first; i < end; ++i) total += digestOf(given[i - first], i);
            first = end;
        }
        return total;
    }

    std::vector<Rate> rates() const override { return {}; }
};

} // namespace gpu_check
