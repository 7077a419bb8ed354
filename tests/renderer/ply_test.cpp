// SPDX-License-Identifier: Apache-2.0
//
// PLY files in all their forms.

#include "scene_files.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <utility>

namespace wellstrat::render {
namespace {

Scene readPly(const std::string& bytes) {
    const TempFolder folder;
    return readScene(folder.write("scene.ply", bytes));
}

std::string headerOf(const std::string& format, const std::string& elements) {
    return "ply\nformat " + format + " 1.0\n" + elements + "end_header\n";
}

constexpr auto kVertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
constexpr auto kFace = "element face 1\nproperty list uchar int vertex_indices\n";
constexpr auto kValues = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

/// An ASCII file.
std::string ply(const std::string& elements, const std::string& values) {
    return headerOf("ascii", elements) + values;
}

void expectTriangle(const Scene& scene) {
    ASSERT_EQ(scene.meshes.size(), 1u);
    const Mesh& mesh = scene.meshes[0];
    ASSERT_EQ(mesh.triangles.size(), 1u);
    const auto [a, b, c] = mesh.triangles[0];
    expectNear(mesh.positions[a], {0, 0, 0});
    expectNear(mesh.positions[b], {1, 0, 0});
    expectNear(mesh.positions[c], {0, 1, 0});
}

TEST(Ply, IsRead) {
    const Scene scene = readPly(ply(std::string(kVertices) + kFace, kValues));
    expectTriangle(scene);
    EXPECT_TRUE(scene.cameraIsAutomatic);
    EXPECT_FALSE(scene.environment); // tools add light to what has none
}

TEST(Ply, EndsOfLinesAndComments) {
    std::string text = "ply\ncomment made by hand\nobj_info 3 things\nformat ascii 1.0\n" +
                       std::string(kVertices) + "comment\n" + kFace + "end_header\n" + kValues;
    expectTriangle(readPly(text));
    for (const char* const end : {"\r\n", "\r"}) {
        std::string other;
        for (const char c : text) other += c == '\n' ? std::string(end) : std::string(1, c);
        expectTriangle(readPly(other));
    }
}

/// Appends a number as binary files have it.
template <typename T>
void put(std::string& bytes, double number, bool isBig) {
    const T value = static_cast<T>(number);
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    if (isBig) std::reverse(raw, raw + sizeof raw); // this machine is little-endian
    bytes.append(raw, sizeof raw);
}

template <typename T>
void expectBinary(const std::string& type, bool isBig) {
    const std::string format = isBig ? "binary_big_endian" : "binary_little_endian";
    std::string elements = "element vertex 3\n";
    for (const char* const name : {"x", "unused", "y", "z"})
        elements += "property " + type + " " + name + "\n";
    elements += "element face 1\nproperty list uchar " + type + " unused\nproperty list " + type +
                " " + type + " vertex_index\n";
    std::string bytes = headerOf(format, elements);
    for (const double number : {0, 10, 0, 0, 1, 10, 0, 0, 0, 10, 1, 0})
        put<T>(bytes, number, isBig);
    put<uint8_t>(bytes, 2, isBig);
    for (const double number : {5, 13, 3, 0, 1, 2}) put<T>(bytes, number, isBig);
    expectTriangle(readPly(bytes));
}

// 13 and 10 are the ends of lines.
TEST(Ply, BinaryInBothOrdersAndAllTypes) {
    for (const bool isBig : {false, true}) {
        for (const char* const name : {"char", "int8"}) expectBinary<int8_t>(name, isBig);
        for (const char* const name : {"uchar", "uint8"}) expectBinary<uint8_t>(name, isBig);
        for (const char* const name : {"short", "int16"}) expectBinary<int16_t>(name, isBig);
        for (const char* const name : {"ushort", "uint16"}) expectBinary<uint16_t>(name, isBig);
        for (const char* const name : {"int", "int32"}) expectBinary<int32_t>(name, isBig);
        for (const char* const name : {"uint", "uint32"}) expectBinary<uint32_t>(name, isBig);
        for (const char* const name : {"float", "float32"}) expectBinary<float>(name, isBig);
        for (const char* const name : {"double", "float64"}) expectBinary<double>(name, isBig);
    }
}

// With \r\n behind the header, or \n alone, and values that begin with the other.
TEST(Ply, BinaryValuesBeginWithEndsOfLines) {
    const std::string elements =
        "element start 1\nproperty uchar first\n" + std::string(kVertices) + kFace;
    for (const char first : {'\n', '\r', ' '}) {
        std::string bytes = headerOf("binary_little_endian", elements) + first;
        append<float>(bytes, {0, 0, 0, 1, 0, 0, 0, 1, 0});
        bytes += '\3';
        append<int32_t>(bytes, {0, 1, 2});
        expectTriangle(readPly(bytes));
        const std::size_t end = bytes.find("end_header\n") + 11;
        std::string windows;
        for (const char c : bytes.substr(0, end))
            windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
        expectTriangle(readPly(windows + bytes.substr(end)));
    }
}

TEST(Ply, OtherElementsAreSkipped) {
    const Scene scene = readPly(ply(
        "element camera 1\nproperty list int float lens\nproperty double focus\n" +
            std::string(kVertices) + "property list uchar uchar tags\nproperty char flag\n" +
            "element material 2\nproperty uchar a\nelement nothing 18446744073709551615\n" + kFace +
            "property float quality\nelement edge 2\nproperty int vertex1\nproperty int vertex2\n",
        "2 1.5 2.5 9\n0 0 0 0 1\n1 0 0 2 7 7 1\n0 1 0 1 7 1\n5 6\n3 0 1 2 0.5\n0 1\n1 2\n"));
    expectTriangle(scene);
    EXPECT_TRUE(hasNote(scene, "Left out: 2 lines and points"));
}

TEST(Ply, FacesMayComeFirst) {
    expectTriangle(readPly(ply(std::string(kFace) + kVertices, "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n")));
}

TEST(Ply, PolygonsOfAnySize) {
    const Scene scene =
        readPly(ply("element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                    "element face 3\nproperty list uchar int vertex_indices\n",
                    "0 0 0\n2 -1 0\n0.2 0 0\n2 1 0\n3 0 0\n4 0 1 2 3\n2 0 1\n5 0 1 4 3 2\n"));
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 5u);
    EXPECT_TRUE(hasNote(scene, "Left out: 1 lines and points"));
}

TEST(Ply, Strips) {
    const Scene scene =
        readPly(ply("element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                    "element tristrips 1\nproperty list int int vertex_indices\n",
                    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n11 0 1 2 3 -1 1 3 2 -1 0 1\n"));
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 3u);
    for (uint32_t i = 0; i < 3; ++i) { // all face +z
        const auto [a, b, c] = mesh.triangles[i];
        EXPECT_GT(
            Cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]).z,
            0.0f);
    }
    EXPECT_EQ(scene.notes.size(), 1u); // no camera
}

