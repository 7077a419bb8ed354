// SPDX-License-Identifier: Apache-2.0

#include "interrupt.h"

#include <csignal>

namespace wellstrat::cli {
namespace {

/// What the signals do without the guard.
struct sigaction unguardedInt, unguardedTerm;

void unguard() {
    sigaction(SIGINT, &unguardedInt, nullptr);
    sigaction(SIGTERM, &unguardedTerm, nullptr);
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
    sigaction(SIGINT, &action, &unguardedInt);
    sigaction(SIGTERM, &action, &unguardedTerm);
}

InterruptGuard::~InterruptGuard() { unguard(); }

} // namespace wellstrat::cli
