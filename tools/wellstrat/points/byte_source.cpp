// SPDX-License-Identifier: Apache-2.0

#include "byte_source.h"

#include "common/command_line/errors.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace wellstrat::cli {

ByteSource::ByteSource(const std::string& path)
    : name_(path == "-" ? "standard input" : path),
      file_(path == "-" ? stdin : std::fopen(path.c_str(), "rb")) {
    if (file_ == nullptr) throw fileError("read", name_, errno);
}

ByteSource::~ByteSource() {
    if (file_ != stdin) std::fclose(file_);
}

void ByteSource::fill(std::size_t size) {
    if (end_ - begin_ >= size) return;
    std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    end_ += std::fread(buffer_.data() + end_, 1, buffer_.size() - end_, file_);
    if (std::ferror(file_) != 0) throw fileError("read", name_, errno);
}

bool ByteSource::startsWith(std::string_view bytes) {
    fill(bytes.size());
    return buffered().substr(0, bytes.size()) == bytes;
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
