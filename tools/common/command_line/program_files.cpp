// SPDX-License-Identifier: Apache-2.0

#include "program_files.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <system_error>

#include <unistd.h>

namespace wellstrat::cli {
namespace {

namespace fs = std::filesystem;

bool isFile(const fs::path& path) {
    std::error_code ignored;
    return fs::is_regular_file(path, ignored);
}

} // namespace

std::optional<std::string> findOwnFile(const std::string& name) {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error);
    if (error) return {};
    for (const char* folder : {".", WELLSTRAT_OWN_FOLDER}) {
        const fs::path path = program.parent_path() / folder / name;
        if (isFile(path)) return path.string();
    }
    return {};
}

std::optional<std::string> findProgram(const std::string& name) {
    if (std::optional<std::string> own = findOwnFile(name)) return own;
    const char* const folders = std::getenv("PATH");
    std::istringstream rest(folders != nullptr ? folders : "");
    for (std::string folder; std::getline(rest, folder, ':');) {
        const fs::path path = fs::path(folder) / name;
        if (isFile(path) && access(path.c_str(), X_OK) == 0) return path.string();
    }
    return {};
}

} // namespace wellstrat::cli
