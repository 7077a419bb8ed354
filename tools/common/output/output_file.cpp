// SPDX-License-Identifier: Apache-2.0

#include "output_file.h"

#include "common/command_line/errors.h"
#include "temporary_file.h"
#include "write_all.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <set>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace wellstrat::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBufferSize = std::size_t{1} << 16;

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

/// The files that are read.
std::set<std::string>& inputs() {
    static std::set<std::string> names;
    return names;
}

/// The file that `path` names, through all links, also one to nothing yet.
std::string targetOf(const std::string& path) {
    std::error_code error, noLink;
    fs::path target = fs::weakly_canonical(path, error);
    const fs::path leadsTo = fs::read_symlink(target, noLink);
    if (!noLink) target = target.parent_path() / leadsTo;
    if (error) throw fileError("write", path, error.value());
    return target.string();
}

CliError replacesInput(const std::string& path) {
    return CliError(fmt::format(
        "'{}' is an input, which an output would replace; give the output another name", path));
}

/// Opens a new file beside `target` under a name of its own, which it returns in `name`: short,
/// since the target's name may be as long as names can be.
int openTemporary(const std::string& target, std::string& name) {
    const int descriptor = openTemporaryFile(fs::path(target).parent_path().string(), name);
    if (descriptor < 0) {
        name.clear();
    } else {
        fchmod(descriptor, permissions(target)); // not on all file systems
    }
    return descriptor;
}

} // namespace

OutputFile::OutputFile(const std::string& path)
    : path_(path), target_(path), descriptor_(STDOUT_FILENO) {
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
        descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    } else {
        target_ = targetOf(path);
        if (inputs().count(target_) > 0) throw replacesInput(path);
        if (!openTargets().insert(target_).second) {
            throw CliError(fmt::format("'{}' is the name of two outputs; give each its own", path));
        }
        descriptor_ = openTemporary(target_, temporary_);
        if (!temporary_.empty()) removed_.emplace(temporary_);
    }
    if (descriptor_ < 0) {
        const int reason = errno;
        discard();
        throw fileError("write", path, reason);
    }
}

OutputFile::~OutputFile() {
    if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
    discard();
}

void OutputFile::discard() {
    if (!temporary_.empty()) std::remove(temporary_.c_str());
    openTargets().erase(target_);
}

void OutputFile::write(std::string_view bytes) {
    if (buffer_.size() + bytes.size() > kBufferSize) flush();
    if (bytes.size() < kBufferSize) {
        buffer_ += bytes;
    } else if (!writeAll(descriptor_, bytes)) {
        throw fileError("write", path_, errno);
    }
}

void OutputFile::flush() {
    const bool isWritten = writeAll(descriptor_, buffer_);
    buffer_.clear();
    if (!isWritten) throw fileError("write", path_, errno);
}

void OutputFile::commit() {
    flush();
    if (descriptor_ == STDOUT_FILENO) return;
    if (::close(std::exchange(descriptor_, -1)) != 0) throw fileError("write", path_, errno);
    if (temporary_.empty()) return;
    if (std::rename(temporary_.c_str(), target_.c_str()) != 0) {
        throw fileError("write", path_, errno);
    }
    temporary_.clear();
    removed_.reset();
}

void declareInput(const std::string& path) {
    const std::string target = targetOf(path);
    if (openTargets().count(target) > 0) throw replacesInput(path);
    inputs().insert(target);
}

void printText(std::string_view text) {
    OutputFile out("-");
    out.write(text);
    out.commit();
}

} // namespace wellstrat::cli