// Two equal corners are how strips go on elsewhere.
TEST(Ply, StripsGoOnByTrianglesWithoutArea) {
    const Scene scene =
        readPly(ply("element vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                    "element tristrips 1\nproperty list int int vertex_indices\n",
                    "0 0 0\n1 0 0\n0 1 0\n5 0 0\n6 0 0\n5 1 0\n8 0 1 2 2 3 3 4 5\n"));
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ(scene.notes.size(), 1u);
}

// IEC 61966-2-1 for integers: 188 / 255 is 0.502886.
TEST(Ply, ColorsOfVertices) {
    const auto colors = [](const std::string& type, const std::string& values) {
        const Scene scene = readPly(
            ply(std::string(kVertices) + "property " + type + " red\nproperty " + type +
                    " green\nproperty " + type + " blue\nproperty " + type + " alpha\n" + kFace,
                "0 0 0 " + values + "\n1 0 0 " + values + "\n0 1 0 " + values + "\n3 0 1 2\n"));
        expectNear(scene.materials[scene.meshes.at(0).material].baseColor, Float3(1.0f));
        EXPECT_EQ(scene.materials[0].alpha, Material::Alpha::opaque);
        EXPECT_EQ(scene.meshes[0].colors.at(0).opacity, 1.0f);
        return scene.meshes[0].colors.at(0).color;
    };
    expectNear(colors("uchar", "255 188 0 7"), {1, 0.502886f, 0});
    expectNear(colors("ushort", "65535 48316 0 7"), {1, 0.502886f, 0});
    expectNear(colors("float", "1 0.5 0 0.1"), {1, 0.5f, 0});
}

