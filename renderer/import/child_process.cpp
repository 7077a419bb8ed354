// SPDX-License-Identifier: Apache-2.0
//
// Runs code that may crash where a crash does no harm.

#include "child_process.h"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace wellstrat::render {
namespace {

[[noreturn]] void failBySystem(const char* what) {
    throw std::runtime_error(fmt::format("cannot {}: {}", what, std::strerror(errno)));
}

/// A crash must look like one and say nothing: default signals, no output, no core file.
void becomeQuiet() {
    for (const int signal :
         {SIGABRT, SIGALRM, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGPIPE, SIGSEGV, SIGTERM, SIGXCPU})
        std::signal(signal, SIG_DFL);
    const int null = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    if (null >= 0) {
        ::dup2(null, STDOUT_FILENO);
        ::dup2(null, STDERR_FILENO);
    }
    const rlimit noCore{0, 0};
    ::setrlimit(RLIMIT_CORE, &noCore);
}

/// The bytes of this process that RLIMIT_DATA counts: the sixth number of statm, see proc(5). 0
/// where the system does not tell.
uint64_t dataSize() {
    std::ifstream statm("/proc/self/statm");
    uint64_t pages = 0;
    for (int i = 0; i < 6; ++i) statm >> pages;
    return statm ? pages * static_cast<uint64_t>(::sysconf(_SC_PAGESIZE)) : 0;
}

void obey(const ChildLimits& limits) {
    const rlimit time{limits.cpuSeconds, limits.cpuSeconds + 1};
    ::setrlimit(RLIMIT_CPU, &time);
    ::alarm(2 * limits.cpuSeconds); // should it wait for something forever
    if (limits.memory == std::numeric_limits<uint64_t>::max()) return;
    const uint64_t bytes = dataSize() + limits.memory;
    const rlimit memory{bytes, bytes};
    ::setrlimit(RLIMIT_DATA, &memory);
}

/// Says how a process ended that did not end by itself. (One that writes what nobody reads did.)
std::string reasonOf(int status) {
    if (!WIFSIGNALED(status) || WTERMSIG(status) == SIGPIPE) return {};
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGALRM) return "takes too long to read";
    if (signal == SIGKILL) return "the process that read it was killed, perhaps for lack of memory";
    return fmt::format("makes the importer crash (signal {}, {})", signal, ::strsignal(signal));
}

int waitFor(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0)
        if (errno != EINTR) failBySystem("wait for a process");
    return status;
}

} // namespace

void runInChild(const std::function<void(int pipe)>& write,
                const std::function<void(int pipe)>& read, const ChildLimits& limits) {
    int ends[2];
    if (::pipe(ends) != 0) failBySystem("make a pipe");
    const pid_t child = ::fork();
    if (child < 0) {
        ::close(ends[0]);
        ::close(ends[1]);
        failBySystem("start a process");
    }
    if (child == 0) {
        ::close(ends[0]);
        becomeQuiet();
        obey(limits);
        try {
            write(ends[1]);
        } catch (...) {
        }
        ::_exit(0); // without the ends of what the parent began
    }

    ::close(ends[1]);
    std::exception_ptr error;
    try {
        read(ends[0]);
    } catch (...) {
        error = std::current_exception();
    }
    ::close(ends[0]); // before waiting: a child that still writes then ends by SIGPIPE
    const std::string reason = reasonOf(waitFor(child));
    if (!reason.empty()) throw std::runtime_error(reason);
    if (error) std::rethrow_exception(error);
}

} // namespace wellstrat::render
