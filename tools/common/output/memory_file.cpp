// SPDX-License-Identifier: Apache-2.0

#include "memory_file.h"

#include "common/command_line/errors.h"
#include "write_all.h"

#include <fmt/format.h>

#include <cerrno>

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace wellstrat::cli {
namespace {

constexpr auto kName = "a file in memory";

[[noreturn]] void fail(const char* action) { throw fileError(action, kName, errno); }

} // namespace

MemoryFile::MemoryFile(std::string_view bytes) : descriptor_(memfd_create("wellstrat", 0)) {
    if (descriptor_ < 0) fail("make");
    if (writeAll(descriptor_, bytes)) return;
    const int reason = errno;
    ::close(descriptor_);
    throw fileError("write", kName, reason);
}

MemoryFile::~MemoryFile() { ::close(descriptor_); }

std::string MemoryFile::path() const { return fmt::format("/proc/self/fd/{}", descriptor_); }

std::string MemoryFile::read() const {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) fail("read");
    std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
    for (std::size_t done = 0; done < bytes.size();) {
        const ssize_t count =
            ::pread(descriptor_, &bytes[done], bytes.size() - done, static_cast<off_t>(done));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) fail("read");
        done += static_cast<std::size_t>(count);
    }
    return bytes;
}

} // namespace wellstrat::cli
