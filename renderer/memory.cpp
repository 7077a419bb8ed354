// SPDX-License-Identifier: Apache-2.0

#include "memory.h"

#include <fmt/format.h>

#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

namespace wellstrat::render {
namespace {

double gigabytes(uint64_t bytes) { return static_cast<double>(bytes) * 1e-9; }

} // namespace

/// MemAvailable of Linux, see proc(5).
uint64_t availableMemory() {
    std::ifstream in("/proc/meminfo");
    std::string name;
    uint64_t kibibytes;
    while (in >> name >> kibibytes) {
        if (name == "MemAvailable:") return kibibytes * 1024;
        in.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
    }
    return std::numeric_limits<uint64_t>::max();
}

void requireMemory(uint64_t bytes, const std::string& what) {
    const uint64_t available = availableMemory();
    if (bytes <= available) return;
    throw std::runtime_error(
        fmt::format("{} need {:.1f} GB of memory, of which {:.1f} GB are there", what,
                    gigabytes(bytes), gigabytes(available)));
}

} // namespace wellstrat::render
