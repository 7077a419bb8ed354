// SPDX-License-Identifier: Apache-2.0

#include "ranks.h"

#include "common/command_line/errors.h"
#include "common/command_line/options.h"
#include "common/command_line/program_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <optional>
#include <string>

#include <dlfcn.h>

namespace wellstrat::cli {
namespace {

/// Whether a launcher has started this process: the variables that Open MPI, PMIx and PMI set.
bool launched() {
    const char* const names[]{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
    return std::any_of(std::begin(names), std::end(names),
                       [](const char* name) { return std::getenv(name) != nullptr; });
}

/// Joins the other processes. MPI and all that it needs is loaded here, and stays.
std::unique_ptr<Communicator> join() {
    const std::optional<std::string> path = findOwnFile(kMpiModule);
    if (!path) {
        throw CliError(
            fmt::format("under mpirun, the processes need {} to work together, which is "
                        "not installed; install wellstrat-mpi",
                        kMpiModule));
    }
    // Global, for the plug-ins that MPI loads on its own.
    void* const module = dlopen(path->c_str(), RTLD_NOW | RTLD_GLOBAL);
    void* const function = module != nullptr ? dlsym(module, kMpiFunction) : nullptr;
    if (function == nullptr) throw CliError(fmt::format("cannot use MPI: {}", dlerror()));
    return std::unique_ptr<Communicator>(reinterpret_cast<JoinMpi*>(function)());
}

} // namespace

unsigned launchedRank() {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMIX_RANK", "PMI_RANK"}) {
        uint64_t rank = 0;
        const char* const text = std::getenv(name);
        if (text != nullptr && parseNumber(text, {0, kMaxWord}, rank)) {
            return static_cast<unsigned>(rank);
        }
    }
    return 0;
}

Ranks::Ranks() {
    if (!launched()) return;
    communicator_ = join();
    rank_ = communicator_->rank();
    size_ = communicator_->size();
}

void Ranks::joinAtRoot(void* bytes, std::size_t size) const {
    if (size_ > 1) communicator_->joinAtRoot(bytes, size);
}

uint64_t Ranks::fromRoot(uint64_t number) const {
    return size_ > 1 ? communicator_->fromRoot(number) : number;
}

bool Ranks::any(bool says) const { return size_ > 1 ? communicator_->any(says) : says; }

void Ranks::abort(int exitCode) const {
    if (size_ > 1) communicator_->abort(exitCode);
}

} // namespace wellstrat::cli
