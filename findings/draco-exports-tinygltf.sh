#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Debian 12's libdraco (1.5.5+dfsg-2) exports functions of tinygltf, of another version than Debian's
# libtinygltf (2.7.0+dfsg-2), under the same names. A program that links both, as every one does that
# links libtinygltf and libassimp, parses a file by the one and destroys the result by the other:
#
#     $ ./both
#     parsed 8040888442386214808 sampler(s)
#     Segmentation fault
#
# Seen with a valid document of one sampler, where libdraco comes first. With libtinygltf alone the
# program ends well. Workaround: compile tiny_gltf.h into the program (TINYGLTF_IMPLEMENTATION).
#
# Needs libtinygltf-dev, libdraco-dev and g++. Fails when the behavior changes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
dpkg-query -W -f='${Package} ${Version}\n' libtinygltf-dev libdraco-dev

cat > main.cpp << 'END'
#include <tiny_gltf.h>
#include <cstdio>
#include <cstring>
int main() {
    const char* text = R"({"asset": {"version": "2.0"}, "samplers": [{"magFilter": 9728}]})";
    {
        tinygltf::Model model;
        std::string error, warning;
        if (!tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, text,
                                                      static_cast<unsigned>(std::strlen(text)), ""))
            return 2;
        std::printf("parsed %zu sampler(s)\n", model.samplers.size());
        std::fflush(stdout);
    }
    std::puts("ended well");
}
END
g++ -std=c++17 -O2 main.cpp -o alone -ltinygltf
g++ -std=c++17 -O2 main.cpp -o both -Wl,--no-as-needed -ldraco -ltinygltf
echo "exported by libdraco: $(nm -DC --defined-only "$(ldconfig -p | awk '/libdraco.so.7/ {print $NF; exit}')" |
    grep -c 'tinygltf::')"
./alone
if ./both; then
    echo "changed: both libraries get on"
    exit 1
fi
echo "as found: with both libraries it crashes"
