// SPDX-License-Identifier: Apache-2.0

#include "output_file.h"

#include "errors.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <filesystem>

#include <unistd.h>

namespace wellstrat::cli {
namespace {

namespace fs = std::filesystem;

/// A name in the directory of `target` that no other process uses. Short, since the target's own
/// name may be as long as names can be.
std::string temporaryName(const fs::path& target) {
    static std::atomic<unsigned> counter{0};
    const std::string name = fmt::format(".wellstrat-{}-{}.tmp", getpid(), counter++);
    return (target.parent_path() / name).string();
}

} // namespace

OutputFile::OutputFile(const std::string& path) : path_(path), target_(path), file_(stdout) {
    if (path == "-") {
        path_ = "standard output";
        return;
    }
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (path.empty() || fs::is_directory(status)) {
        throw fileError("write", path, path.empty() ? ENOENT : EISDIR);
    }
    const bool direct = fs::exists(status) && !fs::is_regular_file(status);
    if (!direct) {
        if (fs::is_symlink(fs::symlink_status(path, error))) {
            target_ = fs::weakly_canonical(path, error).string();
        }
        temporary_ = temporaryName(target_);
    }
    file_ = direct ? std::fopen(path.c_str(), "wb") : std::fopen(temporary_.c_str(), "wbx");
    if (file_ == nullptr) throw fileError("write", path, errno);
}

OutputFile::~OutputFile() {
    if (file_ != nullptr && file_ != stdout) std::fclose(file_);
    if (!temporary_.empty()) std::remove(temporary_.c_str());
}

void OutputFile::write(std::string_view bytes) {
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
        throw fileError("write", path_, errno);
    }
}

void OutputFile::close() {
    std::FILE* const file = file_;
    file_ = nullptr;
    const int result = file == stdout ? std::fflush(file) : std::fclose(file);
    if (result != 0) throw fileError("write", path_, errno);
}

void OutputFile::commit() {
    close();
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
        throw fileError("write", path_, errno);
    }
    temporary_.clear();
}

void printText(std::string_view text) {
    OutputFile out("-");
    out.write(text);
    out.commit();
}

} // namespace wellstrat::cli
