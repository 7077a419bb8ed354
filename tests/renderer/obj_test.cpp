// SPDX-License-Identifier: Apache-2.0
//
// OBJ files, and other formats without materials.

#include "obj_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>

namespace wellstrat::render {
namespace {

constexpr auto kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(Obj, PolygonsBecomeTriangles) {
    const TempFolder folder;
    const Scene scene = readSquareObj(folder, "Kd 0.1 0.2 0.3\n");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].triangles.size(), 2u);
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, {0.1f, 0.2f, 0.3f});
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_EQ(material.specularF0, 0.0f);
}

TEST(Obj, EmissiveMaterialsAreLights) {
    const TempFolder folder;
    const Scene scene = readSquareObj(folder, "Kd 0 0 0\nKe 10 20 30\n");
    expectNear(scene.materials[scene.meshes[0].material].emission, {10, 20, 30});
    EXPECT_FALSE(scene.environment);
}

// MTL cannot say it, and the winding of OBJ files is often the other one.
TEST(Obj, MaterialsEmitOnBothSides) {
    const TempFolder folder;
    const Scene scene = readSquareObj(folder, "Kd 0 0 0\nKe 10 20 30\n");
    EXPECT_TRUE(scene.materials[scene.meshes[0].material].doubleSided);
}

// Walter et al. 2007: alpha = sqrt(2 / (n + 2)); the roughness is its root.
TEST(Obj, PhongExponents) {
    const TempFolder folder;
    const Scene scene = readSquareObj(folder, "Kd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nNs 198\n");
    const Material& material = scene.materials[scene.meshes[0].material];
    EXPECT_NEAR(material.roughness, std::sqrt(0.1f), 1e-5f);
    EXPECT_NEAR(material.specularF0, 0.04f, 1e-6f);
}

TEST(Obj, OnlySpecularIsMetal) {
    const TempFolder folder;
    const Scene scene = readSquareObj(folder, "Kd 0 0 0\nKs 0.9 0.6 0.3\nNs 1000\n");
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, {0.9f, 0.6f, 0.3f});
    EXPECT_EQ(material.metallic, 1.0f);
}

TEST(Obj, TexturesStandUpright) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("pictures"));
    writeColors(folder, "pictures/colors.png");
    const Scene scene = readSquareObj(folder, "Kd 1 1 1\nmap_Kd pictures\\colors.png\n");
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_TRUE(scene.materials[mesh.material].baseColorTexture) << scene.notes.at(0);
    expectNear(textureAt(scene, mesh, {0, 1, 0}), {1, 0, 0});
    expectNear(textureAt(scene, mesh, {1, 1, 0}), {0, 1, 0});
    expectNear(textureAt(scene, mesh, {0, 0, 0}), {0, 0, 1});
}

TEST(Obj, MissingLibrariesAndMaterialsAreSaid) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.obj", kSquareObj));
    expectNear(scene.materials[scene.meshes.at(0).material].baseColor, Float3(0.8f));
    EXPECT_TRUE(hasNote(scene, "The material library 'scene.mtl' is left out: no such file."));
    EXPECT_TRUE(hasNote(scene, "Materials that no library has are light gray: 'first'."));
    folder.write("scene.mtl", "newmtl second\n");
    EXPECT_TRUE(hasNote(readScene(folder.path("scene.obj")), "light gray: 'first'."));
}

/// The color of what "f" statements draw, with two materials in each of two libraries.
Float3 colorOf(const std::string& obj) {
    const TempFolder folder;
    folder.write("one.mtl", "newmtl a\nKd 1 0 0\nnewmtl b c\nKd 0 1 0\n");
    folder.write("two more.mtl", "newmtl a\nKd 0 0 0\nnewmtl d#1\nKd 0 0 1 # blue\n");
    const Scene scene = readScene(folder.write("scene.obj", obj + kTriangle));
    EXPECT_EQ(scene.notes.size(), 1u) << obj << scene.notes.at(0); // no camera
    return scene.materials[scene.meshes.at(0).material].baseColor;
}

TEST(Obj, AnyNumberOfLibraries) {
    for (const char* const libraries :
         {"mtllib one.mtl two more.mtl\n", "mtllib two more.mtl\nmtllib one.mtl\n"})
        expectNear(colorOf(libraries + std::string("usemtl d#1\n")), {0, 0, 1});
    expectNear(colorOf("mtllib one.mtl two more.mtl\nusemtl a\n"), {1, 0, 0}); // the first has it
    expectNear(colorOf("usemtl a\nmtllib one.mtl\n"), {1, 0, 0});
}

TEST(Obj, NamesOfMaterialsHaveBlanks) {
    expectNear(colorOf("mtllib one.mtl # comment\nusemtl b c # comment\n"), {0, 1, 0});
}

TEST(Obj, ByteOrderMarksAreNoText) {
    expectNear(colorOf("\xef\xbb\xbfmtllib one.mtl\nusemtl a\n"), {1, 0, 0});
}

Mesh meshOf(const std::string& obj) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.obj", obj));
    EXPECT_EQ(scene.meshes.size(), 1u);
    return scene.meshes.at(0);
}

