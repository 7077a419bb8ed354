#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# What OpenImageIO 2.4.7 (Debian 12: 2.4.7.1+dfsg-2) makes of a sun of radiance 100,000 in a sky:
#
#     written to .exr as half: infinite (the largest half is 65504), without an error
#     that .exr written to .hdr: 0, the sun is black, without an error
#
# Both are valid files and common ones: half is what most programs write .exr with, and environment
# maps are passed on as .hdr.
#
# Needs g++ and what libopenimageio-dev depends on.
#
# Expected: the largest number that the file can hold, or an error, where a number does not fit.
# Found: infinity, and then nothing.
# Versions: OpenImageIO 2.4.7.1+dfsg-2. Source: Debian 12. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch libopenimageio-dev=2.4.7.1+dfsg-2 libopenimageio2.4=2.4.7.1+dfsg-2
cat > main.cpp << 'END'
#include <OpenImageIO/imageio.h>
#include <cmath>
#include <cstdio>
using namespace OIIO;
bool write(const char* name, TypeDesc type, const float* pixel) {
    const auto output = ImageOutput::create(name);
    return output && output->open(name, ImageSpec(1, 1, 3, type)) &&
           output->write_image(TypeDesc::FLOAT, pixel) && output->close();
}
bool read(const char* name, float* pixel) {
    const auto input = ImageInput::open(name);
    return input && input->read_image(0, 0, 0, 3, TypeDesc::FLOAT, pixel);
}
int main() {
    const float sun[3] = {1e5f, 1e5f, 1e5f};
    float half[3] = {}, rgbe[3] = {};
    const bool isRead = write("sun.exr", TypeDesc::HALF, sun) && read("sun.exr", half) &&
                        write("sun.hdr", TypeDesc::FLOAT, half) && read("sun.hdr", rgbe);
    std::printf("written and read without an error: %d\n", isRead);
    std::printf("in the sky %g, in .exr %g, in .hdr from it %g\n", sun[0], half[0], rgbe[0]);
    return isRead && std::isinf(half[0]) && rgbe[0] == 0.0f ? 0 : 1;
}
END
compile -lOpenImageIO -lOpenImageIO_Util
./main || changed "as printed above"
echo "as found"
