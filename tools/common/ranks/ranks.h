// SPDX-License-Identifier: Apache-2.0
//
// The processes that work on one task together: those of mpirun, if it has started the tool, else
// this one alone.

#pragma once

#include "communicator.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

namespace wellstrat::cli {

/// The rank that a launcher has given this process, known before it joins the others; 0 without
/// one.
unsigned launchedRank();

/// One object a process, made and destroyed once in the main thread, which alone may call its
/// functions. All processes call the same functions in the same order: each waits for the others.
class Ranks {
public:
    /// Throws CliError if a launcher has started this process and the module for MPI is missing.
    Ranks();

    /// This process is `rank()` of `size()`. Rank 0 writes all output.
    unsigned rank() const { return rank_; }
    unsigned size() const { return size_; }
    bool isRoot() const { return rank_ == 0; }

    /// Replaces `items` of rank 0 by the sums over all processes. Sums must not depend on the order
    /// of their terms.
    template <typename Item>
    void sumAtRoot(std::vector<Item>& items) const {
        static_assert(std::is_trivially_copyable_v<Item>);
        if (size_ > 1) {
            communicator_->sumAtRoot(items.data(), items.size(), sizeof(Item), addItem<Item>);
        }
    }
    /// Replaces the bytes of rank 0 by the bitwise or over all processes.
    void joinAtRoot(void* bytes, std::size_t size) const;
    /// The number that rank 0 gives.
    uint64_t fromRoot(uint64_t number) const;
    /// Whether any process says so.
    bool any(bool says) const;
    /// Ends all processes at once, with this exit code; returns if there is but one.
    void abort(int exitCode) const;

private:
    template <typename Item>
    static void addItem(const void* from, void* to) {
        Item term, sum;
        std::memcpy(&term, from, sizeof term);
        std::memcpy(&sum, to, sizeof sum);
        sum += term;
        std::memcpy(to, &sum, sizeof sum);
    }

    std::unique_ptr<Communicator> communicator_; ///< null where there is no launcher
    unsigned rank_ = 0, size_ = 1;
};

} // namespace wellstrat::cli
