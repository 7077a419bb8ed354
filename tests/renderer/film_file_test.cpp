// SPDX-License-Identifier: Apache-2.0
//
// Parts of films: put together, written and read back.

#include "renderer/film_file.h"
#include "renderer/picture_file.h"

#include "RixRNGInline.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace wellstrat::render {
namespace {

constexpr unsigned kWidth = 7, kHeight = 35; // more than two bands of 16 rows

using Settings = std::map<std::string, std::string>;

const Settings kSettings{{"generator", "pmj"}, {"scene", "0123456789abcdef"}, {"seed", "0"}};

/// Sample `i` of a pixel of the test's image.
Float3 sampleOf(unsigned x, unsigned y, unsigned i) {
    const unsigned pixel = y * kWidth + x;
    return {HashToRandom(pixel, 3 * i), 10 * HashToRandom(pixel, 3 * i + 1),
            i % 5 == 3 ? -1.0f / 0.0f : 1e-9f * HashToRandom(pixel, 3 * i + 2)};
}

/// The samples from `begin` to `end` of all pixels, or to `stop` of the first `stopped` ones.
FilmPart partOf(unsigned begin, unsigned end, unsigned stopped = 0, unsigned stop = 0) {
    Film film(kWidth, kHeight);
    for (unsigned y = 0; y < kHeight; ++y) {
        for (unsigned x = 0; x < kWidth; ++x) {
            const unsigned last = y * kWidth + x < stopped ? stop : end;
            for (unsigned i = begin; i < last; ++i) film.add(x, y, sampleOf(x, y, i));
        }
    }
    return makePart(std::move(film), begin, end, kSettings);
}

/// A file in the temporary directory, removed at the end.
class File {
public:
    explicit File(const std::string& bytes, const std::string& suffix = ".exr")
        : path_(testing::TempDir() + "wellstrat_film" +
                std::to_string(std::hash<std::thread::id>()(std::this_thread::get_id())) + "_" +
                testing::UnitTest::GetInstance()->current_test_info()->name() + suffix) {
        std::ofstream(path_, std::ios::binary) << bytes;
    }
    ~File() { std::remove(path_.c_str()); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    const std::string& path() const { return path_; }

private:
    std::string path_;
};

void expectEqual(const FilmPart& a, const FilmPart& b) {
    EXPECT_TRUE(a.film.pixels() == b.film.pixels());
    ASSERT_EQ(a.ranges.size(), b.ranges.size());
    for (std::size_t i = 0; i < a.ranges.size(); ++i) {
        EXPECT_EQ(a.ranges[i].begin, b.ranges[i].begin);
        EXPECT_EQ(a.ranges[i].end, b.ranges[i].end);
        EXPECT_EQ(a.ranges[i].counts, b.ranges[i].counts);
    }
    EXPECT_EQ(a.settings, b.settings);
    EXPECT_EQ(a.firstSample, b.firstSample);
}

TEST(FilmFile, GivesBackAllBits) {
    FilmPart part = partOf(3, 9);
    part.film.pixel(1, 2).color[1] = ~FixedSum{0} / 3; // words of all sums at work
    part.film.pixel(1, 2).square = ~FixedSum{0} / 7;
    part.firstSample = 2;
    const FilmPart read = readPart(File(encodePart(part)).path());
    expectEqual(read, part);
    EXPECT_EQ(read.ranges[0].begin, 3u);
    EXPECT_EQ(read.ranges[0].end, 9u);
    EXPECT_TRUE(read.ranges[0].counts.empty());
}

TEST(FilmFile, GivesBackUnfinishedRanges) {
    FilmPart part = partOf(0, 8, 100, 5);
    EXPECT_EQ(part.ranges[0].counts[99], 5u);
    EXPECT_EQ(part.ranges[0].counts[100], 8u);
    expectEqual(readPart(File(encodePart(part)).path()), part);
    addPart(part, partOf(10, 13, 50, 11));
    ASSERT_EQ(part.ranges.size(), 2u);
    expectEqual(readPart(File(encodePart(part)).path()), part);
}

/// Guards against dates in files, among others.
TEST(FilmFile, SameFilmGivesSameBytes) {
    const FilmPart part = partOf(0, 2);
    const std::string exact = encodePart(part), png = encodePicture(part.film, ".png"),
                      hdr = encodePicture(part.film, ".hdr"),
                      exr = encodePicture(part.film, ".exr");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    EXPECT_EQ(encodePart(part), exact);
    EXPECT_EQ(encodePicture(part.film, ".png"), png);
    EXPECT_EQ(encodePicture(part.film, ".hdr"), hdr);
    EXPECT_EQ(encodePicture(part.film, ".exr"), exr);
}

TEST(FilmFile, ViewersSeeTheMeans) {
    const Film film = partOf(0, 3).film;
    for (const std::string& bytes : {encodePart(partOf(0, 3)), encodePicture(film, ".exr")}) {
        const File file(bytes);
        const auto input = OIIO::ImageInput::open(file.path());
        ASSERT_TRUE(input);
        ASSERT_EQ(input->spec().channelnames[0], "R");
        std::vector<float> colors(kWidth * kHeight * 3);
        ASSERT_TRUE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, colors.data()));
        const float* const pixel = &colors[(20 * kWidth + 6) * 3];
        EXPECT_EQ(Float3(pixel[0], pixel[1], pixel[2]), film.mean(6, 20));
    }
}

