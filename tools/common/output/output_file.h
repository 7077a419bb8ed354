// SPDX-License-Identifier: Apache-2.0
//
// Output that appears under its name only when it is complete.

#pragma once

#include "removed_on_signal.h"

#include <optional>
#include <string>
#include <string_view>

namespace wellstrat::cli {

/// A file being written. The bytes go to a temporary file in the same directory, which `commit`
/// renames; without a commit the destructor, or the signal of Ctrl-C, removes it, and a file of
/// that name stays as it was. The path "-" is the standard output; that, devices and pipes are
/// written directly. A symbolic link stays, and the file that it leads to is replaced, with the
/// permissions that it had. Two files being written cannot have one name, nor can one that is read.
/// A temporary file that was left behind by a program that was killed is removed when the next one
/// writes to that directory. All functions throw CliError on failure.
class OutputFile {
public:
    explicit OutputFile(const std::string& path);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::string_view bytes);
    void commit();

private:
    void flush();
    void discard();

    std::string path_;
    std::string target_;    ///< what the temporary file will be renamed to
    std::string temporary_; ///< empty when written directly
    std::optional<RemovedOnSignal> removed_;
    int descriptor_; ///< -1 when closed
    std::string buffer_;
};

/// Says that the file `path` is read. Throws CliError if an OutputFile is to replace it; later ones
/// will not.
void declareInput(const std::string& path);

/// Prints to the standard output at once. Throws CliError if that fails.
void printText(std::string_view text);

} // namespace wellstrat::cli
