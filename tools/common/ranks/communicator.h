// SPDX-License-Identifier: Apache-2.0
//
// How processes that a launcher has started reach each other. The module in tools/mpi does it by
// MPI; nothing else of the tools knows MPI.

#pragma once

#include <cstddef>
#include <cstdint>

namespace wellstrat::cli {

/// Adds the item at `from` to the one at `to`; neither need be aligned.
using AddItem = void (*)(const void* from, void* to);

/// Made and destroyed once in a process, in the main thread, which alone may call its functions.
/// All processes call the same functions in the same order: each waits for the others.
class Communicator {
public:
    Communicator() = default;
    virtual ~Communicator() = default;
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;

    virtual unsigned rank() const = 0;
    virtual unsigned size() const = 0;

    /// Replaces `count` items of `itemSize` bytes of rank 0 by the sums over all processes, in any
    /// order of the terms.
    virtual void sumAtRoot(void* items, std::size_t count, std::size_t itemSize, AddItem add) = 0;
    /// Replaces the bytes of rank 0 by the bitwise or over all processes.
    virtual void joinAtRoot(void* bytes, std::size_t size) = 0;
    /// The number that rank 0 gives.
    virtual uint64_t fromRoot(uint64_t number) = 0;
    /// Whether any process says so.
    virtual bool any(bool says) = 0;
    /// Ends all processes at once, with this exit code.
    virtual void abort(int exitCode) = 0;
};

/// The module's file, and the function that it exports: joins the processes of the launcher.
constexpr auto kMpiModule = "wellstrat-mpi.so";
constexpr auto kMpiFunction = "wellstratJoinMpi";
using JoinMpi = Communicator*();

} // namespace wellstrat::cli
