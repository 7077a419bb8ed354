// SPDX-License-Identifier: Apache-2.0

#include "output_file.h"

#include "common/command_line/errors.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <set>

#include <sys/stat.h>
#include <unistd.h>

namespace wellstrat::cli {
namespace {

namespace fs = std::filesystem;

/// The targets of all files being written.
std::set<std::string>& openTargets() {
    static std::set<std::string> targets;
    return targets;
}

/// The permissions of the file that `target` will replace, or those of a new file.
mode_t permissions(const std::string& target) {
    struct stat status {};
    if (stat(target.c_str(), &status) == 0) return status.st_mode & 07777;
    const mode_t mask = umask(0);
    umask(mask);
    return 0666 & ~mask;
}

/// Opens a new file beside `target` under a name of its own, which it returns in `name`: short,
/// since the target's name may be as long as names can be.
std::FILE* openTemporary(const std::string& target, std::string& name) {
    name = (fs::path(target).parent_path() / ".wellstrat-XXXXXX").string();
    const int descriptor = mkstemp(name.data());
    if (descriptor < 0) {
        name.clear();
        return nullptr;
    }
    if (fchmod(descriptor, permissions(target)) == 0) {
        if (std::FILE* const file = fdopen(descriptor, "wb")) return file;
    }
    ::close(descriptor);
    return nullptr;
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
    if (fs::exists(status) && !fs::is_regular_file(status)) {
        file_ = std::fopen(path.c_str(), "wb");
    } else {
        fs::path target = fs::weakly_canonical(path, error);
        std::error_code noLink;
        const fs::path leadsTo = fs::read_symlink(target, noLink); // to nothing yet
        if (!noLink) target = target.parent_path() / leadsTo;
        target_ = target.string();
        if (error) throw fileError("write", path, error.value());
        if (!openTargets().insert(target_).second) {
            throw CliError(fmt::format("'{}' is the name of two outputs; give each its own", path));
        }
        file_ = openTemporary(target_, temporary_);
        if (!temporary_.empty()) removed_.emplace(temporary_);
    }
    if (file_ == nullptr) {
        const int reason = errno;
        discard();
        throw fileError("write", path, reason);
    }
}

OutputFile::~OutputFile() {
    if (file_ != nullptr && file_ != stdout) std::fclose(file_);
    discard();
}

void OutputFile::discard() {
    if (!temporary_.empty()) std::remove(temporary_.c_str());
    openTargets().erase(target_);
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
    removed_.reset();
}

void printText(std::string_view text) {
    OutputFile out("-");
    out.write(text);
    out.commit();
}

} // namespace wellstrat::cli