TEST(FilmFile, GivesBackWhatIsOpen) {
    FilmPart part = partOf(0, 8, 100, 5);
    part.film.pixel(1, 2).open = 3;
    const File file(encodePart(part));
    expectEqual(readPart(file.path()), part);
    const auto input = OIIO::ImageInput::open(file.path());
    ASSERT_TRUE(input);
    ASSERT_EQ(input->spec().channelnames[3], "A");
    std::vector<float> alpha(kWidth * kHeight);
    ASSERT_TRUE(input->read_image(0, 0, 3, 4, OIIO::TypeDesc::FLOAT, alpha.data()));
    EXPECT_EQ(alpha[2 * kWidth + 1], 0.4f);
    EXPECT_EQ(alpha[0], 1.0f);
    part.film.pixel(1, 2).open = 9;
    EXPECT_THROW(readPart(File(encodePart(part)).path()), std::runtime_error);
}

TEST(FilmFile, OtherFilesAreRefused) {
    const auto messageOf = [](const std::string& bytes) -> std::string {
        try {
            readPart(File(bytes).path());
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "read";
    };
    EXPECT_NE(messageOf(encodePicture(Film(2, 2), ".exr")).find("no exact sums"),
              std::string::npos);
    EXPECT_NE(messageOf("text"), "read");
    EXPECT_NE(messageOf(""), "read");
    EXPECT_THROW(readPart("no such file.exr"), std::runtime_error);
    const std::string bytes = encodePart(partOf(0, 4));
    for (const double share : {0.01, 0.3, 0.6, 0.99}) {
        const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
        EXPECT_NE(messageOf(bytes.substr(0, size)), "read") << share;
    }
    FilmPart wrong = partOf(0, 4);
    ++wrong.film.pixel(0, 0).count;
    EXPECT_NE(messageOf(encodePart(wrong)).find("damaged"), std::string::npos);
    wrong = partOf(0, 4);
    wrong.ranges[0] = {4, 4, {}};
    EXPECT_NE(messageOf(encodePart(wrong)).find("damaged"), std::string::npos);
    wrong = partOf(4, 8);
    wrong.firstSample = 5;
    EXPECT_NE(messageOf(encodePart(wrong)).find("its first sample"), std::string::npos);
}

/// Every byte of a small file changed: an error or a film, and never a crash.
TEST(FilmFile, DamageNeverCrashes) {
    Film film(2, 2);
    film.add(1, 1, Float3(1));
    const std::string bytes = encodePart(makePart(film, 0, 1, kSettings));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        std::string changed = bytes;
        changed[i] = static_cast<char>(changed[i] ^ (1 << i % 8));
        try {
            readPart(File(changed).path());
        } catch (const std::runtime_error&) {
            continue; // as it should
        }
    }
}

