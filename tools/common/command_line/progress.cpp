// SPDX-License-Identifier: Apache-2.0

#include "progress.h"

#include "messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <sys/ioctl.h>
#include <unistd.h>

namespace wellstrat::cli {
namespace {

constexpr std::size_t kBarWidth = 30;
constexpr double kFirstEstimate = 2; ///< seconds: what is told earlier is mostly wrong
constexpr std::chrono::milliseconds kInterval{200};

/// The characters in a line of the terminal.
std::size_t terminalWidth() {
    winsize size{};
    const bool isKnown = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
    return isKnown ? size.ws_col : 80;
}

/// "1:02:03", or "02:03" below an hour.
std::string timeText(double seconds) {
    const long whole = std::lround(seconds);
    const long hours = whole / 3600, minutes = whole / 60 % 60;
    return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes, whole % 60)
                     : fmt::format("{:02}:{:02}", minutes, whole % 60);
}

/// With a bar as wide as the line of `width` characters has room for, none if that is too narrow.
std::string lineOf(const std::string& label, double share, const std::string& text,
                   std::size_t width) {
    const std::size_t others = label.size() + text.size() + std::string_view(" []").size();
    const std::size_t bar = others < width ? std::min(kBarWidth, width - others) : 0;
    if (bar == 0) return (label + text).substr(0, width);
    const auto filled = static_cast<std::size_t>(static_cast<double>(bar) * share);
    return fmt::format("{} [{:#<{}}{:.<{}}]{}", label, "", filled, "", bar - filled, text);
}

} // namespace

ProgressBar::ProgressBar(std::string label, double done)
    : label_(std::move(label)), start_(done), visible_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    if (drawn_) writeMessage(STDERR_FILENO, "\r\x1b[K");
}

void ProgressBar::show(double share, std::string_view detail) {
    if (!visible_) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    const Clock::time_point now = Clock::now();
    if (now - last_ < kInterval || share < start_) return;
    last_ = now;
    drawn_ = true;
    const double elapsed = std::chrono::duration<double>(now - begin_).count();
    std::string text = fmt::format(" {:3.0f} %{}", 100 * share, detail);
    if (elapsed >= kFirstEstimate && share > start_) {
        text += fmt::format(", {} left", timeText(elapsed * (1 - share) / (share - start_)));
    }
    text = lineOf(label_, share, text, terminalWidth() - 1);
    writeMessage(STDERR_FILENO, fmt::format("\r{}\x1b[K", text));
}

} // namespace wellstrat::cli
