#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# gltfpack 0.18 (Debian 12: 0.18+dfsg-2) puts all positions of a file on one grid of 2^14 steps across the
# whole scene, not one for each mesh. An object of 4 mm on a floor of 100 m, where a step is 6 mm, becomes
# a line or a point: its triangles have no area. The exit code is 0, and nothing is said. Alone in
# its file, the same object has steps of 0.24 micrometers. Workaround: -vpf, which keeps positions as floats.
#
# Needs Python 3.
#
# Expected: an error of 2^-14 of the size of a mesh, as KHR_mesh_quantization allows, or a warning.
# Found: of the size of the scene, and no word.
# Versions: gltfpack 0.18+dfsg-2. Source: Debian 12. Date: 2026-11-27. As recorded below.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
fetch gltfpack=0.18+dfsg-2
needs_all usr/bin/gltfpack
python3 - << 'END' || changed "as printed above"
import base64
import json
import struct
import subprocess

OBJECT = [(0, 0, 0), (0.004, 0, 0), (0, 0.004, 0)]
FLOOR = [(-50, -1, -50), (50, -1, -50), (0, -1, 50)]


def write(name, meshes):
    data = b"".join(struct.pack("<3f", *point) for mesh in meshes for point in mesh)
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    json.dump({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(len(meshes)))}],
        "nodes": [{"mesh": i} for i in range(len(meshes))],
        "meshes": [{"primitives": [{"attributes": {"POSITION": i}}]} for i in range(len(meshes))],
        "accessors": [{"bufferView": 0, "byteOffset": 36 * i, "componentType": 5126, "count": 3,
                       "type": "VEC3", "min": [min(axis) for axis in zip(*mesh)],
                       "max": [max(axis) for axis in zip(*mesh)]} for i, mesh in enumerate(meshes)],
        "bufferViews": [{"buffer": 0, "byteLength": len(data)}],
        "buffers": [{"byteLength": len(data), "uri": uri}]}, open(name, "w"))


def packed(meshes):
    """(All positions on the grid, meters of a step)."""
    write("in.gltf", meshes)
    subprocess.run(["usr/bin/gltfpack", "-i", "in.gltf", "-o", "out.gltf"], check=True)
    out = json.load(open("out.gltf"))
    data = open("out.bin", "rb").read()
    points = []
    for accessor in out["accessors"]:
        if accessor["type"] == "VEC3":
            view = out["bufferViews"][accessor["bufferView"]]
            start = view["byteOffset"] + accessor.get("byteOffset", 0)
            points += [struct.unpack_from("<3H", data, start + i * view["byteStride"])
                       for i in range(accessor["count"])]
    return points, out["nodes"][0]["scale"][0]


alone, fine = packed([OBJECT])
print(f"alone: {len(set(alone))} points of 3 differ, a step is {1e6 * fine:.2f} micrometers")
both, coarse = packed([OBJECT, FLOOR])
left = len(set(both)) - 3
print(f"beside the floor: {left} of 3, a step is {1e3 * coarse:.2f} mm")
raise SystemExit(not (len(set(alone)) == 3 and left < 3 and coarse > 1e4 * fine))
END
echo "as found"
