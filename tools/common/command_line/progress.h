// SPDX-License-Identifier: Apache-2.0
//
// The progress bar of long runs.

#pragma once

#include <chrono>
#include <mutex>
#include <string>
#include <string_view>

namespace wellstrat::cli {

/// A line on the standard error with a bar, the share of the work done and the time left; nothing
/// if that is no terminal. Cleared at the end. Safe in several threads at once.
class ProgressBar {
public:
    /// `done`, in [0, 1], is what was done before; the time left follows from what is done since.
    explicit ProgressBar(std::string label, double done = 0);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `share` in [0, 1] grows. Cheap: draws a few times in a second. `detail` follows the share.
    void show(double share, std::string_view detail = "");

private:
    using Clock = std::chrono::steady_clock;

    std::string label_;
    double start_;
    bool visible_;
    bool drawn_ = false;
    Clock::time_point begin_ = Clock::now(), last_{};
    std::mutex mutex_;
};

} // namespace wellstrat::cli
