// SPDX-License-Identifier: Apache-2.0
//
// The module that the tools load under mpirun: a Communicator of MPI.

#include "common/ranks/communicator.h"

#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>

namespace wellstrat::cli {
namespace {

/// What addItems calls: MPI gives its operations no argument of their user.
AddItem addOfOperation = nullptr;

/// As MPI wants its operations: b[i] += a[i].
void addItems(void* a, void* b, int* length, MPI_Datatype* type) {
    int size = 0;
    MPI_Type_size(*type, &size);
    const auto* from = static_cast<const unsigned char*>(a);
    auto* to = static_cast<unsigned char*>(b);
    for (int i = 0; i < *length; ++i, from += size, to += size) addOfOperation(from, to);
}

class MpiCommunicator final : public Communicator {
public:
    MpiCommunicator() {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &size_);
    }
    ~MpiCommunicator() override { MPI_Finalize(); }

    unsigned rank() const override { return static_cast<unsigned>(rank_); }
    unsigned size() const override { return static_cast<unsigned>(size_); }

    void sumAtRoot(void* items, std::size_t count, std::size_t itemSize, AddItem add) override {
        MPI_Datatype type;
        MPI_Op operation;
        MPI_Type_contiguous(static_cast<int>(itemSize), MPI_BYTE, &type);
        MPI_Type_commit(&type);
        MPI_Op_create(addItems, 1, &operation);
        addOfOperation = add;
        MPI_Reduce(own(items), items, static_cast<int>(count), type, operation, 0, MPI_COMM_WORLD);
        MPI_Op_free(&operation);
        MPI_Type_free(&type);
    }

    void joinAtRoot(void* bytes, std::size_t size) override {
        constexpr std::size_t kAtOnce = std::size_t{1} << 26;
        for (auto* part = static_cast<unsigned char*>(bytes); size > 0;) {
            const std::size_t count = std::min(size, kAtOnce);
            MPI_Reduce(own(part), part, static_cast<int>(count), MPI_BYTE, MPI_BOR, 0,
                       MPI_COMM_WORLD);
            part += count;
            size -= count;
        }
    }

    uint64_t fromRoot(uint64_t number) override {
        MPI_Bcast(&number, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
        return number;
    }

    bool any(bool says) override {
        int value = says ? 1 : 0;
        MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
        return value != 0;
    }

    void abort(int exitCode) override { MPI_Abort(MPI_COMM_WORLD, exitCode); }

private:
    /// What this process sends in a reduction whose result replaces `data` of rank 0.
    const void* own(const void* data) const { return rank_ == 0 ? MPI_IN_PLACE : data; }

    int rank_ = 0, size_ = 1;
};

} // namespace
} // namespace wellstrat::cli

extern "C" {
/// See kMpiFunction. The caller owns the result.
__attribute__((visibility("default"))) wellstrat::cli::Communicator* wellstratJoinMpi();
}

wellstrat::cli::Communicator* wellstratJoinMpi() { return new wellstrat::cli::MpiCommunicator; }
