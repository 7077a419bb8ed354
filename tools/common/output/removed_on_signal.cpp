// SPDX-License-Identifier: Apache-2.0

#include "removed_on_signal.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include <unistd.h>

namespace wellstrat::cli {
namespace {

constexpr std::size_t kSlots = 64;

/// The paths, each allocated by strdup. Who takes one out owns it, so the handler never reads what
/// another thread frees.
std::array<std::atomic<char*>, kSlots> paths;
static_assert(std::atomic<char*>::is_always_lock_free, "signal handlers may use nothing else");

/// By SA_RESETHAND the signal has its default action again, which follows when this returns.
void removeAll(int signal) {
    removeTemporaryFiles();
    raise(signal);
}

void installHandlers() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT, SIGXCPU}) {
        struct sigaction action {};
        if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler != SIG_DFL) continue;
        action.sa_handler = removeAll;
        action.sa_flags = static_cast<int>(SA_RESETHAND);
        sigaction(signal, &action, nullptr);
    }
}

} // namespace

RemovedOnSignal::RemovedOnSignal(const std::string& path) : slot_(0) {
    static const bool installed = (installHandlers(), true);
    static_cast<void>(installed);
    char* const copy = strdup(path.c_str());
    if (copy == nullptr) slot_ = kSlots;
    for (char* none = nullptr; slot_ < kSlots; ++slot_, none = nullptr) {
        if (paths[slot_].compare_exchange_strong(none, copy)) return;
    }
    std::free(copy);
}

RemovedOnSignal::~RemovedOnSignal() {
    if (slot_ < kSlots) std::free(paths[slot_].exchange(nullptr));
}

void removeTemporaryFiles() {
    for (std::atomic<char*>& path : paths) {
        if (const char* const taken = path.exchange(nullptr)) unlink(taken);
    }
}

} // namespace wellstrat::cli
