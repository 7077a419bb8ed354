#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Debian 12's libdraco7 (1.5.5+dfsg-2) exports tinygltf: 71 of the functions that libtinygltf2d
# (2.7.0+dfsg-2) exports too, under the same names and of another version, whose structures have
# another layout. A program that links both, as every one does that links libtinygltf and libassimp,
# mixes the two and crashes. Workaround: compile tiny_gltf.h into the program
# (TINYGLTF_IMPLEMENTATION), with its functions hidden.
#
# Downloads the two packages into a temporary folder, and runs nothing of them. Needs binutils. Fails
# when the behavior changes.
#
# Expected: a library exports its own names; a program may link both of these.
# Found: libdraco exports tinygltf as well, and programs that link both crash.
# Versions: libdraco7 1.5.5+dfsg-2, libtinygltf2d 2.7.0+dfsg-2.
# Source: Debian 12. Date: 2026-11-27. As recorded below.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
for package in libdraco7=1.5.5+dfsg-2 libtinygltf2d=2.7.0+dfsg-2; do
    apt-get download -qq "$package" 2> /dev/null
done
for file in *.deb; do
    dpkg-deb --show --showformat '${Package} ${Version}\n' "$file"
    dpkg-deb --extract "$file" .
done
exported() { nm -D --defined-only "$@" | awk '{print $3}' | grep tinygltf | sort; }
exported usr/lib/*/libdraco.so.7.* > draco
exported usr/lib/*/libtinygltf.so.2.* > tinygltf
common=$(comm -12 draco tinygltf | wc -l)
echo "names of tinygltf that both export: $common"
[ "$common" -gt 0 ] || { echo "changed: they share no names"; exit 1; }
echo "as found"
