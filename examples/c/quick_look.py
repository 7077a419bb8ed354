#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""quick_look.c by ctypes: python3 quick_look.py [path/to/libwellstrat.so]"""

import ctypes
import ctypes.util
import sys


class Context(ctypes.Structure):
    _fields_ = [("patternid", ctypes.c_uint32), ("sampleid", ctypes.c_uint32)]


class Domain(ctypes.Structure):
    _fields_ = [("generator", ctypes.c_uint32), ("slot", ctypes.c_uint16), ("splits", ctypes.c_uint16)]


lib = ctypes.CDLL(sys.argv[1] if len(sys.argv) > 1 else ctypes.util.find_library("wellstrat"))
lib.wellstrat_last_error.restype = ctypes.c_char_p
# Without these, ctypes takes all results for int and passes counts in 32 bits.
lib.wellstrat_camera_context.restype = Context
lib.wellstrat_new_domains.argtypes = [
    Domain, ctypes.c_uint32, ctypes.c_size_t, ctypes.POINTER(Context),
    ctypes.POINTER(Domain), ctypes.POINTER(Context)]
lib.wellstrat_draw_samples_2d.argtypes = [
    Domain, ctypes.c_size_t, ctypes.POINTER(Context), ctypes.POINTER(ctypes.c_float)]


def require(status):
    if status != 0:
        raise ValueError(lib.wellstrat_last_error().decode())


pixel, light = Domain(), Domain()
contexts, light_contexts = (Context * 4)(), (Context * 4)()
xi, on_light = (ctypes.c_float * 8)(), (ctypes.c_float * 8)()

require(lib.wellstrat_camera_domain(0, ctypes.byref(pixel)))  # 0: pmj
for i in range(4):  # four samples of pixel (320, 200) in frame 1
    contexts[i] = lib.wellstrat_camera_context(320, 200, 1, i, 0)
require(lib.wellstrat_new_domains(pixel, 0x5d1c9a37, 4, contexts, light, light_contexts))

require(lib.wellstrat_draw_samples_2d(pixel, 4, contexts, xi))
require(lib.wellstrat_draw_samples_2d(light, 4, light_contexts, on_light))
for i in range(4):
    print(f"sample {i}: pixel ({xi[2 * i]:.3f}, {xi[2 * i + 1]:.3f})"
          f"  light ({on_light[2 * i]:.3f}, {on_light[2 * i + 1]:.3f})")
