// SPDX-License-Identifier: Apache-2.0

#include "interrupt.h"

#include <csignal>

namespace wellstrat::cli {
namespace {

/// A signal that is guarded, and what it does without the guard.
struct Guarded {
    int signal;
    struct sigaction unguarded;
};
Guarded guardedSignals[]{{SIGINT, {}}, {SIGTERM, {}}, {SIGHUP, {}}};

void unguard() {
    for (const Guarded& guarded : guardedSignals) {
        sigaction(guarded.signal, &guarded.unguarded, nullptr);
    }
}

void interrupt(int /*signal*/) {
    InterruptGuard::interrupted = true;
    unguard();
}

} // namespace

std::atomic<bool> InterruptGuard::interrupted{false};

InterruptGuard::InterruptGuard() {
    struct sigaction action {};
    action.sa_handler = interrupt;
    for (Guarded& guarded : guardedSignals) {
        sigaction(guarded.signal, nullptr, &guarded.unguarded);
        if (guarded.unguarded.sa_handler == SIG_IGN) continue;
        sigaction(guarded.signal, &action, nullptr);
    }
}

InterruptGuard::~InterruptGuard() { unguard(); }

} // namespace wellstrat::cli
