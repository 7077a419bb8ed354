// SPDX-License-Identifier: Apache-2.0
//
// Films as pictures for the eye.

#include "renderer/picture_file.h"

#include "renderer/color.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace wellstrat::render {
namespace {

using Bytes = std::vector<unsigned char>;

/// The pixels of a picture, of all its channels.
template <typename T>
std::vector<T> decoded(const std::string& bytes, const std::string& suffix) {
    OIIO::ImageSpec config;
    config["oiio:UnassociatedAlpha"] = 1;
    const std::string path = testing::TempDir() + "wellstrat_" +
                             testing::UnitTest::GetInstance()->current_test_info()->name() + suffix;
    std::ofstream(path, std::ios::binary) << bytes;
    const auto input = OIIO::ImageInput::open(path, &config);
    std::remove(path.c_str());
    if (!input) throw std::runtime_error(OIIO::geterror());
    const OIIO::ImageSpec& spec = input->spec();
    std::vector<T> pixels(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    EXPECT_TRUE(input->read_image(0, 0, 0, spec.nchannels,
                                  OIIO::TypeDesc(OIIO::BaseTypeFromC<T>::value), pixels.data()));
    return pixels;
}

/// 0.5 of light is 187.5 of 255 in sRGB; above 1 is white.
TEST(PictureFile, PngIsSrgb) {
    Film film(2, 1);
    film.add(0, 0, {0, 0.5f, 0.002f});
    film.add(1, 0, {1, 2, 0.2f});
    EXPECT_EQ(decoded<unsigned char>(encodePicture(film, ".png"), ".png"),
              (Bytes{0, 188, 7, 255, 255, 124}));
}

TEST(PictureFile, JpegIsAboutTheSame) {
    Film film(16, 16);
    for (unsigned i = 0; i < 256; ++i) film.add(i % 16, i / 16, {0, 0.5f, 0.2f});
    for (const char* suffix : {".jpg", ".jpeg"}) {
        const Bytes pixels = decoded<unsigned char>(encodePicture(film, suffix), suffix);
        ASSERT_EQ(pixels.size(), 768u);
        EXPECT_NEAR(pixels[0], 0, 3);
        EXPECT_NEAR(pixels[1], 188, 3);
        EXPECT_NEAR(pixels[2], 124, 3);
    }
    EXPECT_THROW(encodePicture(film, ".gif"), std::runtime_error);
}

TEST(Display, ExposureIsInStops) {
    const Float3 light(0.1f, 0.4f, 0);
    EXPECT_EQ(displayed(light, {}), light);
    EXPECT_EQ(displayed(light, {1, false}), Float3(0.2f, 0.8f, 0));
    EXPECT_EQ(displayed(light, {-2, false}), Float3(0.025f, 0.1f, 0));
    EXPECT_EQ(displayed(light, {4, false}), Float3(1, 1, 0));
}

/// By the formula of its author, at numbers that were computed by hand; and it only grows.
TEST(Display, FilmicCurve) {
    const Display filmic{0, true};
    EXPECT_EQ(displayed(Float3(0.0f), filmic), Float3(0.0f));
    EXPECT_NEAR(displayed(Float3(1.0f), filmic).x, 0.9216f / 1.3688f, 1e-6f);
    EXPECT_NEAR(displayed({5, 1e20f, 0.1f}, filmic).x, 22.68f / 23.78f, 1e-6f);
    EXPECT_EQ(displayed({5, 1e20f, 0.1f}, filmic).y, 1.0f);
    float last = 0;
    for (float light = 0.01f; light < 20; light *= 1.3f) {
        const float shown = displayed(Float3(light), filmic).x;
        EXPECT_GT(shown, last);
        last = shown;
    }
    EXPECT_EQ(displayed(Float3(0.5f), {1, true}), displayed(Float3(1.0f), filmic));
}

/// A half of the samples is open: the color of the other half, and half of it where there is alpha
/// that colors are multiplied by.
TEST(PictureFile, Alpha) {
    Film film(2, 1);
    film.add(0, 0, {0.5f, 1, 0});
    film.add(0, 0, Float3(0.0f), true);
    film.add(1, 0, Float3(0.0f), true);
    EXPECT_TRUE(isTransparent(film));
    EXPECT_EQ(film.alpha(0, 0), 0.5f);
    EXPECT_EQ(decoded<unsigned char>(encodePicture(film, ".png"), ".png"),
              (Bytes{188, 255, 0, 128, 0, 0, 0, 0}));
    EXPECT_EQ(decoded<float>(encodePicture(film, ".exr", {3, true}), ".exr"),
              (std::vector<float>{0.25f, 0.5f, 0, 0.5f, 0, 0, 0, 0}));
    EXPECT_EQ(decoded<unsigned char>(encodePicture(film, ".jpg"), ".jpg").size(), 6u);
}

} // namespace
} // namespace wellstrat::render
