// SPDX-License-Identifier: Apache-2.0

#include "ranks.h"

#if defined(WELLSTRAT_WITH_MPI)
#define OMPI_SKIP_MPICXX 1
#define MPICH_SKIP_MPICXX 1
#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#endif

namespace wellstrat::cli {

#if defined(WELLSTRAT_WITH_MPI)
namespace {

constexpr int kWordsOfCell = 12; // of three exact sums

/// Whether a launcher has started this process: the variables that Open MPI, PMIx and PMI set.
bool launched() {
    const char* const names[]{"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"};
    return std::any_of(std::begin(names), std::end(names),
                       [](const char* name) { return std::getenv(name) != nullptr; });
}

void appendWords(const ExactSum& sum, std::vector<uint64_t>& words) {
    words.insert(words.end(), sum.words().begin(), sum.words().end());
}

ExactSum sumAt(const uint64_t* words) { return ExactSum({words[0], words[1], words[2], words[3]}); }

/// As MPI wants its operations: b[i] += a[i] for exact sums.
void addSums(void* a, void* b, int* length, MPI_Datatype* /*type*/) {
    const auto* from = static_cast<const uint64_t*>(a);
    auto* to = static_cast<uint64_t*>(b);
    for (int i = 0; i < *length; ++i, from += 4, to += 4) {
        ExactSum sum = sumAt(to);
        sum += sumAt(from);
        std::copy(sum.words().begin(), sum.words().end(), to);
    }
}

/// The sums of all processes in the words of rank 0.
void reduceWords(std::vector<uint64_t>& words, bool root) {
    MPI_Datatype type;
    MPI_Op add;
    MPI_Type_contiguous(4, MPI_UINT64_T, &type);
    MPI_Type_commit(&type);
    MPI_Op_create(addSums, 1, &add);
    const int count = static_cast<int>(words.size() / 4);
    MPI_Reduce(root ? MPI_IN_PLACE : words.data(), words.data(), count, type, add, 0,
               MPI_COMM_WORLD);
    MPI_Op_free(&add);
    MPI_Type_free(&type);
}

} // namespace

Ranks::Ranks() {
    if (!launched()) return;
    int provided = 0, rank = 0, size = 1;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    rank_ = static_cast<unsigned>(rank);
    size_ = static_cast<unsigned>(size);
}

Ranks::~Ranks() {
    int initialized = 0;
    MPI_Initialized(&initialized);
    if (initialized != 0) MPI_Finalize();
}

void Ranks::addToRoot(std::vector<ErrorSums>& sums) const {
    if (size_ == 1) return;
    std::vector<uint64_t> words;
    words.reserve(sums.size() * kWordsOfCell);
    for (const ErrorSums& cell : sums) {
        for (const ExactSum* sum : {&cell.first, &cell.second, &cell.fourth}) {
            appendWords(*sum, words);
        }
    }
    reduceWords(words, isRoot());
    const uint64_t* word = words.data();
    for (ErrorSums& cell : sums) {
        cell = {sumAt(word), sumAt(word + 4), sumAt(word + 8)};
        word += kWordsOfCell;
    }
}

void Ranks::joinAtRoot(void* bytes, std::size_t size) const {
    if (size_ == 1) return;
    constexpr std::size_t kAtOnce = std::size_t{1} << 26;
    for (auto* part = static_cast<unsigned char*>(bytes); size > 0;) {
        const std::size_t count = std::min(size, kAtOnce);
        MPI_Reduce(isRoot() ? MPI_IN_PLACE : part, part, static_cast<int>(count), MPI_BYTE, MPI_BOR,
                   0, MPI_COMM_WORLD);
        part += count;
        size -= count;
    }
}

uint64_t Ranks::fromRoot(uint64_t number) const {
    if (size_ > 1) MPI_Bcast(&number, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    return number;
}

bool Ranks::any(bool says) const {
    int value = says ? 1 : 0;
    if (size_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    return value != 0;
}

void Ranks::abort(int exitCode) const {
    if (size_ > 1) MPI_Abort(MPI_COMM_WORLD, exitCode);
}

#else

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
void Ranks::addToRoot(std::vector<ErrorSums>& /*sums*/) const {}
void Ranks::joinAtRoot(void* /*bytes*/, std::size_t /*size*/) const {}
uint64_t Ranks::fromRoot(uint64_t number) const { return number; }
bool Ranks::any(bool says) const { return says; }
void Ranks::abort(int /*exitCode*/) const {}

#endif

} // namespace wellstrat::cli
