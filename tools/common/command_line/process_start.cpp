// SPDX-License-Identifier: Apache-2.0

#include "process_start.h"

#include "common/output/removed_on_signal.h"
#include "errors.h"
#include "messages.h"

#include <csignal>
#include <exception>

#include <fcntl.h>
#include <unistd.h>

namespace wellstrat::cli {
namespace {

/// Opened the wrong way round: of the standard input, to be written only.
void openStandardStreams() {
    for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(descriptor, F_GETFD) != -1) continue;
        open("/dev/null",
             descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY); // the least free number
    }
}

[[noreturn]] void endInError() {
    removeTemporaryFiles();
    const char* what = "wellstrat: an error where none can be handled\n";
    if (const std::exception_ptr error = std::current_exception()) {
        try {
            std::rethrow_exception(error);
        } catch (const std::bad_alloc&) {
            what = "wellstrat: out of memory\n";
        } catch (...) {
        }
    }
    writeMessage(STDERR_FILENO, what);
    _exit(kExitError);
}

} // namespace

void startProcess() {
    openStandardStreams();
    std::signal(SIGXFSZ, SIG_IGN);
    std::set_terminate(endInError);
}

void endProcess(int exitCode) { _exit(exitCode); }

} // namespace wellstrat::cli
