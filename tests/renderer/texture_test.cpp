// SPDX-License-Identifier: Apache-2.0
//
// Pictures from files: decoding, lookups, and what is not a picture.

#include "renderer/texture.h"
#include "scene_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace wellstrat::render {
namespace {

TEST(Texture, DecodesSrgb) {
    const TempFolder folder;
    const auto path = writePicture<uint8_t>(folder, "a.png", 2, 1, 3, {0, 188, 255, 10, 55, 128});
    const Texture srgb = readTexture(path, Encoding::sRgb);
    // IEC 61966-2-1: (188 / 255 + 0.055) / 1.055, to the 2.4; 10 / 255 / 12.92.
    expectNear(srgb.pixel(0, 0), {0, 0.502886f, 1}, 1e-5f);
    expectNear(srgb.pixel(1, 0), {0.003035f, 0.038204f, 0.215861f}, 1e-5f);
    const Texture linear = readTexture(path, Encoding::linear);
    expectNear(linear.pixel(1, 0), {10 / 255.0f, 55 / 255.0f, 128 / 255.0f});
}

TEST(Texture, TopRowFirst) {
    const TempFolder folder;
    const auto path = writePicture<uint8_t>(folder, "a.png", 1, 2, 3, {255, 0, 0, 0, 0, 255});
    const Texture texture = readTexture(path, Encoding::linear);
    expectNear(texture.pixel(0, 0), {1, 0, 0});
    expectNear(texture.lookup({0.5f, 0.25f}), {1, 0, 0});
    expectNear(texture.lookup({0.5f, 0.75f}), {0, 0, 1});
}

TEST(Texture, GrayAndAlpha) {
    const TempFolder folder;
    const auto gray = writePicture<uint8_t>(folder, "gray.png", 1, 1, 1, {51});
    expectNear(readTexture(gray, Encoding::linear).pixel(0, 0), Float3(0.2f));
    const auto alpha = writePicture<uint8_t>(folder, "alpha.png", 1, 1, 4, {51, 102, 153, 255});
    expectNear(readTexture(alpha, Encoding::linear).pixel(0, 0), {0.2f, 0.4f, 0.6f});
}

// Two pixels in the PNG formats that need work: what is stored must come out, also where it is
// transparent.
TEST(Texture, PalettesGraysAndSixteenBits) {
    struct Case {
        const char* hex; ///< the file
        Float3 left, right;
        float leftAlpha, rightAlpha;
    };
    const Float3 color{0.2f, 0.4f, 0.6f}, other{1.0f, 0.0f, 0.2f};
    const Case cases[] = {
        // A palette of two colors, with alpha, and in one bit a pixel.
        {"89504e470d0a1a0a0000000d4948445200000002000000010803000000c3fc8fb800000006504c5445336699f"
         "f"
         "0033f0fbb5f40000000274524e5300809b2b4e180000000b49444154789c636060040000040002bf7a3f4a000"
         "0"
         "000049454e44ae426082",
         color, other, 0.0f, 128 / 255.0f},
        {"89504e470d0a1a0a0000000d4948445200000002000000010103000000ceecedc900000006504c5445336699f"
         "f"
         "0033f0fbb5f40000000a49444154789c63700000004200412937f4ef0000000049454e44ae426082",
         color, other, 1.0f, 1.0f},
        // Gray and alpha of 16 bits.
        {"89504e470d0a1a0a0000000d49484452000000020000000110040000000ebb6b420000001149444154789c633"
         "0"
         "3666603873a6810100099a027f624fc4270000000049454e44ae426082",
         Float3(0.2f), Float3(0.8f), 0.0f, 32768 / 65535.0f}};
    for (const auto& [hex, left, right, leftAlpha, rightAlpha] : cases) {
        std::vector<unsigned char> bytes;
        for (std::size_t i = 0; hex[i] != '\0'; i += 2)
            bytes.push_back(
                static_cast<unsigned char>(std::stoi(std::string(hex + i, 2), nullptr, 16)));
        const Texture texture = readTexture(bytes, "png", Encoding::linear);
        expectNear(texture.pixel(0, 0), left);
        expectNear(texture.pixel(1, 0), right);
        const Texture alpha = readTexture(bytes, "png", Encoding::linear, Channels::alpha);
        expectNear(alpha.pixel(0, 0), Float3(leftAlpha));
        expectNear(alpha.pixel(1, 0), Float3(rightAlpha));
    }
}

TEST(Texture, CoverageIsAlphaOrElseGray) {
    const TempFolder folder;
    const auto read = [](const std::string& path) {
        return readTexture(path, Encoding::sRgb, Channels::alphaOrGray).pixel(0, 0);
    };
    expectNear(read(writePicture<uint8_t>(folder, "a.png", 1, 1, 4, {255, 255, 255, 51})),
               Float3(0.2f));
    expectNear(read(writePicture<uint8_t>(folder, "g.png", 1, 1, 1, {51})), Float3(0.2f));
    // ITU-R BT.709-6, item 3.2.
    expectNear(read(writePicture<uint8_t>(folder, "c.png", 1, 1, 3, {0, 255, 0})), Float3(0.7152f));
}

// Of floats, "sRGB" says nothing: they are linear.
TEST(Texture, FloatsAreLinearAndMadeUsable) {
    const TempFolder folder;
    const auto path =
        writePicture<float>(folder, "a.exr", 2, 1, 3, {0.5f, 7.0f, -1.0f, 1.0f, 2.0f, 1e30f});
    ReplacedPixels replaced;
    const Texture texture = readTexture(path, Encoding::sRgb, Channels::colors, &replaced);
    EXPECT_EQ(replaced.outOfRange, 2u);
    EXPECT_EQ(replaced.notFinite, 0u);
    expectNear(texture.pixel(0, 0), {0.5f, 7.0f, 0.0f});
    expectNear(texture.pixel(1, 0), {1, 2, 1e9f});
}

// A sun too bright for the numbers of its file must stay the brightest of the picture.
TEST(Texture, InfinitiesBecomeTheLargestFiniteValue) {
    const TempFolder folder;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const auto path = writePicture<float>(
        folder, "a.exr", 4, 1, 3,
        {0.5f, 7.0f, 1.0f, nan, infinity, 3.0f, nan, nan, nan, -infinity, 0.0f, 0.0f});
    ReplacedPixels replaced;
    const Texture texture = readTexture(path, Encoding::linear, Channels::colors, &replaced);
    EXPECT_EQ(replaced.notFinite, 3u);
    EXPECT_EQ(replaced.outOfRange, 0u);
    EXPECT_EQ(replaced.largestFinite, 7.0f);
    expectNear(texture.pixel(0, 0), {0.5f, 7, 1});
    expectNear(texture.pixel(1, 0), {7, 7, 3});
    expectNear(texture.pixel(2, 0), {7, 7, 7});
    expectNear(texture.pixel(3, 0), {0, 0, 0});
}

TEST(Texture, FromMemory) {
    const TempFolder folder;
    const auto path = writePicture<uint8_t>(folder, "a.png", 1, 1, 3, {255, 0, 51});
    const std::string bytes = bytesOf(path);
    const std::vector<unsigned char> memory(bytes.begin(), bytes.end());
    expectNear(readTexture(memory, "png", Encoding::linear).pixel(0, 0), {1, 0, 0.2f});
    expectNear(readTexture(memory, "jpg", Encoding::linear).pixel(0, 0), {1, 0, 0.2f});
    EXPECT_THROW(readTexture({}, "png", Encoding::linear), std::runtime_error);
}

TEST(Texture, BilinearAndRepeating) {
    const Texture texture(2, 2, {Float3(0.0f), Float3(1.0f), Float3(2.0f), Float3(3.0f)});
    expectNear(texture.lookup({0.25f, 0.25f}), Float3(0.0f));
    expectNear(texture.lookup({0.5f, 0.25f}), Float3(0.5f));
    expectNear(texture.lookup({0.5f, 0.5f}), Float3(1.5f));
    expectNear(texture.lookup({0, 0.25f}), Float3(0.5f)); // across the border
    expectNear(texture.lookup({0, 0}), Float3(1.5f));
    for (const float shift : {-3.0f, 1.0f, 1000.0f})
        expectNear(texture.lookup({0.3f + shift, 0.6f - shift}), texture.lookup({0.3f, 0.6f}),
                   1e-3f);
    for (const float far : {-1e-12f, 1e30f, -1e30f, std::nextafter(1.0f, 0.0f)}) {
        const Float3 color = texture.lookup({far, far});
        EXPECT_TRUE(color.x >= 0.0f && color.x <= 3.0f);
    }
}

TEST(Texture, WrongSizesThrow) {
    EXPECT_THROW(Texture(0, 0, {}), std::invalid_argument);
    EXPECT_THROW(Texture(2, 2, std::vector<Float3>(3, Float3(0.0f))), std::invalid_argument);
}

std::string pictureErrorOf(const std::string& path) {
    try {
        readTexture(path, Encoding::linear);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "none";
}

TEST(Texture, WhatIsNoPictureSaysSoInOneLine) {
    const TempFolder folder;
    const auto good =
        writePicture<uint8_t>(folder, "good.png", 64, 64, 3, std::vector<uint8_t>(64 * 64 * 3, 77));
    const std::string bytes = bytesOf(good);
    for (const auto& path :
         {folder.path("missing.png"), folder.write("empty.png", ""),
          folder.write("text.png", "not a picture"), folder.write("unknown.xyz", bytes.substr(9)),
          folder.write("short.png", bytes.substr(0, bytes.size() / 2))}) {
        const std::string error = pictureErrorOf(path);
        EXPECT_NE(error, "none") << path;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        EXPECT_GT(error.size(), 5u) << path;
    }
}

// A picture of black and white, a row larger than what is read.
TEST(Texture, TooManyPixelsAreRefused) {
    const TempFolder folder;
    const std::string path = folder.write("large.pbm", "P4\n16384 8193\n");
    std::filesystem::resize_file(path, std::filesystem::file_size(path) + 16384 / 8 * 8193);
    EXPECT_EQ(pictureErrorOf(path), "has 16384 x 8193 pixels, more than 2^27");
}

} // namespace
} // namespace wellstrat::render
