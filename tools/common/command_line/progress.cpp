// SPDX-License-Identifier: Apache-2.0

#include "progress.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <utility>

#include <unistd.h>

namespace wellstrat::cli {
namespace {

constexpr int kBarWidth = 30;
constexpr std::chrono::milliseconds kInterval{200};

/// "1:02:03", or "02:03" below an hour.
std::string timeText(double seconds) {
    const long whole = std::lround(seconds);
    const long hours = whole / 3600, minutes = whole / 60 % 60;
    return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                     : fmt::format("{:02}:{:02}", minutes, whole % 60);
}

} // namespace

ProgressBar::ProgressBar(std::string label, double done)
    : label_(std::move(label)), start_(done), visible_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (drawn_) fmt::print(stderr, "\r\x1b[K");
}

void ProgressBar::show(double share, std::string_view detail) {
    if (!visible_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (now - last_ < kInterval || share <= start_) return;
    last_ = now;
    drawn_ = true;
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    const double left = elapsed * (1 - share) / (share - start_);
    const int filled = static_cast<int>(kBarWidth * share);
    fmt::print(stderr, "\r{} [{:#<{}}{:.<{}}] {:3.0f} %{}, {} left\x1b[K", label_, "", filled, "",
               kBarWidth - filled, 100 * share, detail, timeText(left));
    std::fflush(stderr);
}

} // namespace wellstrat::cli
