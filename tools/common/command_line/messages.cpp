// SPDX-License-Identifier: Apache-2.0

#include "messages.h"

#include "common/output/write_all.h"

#include <csignal>
#include <ctime>
#include <iterator>

#include <unistd.h>

namespace wellstrat::cli {
namespace {

/// While it exists, this thread gets no SIGPIPE for what it writes.
class WithoutPipeSignal {
public:
    WithoutPipeSignal() {
        sigemptyset(&pipe_);
        sigaddset(&pipe_, SIGPIPE);
        sigset_t pending;
        sigpending(&pending);
        wasPending_ = sigismember(&pending, SIGPIPE) == 1;
        pthread_sigmask(SIG_BLOCK, &pipe_, &old_);
    }
    ~WithoutPipeSignal() {
        const timespec atOnce{};
        if (!wasPending_) sigtimedwait(&pipe_, nullptr, &atOnce);
        pthread_sigmask(SIG_SETMASK, &old_, nullptr);
    }
    WithoutPipeSignal(const WithoutPipeSignal&) = delete;
    WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;

private:
    sigset_t pipe_{}, old_{};
    bool wasPending_;
};

} // namespace

void writeMessage(int descriptor, std::string_view text) {
    const WithoutPipeSignal guard;
    writeAll(descriptor, text);
}

void sayText(const std::string& text) {
    const char* const instead = isatty(STDERR_FILENO) != 0 ? "\r\x1b[K" : ""; // of a progress bar
    writeMessage(STDERR_FILENO, fmt::format("{}wellstrat: {}\n", instead, oneLine(text)));
}

std::string oneLine(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '\n') {
            line += "\\n";
        } else if (c == '\t') {
            line += "\\t";
        } else if (byte < 0x20 || byte == 0x7f) {
            fmt::format_to(std::back_inserter(line), "\\x{:02x}", byte);
        } else {
            line += c;
        }
    }
    return line;
}

} // namespace wellstrat::cli
