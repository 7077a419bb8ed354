// SPDX-License-Identifier: Apache-2.0
//
// Files that are no scenes, and environment maps.

#include "scene_files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace wellstrat::render {
namespace {

TEST(SceneFile, ErrorsNameTheFileInOneLine) {
    const TempFolder folder;
    EXPECT_EQ(errorOf("/no/such/scene.glb"),
              "cannot read scene '/no/such/scene.glb': no such file");
    EXPECT_EQ(errorOf(folder.path("")),
              "cannot read scene '" + folder.path("") + "': it is a folder");
    EXPECT_NE(errorOf("/dev/null").find("it is no ordinary file"), std::string::npos);
    for (const auto& path :
         {folder.write("empty.gltf", ""), folder.write("text.gltf", "hello\nworld"),
          folder.write("half.gltf", quadGltf().dump().substr(0, 200)),
          folder.write("text.glb", "glTF\2"), folder.write("scene.unknown", "hello"),
          folder.write("noextension", "hello"), folder.write("text.ply", "ply\n"),
          folder.write("text.fbx", "Kaydara"), folder.write("text.dae", "<a>")}) {
        const std::string error = errorOf(path);
        EXPECT_EQ(error.rfind("cannot read scene '" + path + "': ", 0), 0u) << error;
        EXPECT_GT(error.size(), path.size() + 24) << error;
        EXPECT_TRUE(std::none_of(error.begin(), error.end(),
                                 [](unsigned char c) { return std::iscntrl(c); }));
    }
}

TEST(SceneFile, KindsThatHaveNoReader) {
    const TempFolder folder;
    for (const char* const name : {"scene.usd", "scene.abc", "picture.png", "noextension"})
        EXPECT_NE(errorOf(folder.write(name, "hello"))
                      .find("there is no reader for this kind of file; glTF, OBJ, PLY and STL are"),
                  std::string::npos)
            << name;
}

TEST(SceneFile, WithoutTrianglesIsAnError) {
    const TempFolder folder;
    for (const auto& path : {folder.write("points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n"),
                             folder.write("degenerate.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n"),
                             folder.write("nan.obj", "v nan nan nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
                             folder.write("nothing.obj", "v 0 0 0\n"),
                             folder.write("scene.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
                                         "scenes": [{"nodes": []}]})")})
        EXPECT_NE(errorOf(path), "none") << path;
    EXPECT_NE(errorOf(folder.path("degenerate.obj")).find("no triangles to render"),
              std::string::npos);
}

TEST(SceneFile, WithoutTrianglesSaysWhatThereWas) {
    const TempFolder folder;
    const auto reason = [&](const std::string& obj) {
        const std::string error = errorOf(folder.write("scene.obj", obj));
        return error.substr(error.find("': ") + 3);
    };
    EXPECT_EQ(reason("v 0 0 0\nv 2e9 0 0\nv 0 2e9 0\nv 2 0 0\nv 1 0 0\nf 1 2 3\nf 1 4 5\n"),
              "there are no triangles to render in it, only 1 triangles with a corner beyond 1e9, "
              "1 triangles without area");
    EXPECT_EQ(reason("v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
              "there are no triangles to render in it, only 1 triangles with a corner that is no "
              "number");
}

TEST(EnvironmentMap, IsRead) {
    const TempFolder folder;
    const std::string path = folder.path("sky.hdr");
    const float pixels[] = {1, 2, 4, 100, 50, 25};
    const auto file = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(file->open(path, OIIO::ImageSpec(2, 1, 3, OIIO::TypeDesc::FLOAT)));
    ASSERT_TRUE(file->write_image(OIIO::TypeDesc::FLOAT, pixels));
    ASSERT_TRUE(file->close());
    const Environment environment = readEnvironment(path);
    ASSERT_TRUE(environment.map);
    EXPECT_EQ(environment.radiance, Float3(1.0f));
    expectNear(environment.map->pixel(0, 0), {1, 2, 4}, 0.05f);
    expectNear(environment.map->pixel(1, 0), {100, 50, 25}, 1.0f);
}

// The importer's process must not wait for threads that reading a picture here has started.
TEST(EnvironmentMap, CanBeReadAfterOtherPictures) {
    const TempFolder folder;
    const std::string path = folder.path("sky.exr");
    const std::vector<float> pixels(600 * 300 * 3, 0.5f);
    OIIO::ImageSpec spec(600, 300, 3, OIIO::TypeDesc::FLOAT);
    spec["compression"] = "zip";
    const auto file = OIIO::ImageOutput::create(path);
    ASSERT_TRUE(file->open(path, spec));
    ASSERT_TRUE(file->write_image(OIIO::TypeDesc::FLOAT, pixels.data()));
    ASSERT_TRUE(file->close());
    EXPECT_EQ(readTexture(path, Encoding::linear).width(), 600u);
    EXPECT_EQ(readEnvironment(path).map->height(), 300u);
}

// Halves end at 65504, and suns are brighter.
TEST(EnvironmentMap, ASunThatIsInfiniteIsTheBrightestOfThePicture) {
    const TempFolder folder;
    const float infinity = std::numeric_limits<float>::infinity();
    const auto path =
        writePicture<float>(folder, "sky.exr", 2, 2, 3,
                            {1, 2, 3, infinity, infinity, infinity, 60000, 2, 1, -1, 0.5f, 0.25f});
    std::vector<std::string> notes;
    const Environment environment = readEnvironment(path, &notes);
    expectNear(environment.map->pixel(1, 0), Float3(60000));
    expectNear(environment.map->pixel(0, 1), {60000, 2, 1});
    expectNear(environment.map->pixel(1, 1), {0, 0.5f, 0.25f});
    ASSERT_EQ(notes.size(), 2u);
    EXPECT_EQ(notes[0],
              "1 pixels of the environment map are infinite or no numbers: they get the "
              "largest value that is neither, 60000.");
    EXPECT_EQ(notes[1],
              "1 pixels of the environment map are negative or above 1e9: they get the "
              "nearest value between.");
}

TEST(EnvironmentMap, ErrorsNameTheFile) {
    const TempFolder folder;
    EXPECT_THROW(readEnvironment(folder.write("sky.exr", "no picture")), std::runtime_error);
    try {
        readEnvironment("/no/such/sky.exr");
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "cannot read environment map '/no/such/sky.exr': no such file");
    }
}

} // namespace
} // namespace wellstrat::render
