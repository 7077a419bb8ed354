// SPDX-License-Identifier: Apache-2.0
//
// OBJ files with MTL, and other formats without materials.

#include "scene_files.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>

namespace wellstrat::render {
namespace {

constexpr auto kObj = R"(mtllib scene.mtl
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl first
f 1/1 2/2 3/3 4/4
)";

Scene readObj(const TempFolder& folder, const std::string& material) {
    folder.write("scene.mtl", "newmtl first\n" + material);
    return readScene(folder.write("scene.obj", kObj));
}

TEST(Obj, PolygonsBecomeTriangles) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0.1 0.2 0.3\n");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].triangles.size(), 2u);
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, {0.1f, 0.2f, 0.3f});
    EXPECT_EQ(material.metallic, 0.0f);
    EXPECT_EQ(material.specularF0, 0.0f);
}

TEST(Obj, EmissiveMaterialsAreLights) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0 0 0\nKe 10 20 30\n");
    expectNear(scene.materials[scene.meshes[0].material].emission, {10, 20, 30});
    EXPECT_FALSE(scene.environment);
}

// MTL cannot say it, and the winding of OBJ files is often the other one.
TEST(Obj, MaterialsEmitOnBothSides) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0 0 0\nKe 10 20 30\n");
    EXPECT_TRUE(scene.materials[scene.meshes[0].material].doubleSided);
}

// Walter et al. 2007: alpha = sqrt(2 / (n + 2)); the roughness is its root.
TEST(Obj, PhongExponents) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0.5 0.5 0.5\nKs 0.5 0.5 0.5\nNs 198\n");
    const Material& material = scene.materials[scene.meshes[0].material];
    EXPECT_NEAR(material.roughness, std::sqrt(0.1f), 1e-5f);
    EXPECT_NEAR(material.specularF0, 0.04f, 1e-6f);
}

TEST(Obj, OnlySpecularIsMetal) {
    const TempFolder folder;
    const Scene scene = readObj(folder, "Kd 0 0 0\nKs 0.9 0.6 0.3\nNs 1000\n");
    const Material& material = scene.materials[scene.meshes[0].material];
    expectNear(material.baseColor, {0.9f, 0.6f, 0.3f});
    EXPECT_EQ(material.metallic, 1.0f);
}

TEST(Obj, TexturesStandUpright) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("pictures"));
    writeColors(folder, "pictures/colors.png");
    const Scene scene = readObj(folder, "Kd 1 1 1\nmap_Kd pictures\\colors.png\n");
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_TRUE(scene.materials[mesh.material].baseColorTexture) << scene.notes.at(0);
    expectNear(textureAt(scene, mesh, {0, 1, 0}), {1, 0, 0});
    expectNear(textureAt(scene, mesh, {1, 1, 0}), {0, 1, 0});
    expectNear(textureAt(scene, mesh, {0, 0, 0}), {0, 0, 1});
}

TEST(Obj, AMissingMaterialLibraryIsNoTrouble) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.obj", kObj));
    EXPECT_EQ(scene.meshes.size(), 1u);
    EXPECT_LT(scene.meshes[0].material, scene.materials.size());
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

TEST(Ply, IsRead) {
    const TempFolder folder;
    const Scene scene = readScene(folder.write("scene.ply", R"(ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
)"));
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(scene.meshes[0].triangles.size(), 1u);
    EXPECT_TRUE(scene.cameraIsAutomatic);
    EXPECT_TRUE(scene.environment);
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
