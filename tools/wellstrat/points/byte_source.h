// SPDX-License-Identifier: Apache-2.0
//
// Buffered input from a file or the standard input, compressed by gzip or not.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include <zlib.h>

namespace wellstrat::cli {

/// Bytes in order, decompressed if they begin as those of gzip do. All functions throw CliError if
/// reading fails or what was compressed is damaged.
class ByteSource {
public:
    /// The path "-" is the standard input.
    explicit ByteSource(const std::string& path);
    ~ByteSource();
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;

    /// The path, or "standard input".
    const std::string& name() const { return name_; }

    /// Whether the bytes to come begin with `bytes`, of which there are few.
    bool startsWith(std::string_view bytes);

    /// Skips `bytes`, of which there are few, if they come next.
    void skip(std::string_view bytes);

    /// Reads up to `size` bytes; less only at the end.
    std::size_t read(char* to, std::size_t size);

    /// Reads bytes up to the next line feed, which is dropped, and at most `limit` of them: a
    /// longer line comes in parts. False at the end.
    bool readLine(std::string& line, std::size_t limit);

private:
    /// Makes sure that at least `size` bytes are buffered unless the end is near.
    void fill(std::size_t size);
    std::string_view buffered() const { return {buffer_.data() + begin_, end_ - begin_}; }

    std::string name_;
    gzFile file_;
    std::array<char, 65536> buffer_;
    std::size_t begin_ = 0, end_ = 0;
};

} // namespace wellstrat::cli
