// SPDX-License-Identifier: Apache-2.0
//
// The processes that work on one task together: those of mpirun, if the tool is built with MPI and
// was started by it, else this one alone.

#pragma once

#include "wellstrat/analysis/convergence.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wellstrat::cli {

/// One object a process, made and destroyed once in the main thread, which alone may call its
/// functions. All processes call the same functions in the same order: each waits for the others.
class Ranks {
public:
    Ranks();
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    /// This process is `rank()` of `size()`. Rank 0 writes all output.
    unsigned rank() const { return rank_; }
    unsigned size() const { return size_; }
    bool isRoot() const { return rank_ == 0; }

    /// Replaces `sums` of rank 0 by the sums over all processes.
    void addToRoot(std::vector<ErrorSums>& sums) const;
    /// Replaces the bytes of rank 0 by the bitwise or over all processes.
    void joinAtRoot(void* bytes, std::size_t size) const;
    /// The number that rank 0 gives.
    uint64_t fromRoot(uint64_t number) const;
    /// Whether any process says so.
    bool any(bool says) const;
    /// Ends all processes at once, with this exit code; returns if there is but one.
    void abort(int exitCode) const;

private:
    unsigned rank_ = 0, size_ = 1;
};

} // namespace wellstrat::cli
