// SPDX-License-Identifier: Apache-2.0
//
// Temporary files that do not outlive the program, even if Ctrl-C ends it.

#pragma once

#include <string>

namespace wellstrat::cli {

/// While it exists, the signals that end programs, such as SIGINT and SIGTERM, remove the file
/// `path` before they end the program. A signal that is ignored stays so, and one that has another
/// handler is its. Of more than 64 at a time, the last ones do nothing.
class RemovedOnSignal {
public:
    explicit RemovedOnSignal(const std::string& path);
    ~RemovedOnSignal();
    RemovedOnSignal(const RemovedOnSignal&) = delete;
    RemovedOnSignal& operator=(const RemovedOnSignal&) = delete;

private:
    std::size_t slot_;
};

/// Removes all these files now. May be called where the program ends, in a signal handler too.
void removeTemporaryFiles();

} // namespace wellstrat::cli
