// SPDX-License-Identifier: Apache-2.0
//
// What becomes of importers that fail, end, wait or ask for too much, in a process of their own.
// They do so by themselves: no file is read.

#include "renderer/import/scene_child.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

namespace wellstrat::render {
namespace {

constexpr uint64_t kMemory = uint64_t{1} << 30;

/// The message of what `makeInChild` throws when the importer does this.
std::string errorOf(const std::function<void()>& importer) {
    try {
        makeInChild(
            [&] {
                importer();
                return Scene{};
            },
            {1, kMemory});
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

TEST(SceneChild, HandsOverTheScene) {
    const Scene scene = makeInChild(
        [] {
            Scene made;
            made.materials.emplace_back().roughness = 0.25f;
            made.spheres.push_back({{1, 2, 3}, 4, 0, {}});
            made.notes.emplace_back("a note");
            return made;
        },
        {1, kMemory});
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_EQ(scene.materials[0].roughness, 0.25f);
    ASSERT_EQ(scene.spheres.size(), 1u);
    EXPECT_EQ(scene.spheres[0].center, Float3(1, 2, 3));
    EXPECT_EQ(scene.notes, std::vector<std::string>{"a note"});
}

TEST(SceneChild, HandsOverWhatIsThrown) {
    EXPECT_EQ(errorOf([] { throw std::runtime_error("is no scene"); }), "is no scene");
}

TEST(SceneChild, SaysHowTheImporterEnded) {
    EXPECT_EQ(errorOf([] {}), "none");
    EXPECT_EQ(errorOf([] { std::_Exit(0); }), "the importer ended early");
    EXPECT_EQ(errorOf([] { std::_Exit(1); }), "the importer ended early");
    EXPECT_EQ(errorOf([] { std::abort(); }).rfind("makes the importer crash (signal 6, ", 0), 0u);
    EXPECT_EQ(errorOf([] { std::raise(SIGKILL); }),
              "the process that read it was killed, perhaps for lack of memory");
    EXPECT_EQ(errorOf([] { ::sleep(60); }), "takes too long to read");
}

// Asked for and never touched. The sanitizers end a process instead.
TEST(SceneChild, SaysThatMemoryIsMissing) {
    EXPECT_EQ(errorOf([] { ::operator delete(::operator new(2 * kMemory)); }),
              "there is not enough memory");
}

} // namespace
} // namespace wellstrat::render