TEST(Ply, Normals) {
    const Scene scene =
        readPly(ply(std::string(kVertices) +
                        "property float nx\nproperty float ny\nproperty float nz\n" + kFace,
                    "0 0 0 0 0 2\n1 0 0 0 0.6 0.8\n0 1 0 nan 0 0\n3 0 1 2\n"));
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.normals.size(), 3u);
    expectNear(mesh.normals[0], {0, 0, 1});
    expectNear(mesh.normals[1], {0, 0.6f, 0.8f});
    expectNear(mesh.normals[2], {0, 0, 1});
}

TEST(Ply, NamesOfTextureCoordinates) {
    for (const auto& [u, v] :
         {std::pair("u", "v"), std::pair("s", "t"), std::pair("texture_u", "texture_v"),
          std::pair("texture_s", "texture_t")}) {
        const TempFolder folder;
        writeColors(folder, "colors.png");
        const std::string properties =
            std::string("property float ") + u + "\nproperty float " + v + "\n";
        const Scene scene =
            readScene(folder.write("scene.ply", ply("comment TextureFile colors.png\n" +
                                                        std::string(kVertices) + properties + kFace,
                                                    "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n")));
        const Mesh& mesh = scene.meshes.at(0);
        expectNear(textureAt(scene, mesh, {0, 0, 0}), {0, 0, 1});
        expectNear(textureAt(scene, mesh, {1, 0, 0}), {1, 1, 1});
        expectNear(textureAt(scene, mesh, {0, 1, 0}), {1, 0, 0});
    }
}

TEST(Ply, TextureCoordinatesOfCorners) {
    const Scene scene =
        readPly(ply("element vertex 4\nproperty float x\nproperty float y\n"
                    "property float z\nelement face 2\n"
                    "property list uchar int vertex_indices\n"
                    "property list uchar float texcoord\n",
                    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 6 0 0 1 0 1 1\n"
                    "3 0 2 3 6 0.5 0.5 0.25 0.75 0 1\n"));
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.uvs.size(), 6u);
    EXPECT_EQ(mesh.uvs[0], Float2(0, 1));
    EXPECT_EQ(mesh.uvs[3], Float2(0.5f, 0.5f));
    EXPECT_EQ(mesh.uvs[4], Float2(0.25f, 0.25f));
    expectNear(mesh.positions[4], {1, 1, 0});
}

TEST(Ply, WrongIndicesLoseTheirTriangleOnly) {
    const Scene scene = readPly(
        ply(std::string(kVertices) + "element face 5\nproperty list uchar int vertex_indices\n",
            std::string(kValues) + "3 0 1 3\n3 0 1 -1\n3 0 x 2\n4 0 1 2 9\n"));
    EXPECT_TRUE(hasNote(scene, "triangles with a corner that is no number"));
    EXPECT_FALSE(scene.meshes.at(0).triangles.empty());
}

TEST(Ply, WhatIsWrongIsSaid) {
    const auto reason = [](const std::string& bytes) {
        const TempFolder folder;
        const std::string error = errorOf(folder.write("scene.ply", bytes));
        return error.substr(std::min(error.find(": ") + 2, error.size()));
    };
    const std::string elements = std::string(kVertices) + kFace;
    EXPECT_EQ(reason("play\n"), "it does not begin with a line 'ply'");
    EXPECT_EQ(reason("ply\nformat ascii 1.0\n"), "its header has no end");
    EXPECT_EQ(reason("ply\nend_header\n"), "its header has no format");
    EXPECT_EQ(reason("ply\nformat text 1.0\nend_header\n"),
              "its header has the unknown format 'text'");
    EXPECT_EQ(reason(ply("element vertex x\n", "")), "its header has the count 'x'");
    EXPECT_EQ(reason(ply("element vertex 1\nproperty half x\n", "")),
              "its header has the unknown type 'half'");
    EXPECT_EQ(reason(ply("property float x\n", "")), "its header has a line 'property float x'");
    EXPECT_EQ(reason(ply(elements, "0 0 0\n1 0 0\n0 1 0\n3 0 1\n")),
              "it ends before its last value");
    EXPECT_EQ(reason(ply("element vertex 99999999999999\nproperty float x\n", "1 2 3")),
              "it ends before its last value");
    EXPECT_EQ(reason(ply(elements, "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n")),
              "it has a list of length -3");
    EXPECT_EQ(reason(ply(kVertices, "0 0 0\n1 0 0\n0 1 0\n")),
              "there are no triangles to render in it, only 3 lines and points");
}

} // namespace
} // namespace wellstrat::render
