// SPDX-License-Identifier: Apache-2.0

#include "process.h"

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace wellstrat::cli {
namespace {

void check(int errnoValue, const char* what) {
    if (errnoValue != 0) throw std::system_error(errnoValue, std::generic_category(), what);
}

/// Where the streams of the child lead.
class Redirections {
public:
    explicit Redirections(int output) {
        check(posix_spawn_file_actions_init(&actions_), "posix_spawn_file_actions_init");
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, output, STDERR_FILENO);
    }
    ~Redirections() { posix_spawn_file_actions_destroy(&actions_); }
    Redirections(const Redirections&) = delete;
    Redirections& operator=(const Redirections&) = delete;

    const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
    posix_spawn_file_actions_t actions_;
};

} // namespace

int runProcess(const std::vector<std::string>& arguments, int output) {
    std::vector<char*> argv;
    argv.reserve(arguments.size() + 1);
    for (const std::string& argument : arguments) {
        argv.push_back(const_cast<char*>(argument.c_str())); // posix_spawnp does not write to them
    }
    argv.push_back(nullptr);
    const Redirections redirections(output);
    pid_t pid;
    check(posix_spawnp(&pid, argv[0], redirections.get(), nullptr, argv.data(), environ), argv[0]);
    int status = 0;
    while (waitpid(pid, &status, 0) == -1) {
        if (errno != EINTR) check(errno, "waitpid");
    }
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace wellstrat::cli
