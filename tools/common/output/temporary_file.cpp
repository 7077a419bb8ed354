// SPDX-License-Identifier: Apache-2.0

#include "temporary_file.h"

#include <cstdlib>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace wellstrat::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPrefix = ".wellstrat-tmp-", kRandom = "XXXXXX"; ///< as of mkostemp

bool isTemporaryName(const std::string& name) {
    return name.size() == kPrefix.size() + kRandom.size() &&
           name.compare(0, kPrefix.size(), kPrefix) == 0;
}

/// Removes the file if it is ours and no process has it locked. Where files cannot be locked, it
/// stays.
void removeIfLeftBehind(const std::string& path) {
    const int descriptor = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return;
    struct stat status {};
    const bool isOurs =
        fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == geteuid();
    if (isOurs && flock(descriptor, LOCK_EX | LOCK_NB) == 0) unlink(path.c_str());
    close(descriptor);
}

/// Once a folder: a program makes many files in one.
void removeLeftBehind(const std::string& folder) {
    static std::set<std::string> seen;
    if (!seen.insert(folder).second) return;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
        if (isTemporaryName(entry->path().filename().string())) {
            removeIfLeftBehind(entry->path().string());
        }
    }
}

/// Whether the file has its lock, or cannot have one, and still is there: between its making and
/// its locking, another process may take it for one that was left behind.
bool lock(int descriptor) {
    struct stat status {};
    flock(descriptor, LOCK_EX);
    return fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

} // namespace

int openTemporaryFile(const std::string& folder, std::string& path) {
    removeLeftBehind(folder.empty() ? "." : folder);
    for (;;) {
        path = (fs::path(folder) / kPrefix).string().append(kRandom);
        const int descriptor = mkostemp(path.data(), O_CLOEXEC);
        if (descriptor < 0 || lock(descriptor)) return descriptor;
        close(descriptor);
    }
}

} // namespace wellstrat::cli
