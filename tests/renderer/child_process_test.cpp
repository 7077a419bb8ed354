// SPDX-License-Identifier: Apache-2.0
//
// Crashes, hangs and large answers of a process that reads a scene.

#include "renderer/import/child_process.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

namespace wellstrat::render {
namespace {

std::size_t readAll(int pipe) {
    std::vector<char> buffer(1 << 16);
    std::size_t total = 0;
    ssize_t got = 0;
    while ((got = ::read(pipe, buffer.data(), buffer.size())) > 0)
        total += static_cast<std::size_t>(got);
    return total;
}

/// The message of what `runInChild` throws when the child does this.
std::string errorOf(const std::function<void()>& child) {
    try {
        runInChild([&](int) { child(); }, readAll, 1);
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
        [&](int pipe) { got = readAll(pipe); }, 10);
    EXPECT_EQ(got, megabytes.size());
}

TEST(ChildProcess, ChangesNothingHere) {
    int value = 1;
    runInChild([&](int) { value = 2; }, readAll, 10);
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

// The child would write forever into a pipe that nobody reads.
TEST(ChildProcess, AReaderThatThrowsEndsIt) {
    const auto write = [](int pipe) {
        const char byte = 0;
        while (::write(pipe, &byte, 1) == 1) {
        }
    };
    EXPECT_THROW(runInChild(
                     write, [](int) { throw std::logic_error("no"); }, 10),
                 std::logic_error);
}

} // namespace
} // namespace wellstrat::render
