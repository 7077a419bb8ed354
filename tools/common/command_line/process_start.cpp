// SPDX-License-Identifier: Apache-2.0

#include "process_start.h"

#include "common/output/removed_on_signal.h"
#include "errors.h"
#include "messages.h"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

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

/// What std::terminate is called for.
const char* reasonOfEnd(const std::exception_ptr& error) {
    try {
        if (error) std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        return "out of memory";
    } catch (const std::exception& known) {
        return known.what();
    } catch (...) {
    }
    return "an error where none can be handled";
}

[[noreturn]] void endInError() {
    removeTemporaryFiles();
    const std::exception_ptr error = std::current_exception();
    char line[512]; // there may be no memory
    std::snprintf(line, sizeof line, "wellstrat: %s\n", reasonOfEnd(error));
    writeMessage(STDERR_FILENO, line);
    _exit(kExitError);
}

/// Libraries such as FFTW end the program where memory ends, after a line of their own.
void endAfterAbort(int /*signal*/) {
    removeTemporaryFiles();
    _exit(kExitError);
}

} // namespace

void startProcess() {
    openStandardStreams();
    std::signal(SIGXFSZ, SIG_IGN);
    std::set_terminate(endInError);
    std::signal(SIGABRT, endAfterAbort);
}

void endProcess(int exitCode) { _exit(exitCode); }

} // namespace wellstrat::cli
