// SPDX-License-Identifier: Apache-2.0

#include "byte_source.h"

#include "common/command_line/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <unistd.h>

namespace wellstrat::cli {

ByteSource::ByteSource(const std::string& path)
    : name_(path == "-" ? "standard input" : path),
      file_(path == "-" ? gzdopen(dup(STDIN_FILENO), "rb") : gzopen(path.c_str(), "rb")) {
    if (file_ == nullptr) throw fileError("read", name_, errno);
}

ByteSource::~ByteSource() { gzclose(file_); }

void ByteSource::fill(std::size_t size) {
    if (end_ - begin_ >= size) return;
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    const int read =
        gzread(file_, buffer_.data() + end_, static_cast<unsigned>(buffer_.size() - end_));
    if (read > 0) end_ += static_cast<std::size_t>(read);
    int status = Z_OK;
    gzerror(file_, &status);
    if (status == Z_ERRNO) throw fileError("read", name_, errno);
    if (status != Z_OK && status != Z_STREAM_END) {
        throw CliError(fmt::format("'{}': compressed by gzip, but damaged or cut off", name_));
    }
}

bool ByteSource::startsWith(std::string_view bytes) {
    fill(bytes.size());
    return buffered().substr(0, bytes.size()) == bytes;
}

void ByteSource::skip(std::string_view bytes) {
    if (startsWith(bytes)) begin_ += bytes.size();
}

std::size_t ByteSource::read(char* to, std::size_t size) {
    std::size_t done = 0;
    while (done < size) {
        fill(1);
        const std::size_t part = std::min(size - done, end_ - begin_);
        if (part == 0) break;
        std::memcpy(to + done, buffer_.data() + begin_, part);
        begin_ += part;
        done += part;
    }
    return done;
}

bool ByteSource::readLine(std::string& line, std::size_t limit) {
    line.clear();
    for (;;) {
        fill(1);
        const std::string_view bytes = buffered().substr(0, limit - line.size());
        if (bytes.empty()) return !line.empty();
        const std::size_t feed = bytes.find('\n');
        line.append(bytes.substr(0, feed));
        begin_ += feed == std::string_view::npos ? bytes.size() : feed + 1;
        if (feed != std::string_view::npos || line.size() == limit) return true;
    }
}

} // namespace wellstrat::cli
