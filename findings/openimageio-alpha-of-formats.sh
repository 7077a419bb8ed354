#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# OpenImageIO 2.4.7 (Debian 12: 2.4.7.1+dfsg-2) says that colors are multiplied by alpha when it reads a
# picture, whatever the format, unless "oiio:UnassociatedAlpha" asks it not to. It depends on the format:
# the color (0.8, 0.4, 0.2) with alpha 0.25, stored as that in each of these files, is read as
#
#     .png .tga: (0.20, 0.10, 0.05)
#     .bmp .sgi: (0.80, 0.40, 0.20), the alpha 0.25
#
# so that a texture changes its color when it is converted from one to the other by another program.
# (.webp: openimageio-webp-alpha.sh.)
#
# Needs Python 3, g++ and what libopenimageio-dev depends on.
#
# Expected: the same of all formats that store what was not multiplied.
# Found: as above.
# Versions: OpenImageIO 2.4.7.1+dfsg-2. Source: Debian 12; its documentation, "Unassociated alpha" of
# ImageInput. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch libopenimageio-dev=2.4.7.1+dfsg-2 libopenimageio2.4=2.4.7.1+dfsg-2
python3 - << 'END'
import struct
import zlib

R, G, B, A = 204, 102, 51, 64


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


open("a.png", "wb").write(
    b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 6, 0, 0, 0))
    + chunk(b"IDAT", zlib.compress(bytes([0, R, G, B, A]))) + chunk(b"IEND", b""))
open("a.tga", "wb").write(
    struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, 1, 1, 32, 0x28) + bytes([B, G, R, A]))
# BITMAPV4HEADER with masks of red, green, blue and alpha.
open("a.bmp", "wb").write(
    struct.pack("<2sIHHI", b"BM", 126, 0, 0, 122)
    + struct.pack("<IiiHHIIiiII", 108, 1, 1, 1, 32, 3, 4, 0, 0, 0, 0)
    + struct.pack("<IIII4s48x", 0xff0000, 0xff00, 0xff, 0xff000000, b"BGRs") + bytes([B, G, R, A]))
open("a.sgi", "wb").write(
    struct.pack(">HBBHHHHII4x80sI404x", 474, 0, 1, 3, 1, 1, 4, 0, 255, b"", 0) + bytes([R, G, B, A]))
END
cat > main.cpp << 'END'
#include <OpenImageIO/imageio.h>
#include <cmath>
#include <cstdio>
using namespace OIIO;
bool reads(const char* name, float red) {
    const auto input = ImageInput::open(name);
    float p[4] = {};
    if (!input || !input->read_image(0, 0, 0, 4, TypeDesc::FLOAT, p)) return false;
    std::printf("%s: %.2f %.2f %.2f alpha %.2f\n", name, p[0], p[1], p[2], p[3]);
    return std::fabs(p[0] - red) < 0.01f && std::fabs(p[3] - 0.25f) < 0.01f;
}
int main() {
    const bool multiplied = reads("a.png", 0.2f) & reads("a.tga", 0.2f);
    const bool asStored = reads("a.bmp", 0.8f) & reads("a.sgi", 0.8f);
    return multiplied && asStored ? 0 : 1;
}
END
compile -lOpenImageIO -lOpenImageIO_Util
./main || changed "as printed above"
echo "as found"
