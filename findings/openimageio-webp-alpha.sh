#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# OpenImageIO 2.4.7 (Debian 12: 2.4.7.1+dfsg-2) multiplies the colors of WebP pictures by alpha even if
# "oiio:UnassociatedAlpha" asks it not to, which it heeds for PNG:
#
#     a.png: 0.80 0.40 0.20 alpha 0.25
#     a.webp: 0.09 0.05 0.00 alpha 0.25
#
# Beside that, ImageInput::open(name, &config, &proxy) takes no note of the proxy: it looks for a file
# of that name. ImageInput::create(name, true, &config, &proxy) does, where config has the proxy
# once more as "oiio:ioproxy".
#
# Needs g++ and what libopenimageio-dev depends on.
#
# Expected: "oiio:UnassociatedAlpha" is heeded for all formats, and open() takes the proxy it is given.
# Found: neither is so, for WebP and for open().
# Versions: OpenImageIO 2.4.7.1+dfsg-2. Source: Debian 12. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch libopenimageio-dev=2.4.7.1+dfsg-2 libopenimageio2.4=2.4.7.1+dfsg-2 openimageio-tools=2.4.7.1+dfsg-2
oiiotool=usr/bin/oiiotool
needs_all "$oiiotool"

cat > main.cpp << 'END'
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <vector>
using namespace OIIO;
float redOf(const char* name) {
    ImageSpec wanted;
    wanted["oiio:UnassociatedAlpha"] = 1;
    const auto input = ImageInput::open(name, &wanted);
    float p[4] = {};
    if (!input || !input->read_image(0, 0, 0, 4, TypeDesc::FLOAT, p)) return -1;
    std::printf("%s: %.2f %.2f %.2f alpha %.2f\n", name, p[0], p[1], p[2], p[3]);
    return p[0];
}
bool opensFromMemory() {
    std::ifstream file("a.png", std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    Filesystem::IOMemReader reader(bytes.data(), bytes.size());
    ImageSpec wanted;
    wanted["oiio:UnassociatedAlpha"] = 1;
    return ImageInput::open("memory.png", &wanted, &reader) != nullptr;
}
int main() {
    const bool png = std::fabs(redOf("a.png") - 0.8f) < 0.01f;
    const bool webp = redOf("a.webp") < 0.5f;
    const bool memory = opensFromMemory();
    std::printf("open with a configuration and a proxy: %s\n", memory ? "works" : geterror().c_str());
    return png && webp && !memory ? 0 : 1;
}
END
"$oiiotool" --pattern constant:color=0.8,0.4,0.2,0.25 1x1 4 -d uint8 --attrib oiio:UnassociatedAlpha 1 \
    -o a.png
"$oiiotool" a.png -o a.webp
compile -lOpenImageIO -lOpenImageIO_Util
./main || changed "as printed above"
echo "as found"
