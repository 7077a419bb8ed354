// SPDX-License-Identifier: Apache-2.0
//
// Files in memory, for child processes that want files: they need no folder, and are gone with the
// process however it ends.

#pragma once

#include <string>
#include <string_view>

namespace wellstrat::cli {

/// A file without a name in any folder, which child processes inherit. All functions throw CliError
/// on failure.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes = {});
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int descriptor() const { return descriptor_; }
    /// The name under which a child process opens it.
    std::string path() const;
    /// All its bytes.
    std::string read() const;

private:
    int descriptor_;
};

} // namespace wellstrat::cli
