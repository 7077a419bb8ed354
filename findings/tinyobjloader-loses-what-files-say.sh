#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# What tinyobjloader 2.0.0~rc10 (Debian 12) makes of valid OBJ and MTL, without an error:
#
#     map_Kd -s 2 2 a.png: a material without picture (the third number, which may be left out, takes it)
#     map_Kd -o 0.5 -clamp on a.png: a picture that is not clamped
#     mtllib one.mtl two.mtl: the first alone
#     v nan 0 0: the point (0, 0, 0)
#     Kd 0.5: red, where one number is that of all channels
#
# Needs g++.
#
# Expected: options count and leave the name of the picture, all libraries are read, NaN stays NaN.
# Found: as above; only a missing material is a warning.
# Versions: libtinyobjloader-dev 2.0.0~rc10+dfsg-2+b1.
# Source: Debian 12; "MTL material format" and "Object Files (.obj)", http://paulbourke.net/dataformats/.
# Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch libtinyobjloader-dev=2.0.0~rc10+dfsg-2+b1 libtinyobjloader2rc10=2.0.0~rc10+dfsg-2+b1
cat > one.mtl << 'END'
newmtl scaled
map_Kd -s 2 2 a.png
newmtl clamped
map_Kd -o 0.5 -clamp on a.png
newmtl gray
Kd 0.5
END
printf 'newmtl other\nKd 1 0 0\n' > two.mtl
printf 'mtllib one.mtl two.mtl\nv nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' > scene.obj

cat > main.cpp << 'END'
#include <tiny_obj_loader.h>
#include <cstdio>
int main() {
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    const bool ok =
        tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, "scene.obj", "./");
    std::printf("read: %d, warnings: '%s', errors: '%s'\n", ok, warning.c_str(), error.c_str());
    std::printf("materials: %zu of 4\n", materials.size());
    if (!ok || materials.size() != 3) return 1;
    const tinyobj::material_t &scaled = materials[0], &clamped = materials[1], &gray = materials[2];
    std::printf("scaled: picture '%s'\n", scaled.diffuse_texname.c_str());
    std::printf("clamped: picture '%s', clamped %d\n", clamped.diffuse_texname.c_str(),
                clamped.diffuse_texopt.clamp);
    std::printf("gray: %g %g %g\n", gray.diffuse[0], gray.diffuse[1], gray.diffuse[2]);
    std::printf("first point: %g %g %g\n", attributes.vertices[0], attributes.vertices[1],
                attributes.vertices[2]);
    return scaled.diffuse_texname.empty() && !clamped.diffuse_texopt.clamp &&
                   gray.diffuse[1] == 0.0f && attributes.vertices[0] == 0.0f
               ? 0
               : 1;
}
END
compile -ltinyobjloader
./main || changed "as printed above"
echo "as found"
