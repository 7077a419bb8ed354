// SPDX-License-Identifier: Apache-2.0

#include "files.h"
#include "uris.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace wellstrat::render {

namespace fs = std::filesystem;

std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) throw std::runtime_error("it may not be read");
    std::string bytes(static_cast<std::size_t>(file.tellg()), '\0');
    file.seekg(0);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file) throw std::runtime_error("it cannot be read to its end");
    return bytes;
}

std::string FileFinder::find(const std::string& name) {
    std::string slashes = name;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    for (const std::string& folder : folders_) {
        for (const std::string& spelling : {name, slashes, percentDecoded(slashes)}) {
            const fs::path path = fs::path(folder) / spelling;
            std::error_code ignored;
            if (!fs::is_regular_file(path, ignored)) continue;
            add(path.string());
            return path.string();
        }
    }
    throw std::runtime_error("no such file");
}

} // namespace wellstrat::render
