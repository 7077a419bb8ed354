#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Debian 12's libdraco7 (1.5.5+dfsg-2) exports tinygltf: 71 of the functions that libtinygltf2d
# (2.7.0+dfsg-2) exports too, under the same names and of another version, whose structures have
# another layout. A program that links both, as every one does that links libtinygltf and libassimp,
# mixes the two and crashes. Workaround: compile tiny_gltf.h into the program
# (TINYGLTF_IMPLEMENTATION), with its functions hidden.
#
# Runs nothing of the two packages. Needs binutils.
#
# Expected: a library exports its own names; a program may link both of these.
# Found: libdraco exports tinygltf as well, and programs that link both crash.
# Versions: libdraco7 1.5.5+dfsg-2, libtinygltf2d 2.7.0+dfsg-2.
# Source: Debian 12. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch libdraco7=1.5.5+dfsg-2 libtinygltf2d=2.7.0+dfsg-2
command -v nm > /dev/null || untried "needs binutils"
exported() { nm -D --defined-only "$@" | awk '{print $3}' | grep tinygltf | sort; }
exported usr/lib/*/libdraco.so.7.* > draco
exported usr/lib/*/libtinygltf.so.2.* > tinygltf
common=$(comm -12 draco tinygltf | wc -l)
echo "names of tinygltf that both export: $common"
[ "$common" -gt 0 ] || changed "they share no names"
echo "as found"
