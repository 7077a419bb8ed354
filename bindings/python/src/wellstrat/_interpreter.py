# SPDX-License-Identifier: Apache-2.0
"""Which interpreter of the process this is."""

from __future__ import annotations

import ctypes


def refuse_subinterpreters() -> None:
    """Raises ImportError in all but the main interpreter: NumPy works in no other."""
    current = ctypes.pythonapi.PyInterpreterState_Get
    main = ctypes.pythonapi.PyInterpreterState_Main
    current.restype = main.restype = ctypes.c_void_p
    if current() != main():
        raise ImportError("wellstrat works in the main interpreter only, as NumPy does; this is a "
                          "sub-interpreter")
