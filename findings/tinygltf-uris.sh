#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# What tinygltf 2.7.0 (Debian 12: 2.7.0+dfsg-2) refuses or finds among the buffers of valid glTF 2.0:
#
#     a+b.bin: refused (it looks for "a b.bin"; "+" is a plus in paths of URIs, RFC 3986)
#     data: URI without type: refused (it knows seven types)
#     data: URI with %2B for a plus: refused
#     a file in the working directory alone: found (relative URIs start from the glTF file)
#     indices without buffer view, which are zeros, and which KHR_draco_mesh_compression has: refused
#
# Needs g++ and what libtinygltf-dev depends on.
#
# Expected: valid URIs of buffers are read, and found beside the glTF file only.
# Found: some are refused, and files of the working directory are found.
# Versions: tinygltf 2.7.0+dfsg-2.
# Source: Debian 12; glTF 2.0, sections 2.8 and 3.6. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch libtinygltf-dev=2.7.0+dfsg-2 libtinygltf2d=2.7.0+dfsg-2
mkdir scene
printf 'abc' > scene/a+b.bin
printf 'abc' > elsewhere.bin

cat > main.cpp << 'END'
#include <tiny_gltf.h>
#include <cstdio>
#include <string>
bool reads(const char* what, const std::string& text) {
    tinygltf::Model model;
    std::string error, warning;
    const bool ok = tinygltf::TinyGLTF().LoadASCIIFromString(
        &model, &error, &warning, text.data(), static_cast<unsigned>(text.size()), "scene");
    std::printf("%s: %s\n", what, ok ? "read" : error.substr(0, error.find('\n')).c_str());
    return ok;
}
std::string buffer(const std::string& uri) {
    return R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 3, "uri": ")" + uri + "\"}]}";
}
int main() {
    bool asFound = !reads("a+b.bin", buffer("a+b.bin"));
    asFound &= !reads("data: without type", buffer("data:;base64,YWJj"));
    asFound &= reads("data: with type", buffer("data:application/octet-stream;base64,+/+/"));
    asFound &= !reads("data: with percent", buffer("data:application/octet-stream;base64,%2B/+/"));
    asFound &= reads("working directory", buffer("elsewhere.bin"));
    asFound &= !reads("indices without buffer view", R"({"asset": {"version": "2.0"},
        "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
        "accessors": [{"componentType": 5123, "count": 3, "type": "SCALAR"},
                      {"componentType": 5126, "count": 3, "type": "VEC3",
                       "min": [0, 0, 0], "max": [0, 0, 0]}]})");
    return asFound ? 0 : 1;
}
END
compile -ltinygltf
./main || changed "as printed above"
echo "as found"