TEST(FilmPart, PartsInAnyOrderGiveTheWhole) {
    const FilmPart whole = partOf(0, 12);
    const std::vector<FilmPart> parts{partOf(0, 3), partOf(3, 4), partOf(4, 9), partOf(9, 12)};
    for (const auto& order :
         {std::array{0, 1, 2, 3}, std::array{3, 1, 0, 2}, std::array{2, 0, 3, 1}}) {
        FilmPart sum = parts[static_cast<std::size_t>(order[0])];
        for (const std::size_t i : {1u, 2u, 3u})
            addPart(sum, parts[static_cast<std::size_t>(order[i])]);
        expectEqual(sum, whole);
        EXPECT_EQ(encodePart(sum), encodePart(whole));
    }
}

TEST(FilmPart, UnfinishedRangesJoinWhatIsBeforeThem) {
    FilmPart part = partOf(2, 8, 30, 5);
    addPart(part, partOf(0, 2));
    expectEqual(part, partOf(0, 8, 30, 5));
}

TEST(FilmPart, SaysWhatIsMissing) {
    EXPECT_EQ(missingSamples(partOf(0, 4)), "");
    FilmPart part = partOf(2, 4);
    EXPECT_EQ(missingSamples(part), "samples 0:2");
    addPart(part, partOf(8, 12, 3, 9));
    EXPECT_EQ(missingSamples(part), "samples 0:2, samples 4:8, some samples of 9:12");
}

/// A frame lacks nothing of the frames before it, until it is added to one of them.
TEST(FilmPart, FramesBeginWhereTheyBegin) {
    FilmPart frame = partOf(12, 16), earlier = partOf(4, 7);
    frame.firstSample = 12;
    earlier.firstSample = 4;
    EXPECT_EQ(missingSamples(frame), "");
    frame.firstSample = 8;
    EXPECT_EQ(missingSamples(frame), "samples 8:12");
    for (const auto& [a, b] : {std::pair(frame, earlier), std::pair(earlier, frame)}) {
        FilmPart sum = a;
        addPart(sum, b);
        EXPECT_EQ(sum.firstSample, 4u);
        EXPECT_EQ(missingSamples(sum), "samples 7:12");
    }
}

TEST(FilmPart, WhatDoesNotBelongTogetherIsRefused) {
    const auto messageOf = [](const FilmPart& a, const FilmPart& b) -> std::string {
        FilmPart sum = a;
        try {
            addPart(sum, b);
        } catch (const std::invalid_argument& error) {
            expectEqual(sum, a);
            return error.what();
        }
        return "added";
    };
    const FilmPart part = partOf(4, 8);
    EXPECT_EQ(messageOf(part, part), "both have samples 4:8");
    EXPECT_EQ(messageOf(part, partOf(7, 9)), "both have samples 7:8");
    EXPECT_EQ(messageOf(part, partOf(0, 5)), "both have samples 4:5");
    EXPECT_EQ(messageOf(part, partOf(0, 100, 10, 3)), "both have samples 4:8");
    FilmPart other = partOf(0, 4);
    other.settings["seed"] = "7";
    EXPECT_EQ(messageOf(part, other), "they differ in: seed (0, 7)");
    other = partOf(0, 4);
    other.settings["depth"] = "5";
    EXPECT_EQ(messageOf(part, other), "they differ in: depth (not given, 5)");
    EXPECT_EQ(messageOf(part, makePart(Film(3, 4), 0, 1, kSettings)),
              "one has 7x35 pixels, the other 3x4");
}

} // namespace
} // namespace wellstrat::render
