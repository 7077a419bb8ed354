// SPDX-License-Identifier: Apache-2.0
//
// Crashes, hangs, memory and large answers of a process that reads a scene.

#include "renderer/import/child_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <unistd.h>

namespace wellstrat::render {
namespace {

constexpr uint64_t kMemory = uint64_t{1} << 30;
constexpr ChildLimits kLimits{10, kMemory};

std::size_t readAll(int pipe) {
    std::vector<char> buffer(1 << 16);
    std::size_t total = 0;
    ssize_t got = 0;
    while ((got = ::read(pipe, buffer.data(), buffer.size())) > 0)
        total += static_cast<std::size_t>(got);
    return total;
}

/// The message of what `runInChild` throws when the child does this.
std::string errorOf(const std::function<void()>& child, ChildLimits limits = {1, kMemory}) {
    try {
        runInChild([&](int) { child(); }, readAll, limits);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

TEST(ChildProcess, HandsOverWhatItWrites) {
    const std::vector<char> megabytes(10 << 20, 'x'); // more than a pipe holds
    std::size_t got = 0;
    runInChild(
        [&](int pipe) {
            for (std::size_t done = 0; done < megabytes.size();)
                done += static_cast<std::size_t>(
                    ::write(pipe, megabytes.data() + done, megabytes.size() - done));
        },
        [&](int pipe) { got = readAll(pipe); }, kLimits);
    EXPECT_EQ(got, megabytes.size());
}

TEST(ChildProcess, ChangesNothingHere) {
    int value = 1;
    runInChild([&](int) { value = 2; }, readAll, kLimits);
    EXPECT_EQ(value, 1);
}

TEST(ChildProcess, ReportsCrashes) {
    EXPECT_EQ(errorOf([] {}), "none");
    EXPECT_NE(errorOf([] { std::abort(); }).find("makes the importer crash"), std::string::npos);
    EXPECT_NE(errorOf([] { std::raise(SIGSEGV); }).find("makes the importer crash"),
              std::string::npos);
    EXPECT_NE(errorOf([] { std::raise(SIGKILL); }).find("was killed"), std::string::npos);
}

TEST(ChildProcess, EndsWhatHangs) {
    EXPECT_EQ(errorOf([] {
                  for (volatile bool forever = true; forever;) {
                  }
              }),
              "takes too long to read");
}

TEST(ChildProcess, EndsWhatWaits) {
    EXPECT_EQ(errorOf([] { ::sleep(60); }), "takes too long to read");
}

/// Whether a child gets so much memory, in bytes. It only asks, and touches none.
bool getsMemory(uint64_t bytes, uint64_t limit) {
    return errorOf(
               [bytes] {
                   if (::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS,
                              -1, 0) == MAP_FAILED)
                       std::abort();
               },
               {10, limit}) == "none";
}

TEST(ChildProcess, GetsNoMoreMemoryThanItsLimit) {
    EXPECT_TRUE(getsMemory(kMemory / 2, kMemory));
    EXPECT_FALSE(getsMemory(2 * kMemory, kMemory));
    EXPECT_TRUE(getsMemory(2 * kMemory, std::numeric_limits<uint64_t>::max()));
}

// The child would write forever into a pipe that nobody reads.
TEST(ChildProcess, AReaderThatThrowsEndsIt) {
    const auto write = [](int pipe) {
        const char byte = 0;
        while (::write(pipe, &byte, 1) == 1) {
        }
    };
    EXPECT_THROW(runInChild(
                     write, [](int) { throw std::logic_error("no"); }, kLimits),
                 std::logic_error);
}

} // namespace
} // namespace wellstrat::render