TEST(Obj, FacesInAllSpellings) {
    const std::pair<const char*, bool> faces[] = {
        {"f 1 2 3", false},           {"f 1/1 2/2 3/3", false},
        {"f 1//1 2//1 3//1", true},   {"f 1/1/1 2/2/1 3/3/1", true},
        {"f 1/ 2/ 3/", false},        {"f 1// 2// 3//", false},
        {"f -3 -2 -1", false},        {"f -3/-3/-1 -2/-2/-1 -1/-1/-1", true},
        {"f 1 2 3 # comment", false}, {"f 1 2 \\\n3", false},
        {"\tf\t1\t2\t3  \r", false},  {"fo 1 2 3", false},
        {"f 1 2 3 # no \\", false}};
    for (const auto& [face, hasNormals] : faces) {
        const Mesh mesh = meshOf(std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                                             "vn 0 0 2\n") +
                                 face);
        ASSERT_EQ(mesh.positions.size(), 3u) << face;
        expectNear(mesh.positions[1], {1, 0, 0});
        EXPECT_EQ(mesh.triangles[0], (std::array<uint32_t, 3>{0, 1, 2})) << face;
        EXPECT_EQ(mesh.normals.size(), hasNormals ? 3u : 0u) << face;
    }
}

TEST(Obj, VerticesMayFollowTheirFaces) {
    EXPECT_EQ(meshOf(std::string("f 1 2 3\n") + "v 0 0 0\nv 1 0 0\nv 0 1 0\n").positions.size(),
              3u);
}

TEST(Obj, CornersThatAreEqualAreOneVertex) {
    const Mesh mesh = meshOf(kSquareObj);
    EXPECT_EQ(mesh.positions.size(), 4u);
    EXPECT_EQ(mesh.uvs.size(), 4u);
    EXPECT_EQ(meshOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 1\n"
                     "f 1/1 2/1 3/1\nf 1/1 3/2 4/2\n")
                  .positions.size(),
              5u);
}

// Faces without normals are flat, whatever their neighbors have.
TEST(Obj, FacesWithAndWithoutNormals) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write(
        "scene.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nvn 0 0 1\nf 1//1 2//1 3//1\nf 1 3 4\n"));
    ASSERT_EQ(scene.meshes.size(), 2u);
    EXPECT_EQ(scene.meshes[0].normals.size(), 3u);
    EXPECT_TRUE(scene.meshes[1].normals.empty());
}

// IEC 61966-2-1: ((0.5 + 0.055) / 1.055)^2.4
TEST(Obj, ColorsOfVertices) {
    const TempFolder folder;
    const Scene scene =
        readScene(folder.write("scene.obj", "v 0 0 0 1 0.5 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\n"));
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.colors.size(), 3u);
    expectNear(mesh.colors[0].color, {1, 0.214041f, 0});
    expectNear(mesh.colors[1].color, {1, 1, 1});
    expectNear(mesh.colors[2].color, {0, 0, 1});
    EXPECT_EQ(mesh.colors[0].opacity, 1.0f);
    expectNear(scene.materials[mesh.material].baseColor, Float3(1.0f));
}

TEST(Obj, WrongIndicesLoseTheirTriangleOnly) {
    const TempFolder folder;
    const Scene scene = readScene(
        folder.write("scene.obj",
                     "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\nf 0 1 2\nf -9 1 2\nf a b c\n"
                     "f 1 2 99999999999999999999\nf 1/9/9 2/9/9 3/9/9\n"));
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 2u);
    EXPECT_TRUE(hasNote(scene, "Left out: 5 triangles with a corner that is no number"));
}

TEST(Obj, CurvesAreSaid) {
    const TempFolder folder;
    const Scene scene =
        readScene(folder.write("scene.obj", std::string(kTriangle) + "curv 0 1 1 2\n"));
    EXPECT_TRUE(hasNote(scene, "Curves and curved surfaces are left out."));
}

TEST(Obj, DropsWhatCannotBeRendered) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.obj", R"(v 0 0 0
v 1 0 0
v 0 1 0
v nan 0 0
v 1e30 0 0
v 0.5 0 0
f 1 2 3
f 1 2 4
f 1 2 5
f 1 6 2
f 1 1 2
l 1 2
p 1
)"));
    uint64_t triangles = 0;
    for (const Mesh& mesh : scene.meshes) {
        triangles += mesh.triangles.size();
        for (const Float3& p : mesh.positions) EXPECT_LE(std::abs(p.x), 1.0f);
    }
    EXPECT_EQ(triangles, 1u);
    EXPECT_TRUE(hasNote(scene, "Left out: 1 triangles with a corner that is no number"));
    EXPECT_TRUE(hasNote(scene, "Left out: 1 triangles with a corner beyond 1e9"));
    EXPECT_TRUE(hasNote(scene, "Left out: 2 triangles without area"));
    EXPECT_TRUE(hasNote(scene, "Left out: 2 lines and points"));
}

TEST(Obj, BrokenNormalsBecomeThoseOfTheFace) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.obj", R"(v 0 0 0
v 1 0 0
v 0 1 0
vn 0 0 0
vn nan 0 1
vn 0 0 -5
f 1//1 2//2 3//3
)"));
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.normals.size(), 3u);
    expectNear(mesh.normals[0], {0, 0, 1});
    expectNear(mesh.normals[1], {0, 0, 1});
    expectNear(mesh.normals[2], {0, 0, -1});
}

TEST(Stl, IsRead) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.stl", R"(solid s
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 1 0
endloop
endfacet
endsolid s
)"));
    EXPECT_EQ(scene.meshes.at(0).triangles.size(), 1u);
}

} // namespace
} // namespace wellstrat::render
