// SPDX-License-Identifier: Apache-2.0
//
// For LD_PRELOAD: lets the N-th call of a kind fail, once, as if disk or memory were full.
//
// $WELLSTRAT_FAULT is KIND:N, N from 1, where KIND is write, open, rename or memory. Calls count
// from main() on. With KIND:0 none fails, and the number of calls goes to the file
// $WELLSTRAT_FAULT_COUNT. Child processes that are not forks have no faults.

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
using Main = int(int, char**, char**);
int __libc_start_main(Main*, int, char**, void (*)(), void (*)(), void (*)(), void*);
}

namespace {

char kind[16];
long failing = 0;
std::atomic<long> calls{-1}; ///< of the kind; below 0 before main()
Main* realMain = nullptr;

void readEnvironment() {
    const char* const fault = std::getenv("WELLSTRAT_FAULT");
    const char* const colon = fault != nullptr ? std::strchr(fault, ':') : nullptr;
    if (colon == nullptr || colon - fault >= long{sizeof kind}) return;
    std::memcpy(kind, fault, static_cast<size_t>(colon - fault));
    failing = std::atol(colon + 1);
    unsetenv("LD_PRELOAD");
    calls = 0;
}

bool fails(const char* what) {
    if (calls < 0 || std::strcmp(kind, what) != 0) return false;
    return ++calls == failing;
}

bool failsWith(const char* what, int reason) {
    if (!fails(what)) return false;
    errno = reason;
    return true;
}

void writeCount() {
    const char* const path = std::getenv("WELLSTRAT_FAULT_COUNT");
    if (calls < 0 || failing != 0 || path == nullptr) return;
    char text[24];
    const int size = std::snprintf(text, sizeof text, "%ld", calls.load());
    const auto file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    syscall(SYS_write, file, text, size);
    syscall(SYS_close, file);
}

int mainWithFaults(int argc, char** argv, char** environment) {
    std::atexit(writeCount);
    readEnvironment();
    return realMain(argc, argv, environment);
}

template <typename Function>
Function* next(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

int openAt(int folder, const char* path, int flags, va_list more) {
    const bool makes = (flags & (O_CREAT | O_TMPFILE)) != 0;
    const mode_t mode = makes ? va_arg(more, mode_t) : 0;
    if (failsWith("open", ENOSPC)) return -1;
    return static_cast<int>(syscall(SYS_openat, folder, path, flags, mode));
}

} // namespace

extern "C" {

int __libc_start_main(Main* main, int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*ldFini)(), void* stackEnd) {
    realMain = main;
    return next<decltype(__libc_start_main)>("__libc_start_main")(mainWithFaults, argc, argv, init,
                                                                  fini, ldFini, stackEnd);
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
    if (failsWith("write", ENOSPC)) return -1;
    return syscall(SYS_write, descriptor, bytes, size);
}

int rename(const char* from, const char* to) noexcept {
    if (failsWith("rename", EACCES)) return -1;
    return static_cast<int>(syscall(SYS_rename, from, to));
}

int open(const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const int descriptor = openAt(AT_FDCWD, path, flags, more);
    va_end(more);
    return descriptor;
}

int open64(const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const int descriptor = openAt(AT_FDCWD, path, flags, more);
    va_end(more);
    return descriptor;
}

int mkostemp(char* path, int flags) {
    if (failsWith("open", ENOSPC)) return -1;
    return next<decltype(mkostemp)>("mkostemp")(path, flags);
}

int memfd_create(const char* name, unsigned flags) noexcept {
    if (failsWith("open", ENOSPC)) return -1;
    return next<decltype(memfd_create)>("memfd_create")(name, flags);
}

FILE* fopen(const char* path, const char* mode) {
    if (failsWith("open", ENOSPC)) return nullptr;
    return next<decltype(fopen)>("fopen")(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
    if (failsWith("open", ENOSPC)) return nullptr;
    return next<decltype(fopen64)>("fopen64")(path, mode);
}

void _exit(int exitCode) {
    writeCount();
    syscall(SYS_exit_group, exitCode);
    __builtin_unreachable();
}

void* malloc(size_t size) noexcept {
    return failsWith("memory", ENOMEM) ? nullptr : __libc_malloc(size);
}

void* calloc(size_t count, size_t size) noexcept {
    return failsWith("memory", ENOMEM) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, size_t size) noexcept {
    return failsWith("memory", ENOMEM) ? nullptr : __libc_realloc(old, size);
}

void* aligned_alloc(size_t alignment, size_t size) noexcept {
    return failsWith("memory", ENOMEM) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, size_t alignment, size_t size) noexcept {
    if (fails("memory")) return ENOMEM;
    *memory = __libc_memalign(alignment, size);
    return *memory != nullptr ? 0 : ENOMEM;
}

} // extern "C"
