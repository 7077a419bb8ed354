# SPDX-License-Identifier: Apache-2.0
"""Compiles tests/gpu/kernels.cu for GPUs, with warnings as errors, and counts the instructions of
each kernel. Needs no GPU. For scripts/bench, scripts/gpu-check and tests/gpu."""

import dataclasses
import pathlib
import re
import shutil
import struct
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
KERNELS = ROOT / "tests/gpu/kernels.cu"
SHIM = ROOT / "tests/gpu/toolkit_shim.h"
CXX = ["-std=c++17", f"-I{ROOT / 'include'}", f"-I{ROOT}"]
COMMON = [*CXX, "-O3"]
WITHOUT_TOOLKIT = ["--cuda-device-only", "-S", "-Wall", "-Wextra", "-Werror", "-include", SHIM]
NVIDIA, AMD = "sm_90", "gfx90a"

# Opcodes of SASS since sm_70, the low 12 bits of an instruction of 16 bytes: what fills a function
# up, a jump to itself and instructions that do nothing.
SASS_BYTES, SASS_JUMP, SASS_NOTHING = 16, 0x947, 0x918


class CompilerError(Exception):
    """What a compiler said when it failed."""


@dataclasses.dataclass
class Code:
    """What one compiler made of a kernel. `rare` is in functions that it calls in rare cases."""
    instructions: int
    rare: int = 0
    registers: int = 0
    spilled_bytes: int = 0


def program(name):
    """The path of a program of CUDA's or of Debian's, or None."""
    return shutil.which(name) or shutil.which(f"/usr/local/cuda/bin/{name}")


def run(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise CompilerError(done.stdout)
    return done.stdout


def clang_ptx(folder, source=KERNELS):
    """The file of PTX that clang 16 makes, without CUDA's headers."""
    path = folder / "clang.ptx"
    run(program("clang++-16"), "-x", "cuda", *COMMON, *WITHOUT_TOOLKIT, "-nocudainc", "-nocudalib",
        f"--cuda-path={folder}", f"--cuda-gpu-arch={NVIDIA}", "-o", path, source)
    return path


def clang_amd(folder, source=KERNELS):
    """The file of AMD's assembly that clang 16 makes, without HIP's headers."""
    path = folder / "clang.s"
    run(program("clang++-16"), "-x", "hip", *COMMON, *WITHOUT_TOOLKIT, "-nogpuinc", "-nogpulib",
        f"--offload-arch={AMD}", "-o", path, source)
    return path


def nvcc_cubin(folder):
    """The cubin that nvcc makes, and what ptxas said about it."""
    path = folder / "nvcc.cubin"
    said = run(program("nvcc"), *COMMON, f"-arch={NVIDIA}", "-cubin", "-Werror=all-warnings",
               "-Xcompiler=-Wall,-Wextra", "-Xptxas=-v", "-o", path, KERNELS)
    return path, said


def hipcc_object(folder):
    """The object file that hipcc makes for AMD's GPUs, by HIP's own headers."""
    path = folder / "hipcc.o"
    run(program("hipcc"), "-x", "hip", *COMMON, f"--offload-arch={AMD}", "-include",
        "hip/hip_runtime.h", "-Wall", "-Wextra", "-Werror", "-Wno-unused-command-line-argument",
        "-c", "-o", path, KERNELS)
    return path


def ptx_code(path):
    """Code by kernel, of a file of PTX."""
    code = {}
    for name, body in re.findall(r"\.entry (\w+)\(.*?\n\{\n(.*?)\n\}", path.read_text(), re.S):
        statements = [line.strip() for line in body.splitlines()]
        code[name] = Code(sum(line.endswith((";", ",")) and not line.startswith((".", "("))
                              for line in statements))
    return code


def amd_code(path):
    """Code by kernel, of a file of AMD's assembly."""
    code = {}
    for name, body in re.findall(r"^(\w+):.*?@\1\n(.*?)^\.Lfunc_end", path.read_text(),
                                 re.S | re.M):
        if f".amdhsa_kernel {name}\n" in body:
            code[name] = Code(len(re.findall(r"^\t[a-z]\w+", body, re.M)))
    return code


def sass_code(path, said):
    """Code by kernel, of a cubin and of what ptxas -v said."""
    code = {}
    for kernel, functions in functions_of(path.read_bytes()).items():
        code[kernel] = Code(functions[0], sum(functions[1:]))
    for kernel, spilled, registers in re.findall(
            r"entry function '(\w+)'.*?(\d+) bytes spill stores.*?Used (\d+) registers", said, re.S):
        code[kernel].spilled_bytes, code[kernel].registers = int(spilled), int(registers)
    return code


def functions_of(elf):
    """Of a cubin, by kernel: the instructions of it and of each function that stands behind it."""
    offset = struct.unpack_from("<Q", elf, 0x28)[0]
    size, count, names = struct.unpack_from("<HHH", elf, 0x3a)
    sections = [struct.unpack_from("<IIQQQQIIQQ", elf, offset + i * size) for i in range(count)]

    def string(table, start):
        begin = sections[table][4] + start
        return elf[begin:elf.index(b"\0", begin)].decode()

    symbols = next(section for section in sections if section[1] == 2)
    starts = {}
    for place in range(symbols[4], symbols[4] + symbols[5], 24):
        _, info, _, section, value = struct.unpack_from("<IBBHQ", elf, place)
        if info & 15 == 2:  # a function
            starts.setdefault(section, set()).add(value)
    kernels = {}
    for number, values in starts.items():
        name, begin, length = (sections[number][i] for i in (0, 4, 5))
        edges = sorted(values) + [length]
        kernels[string(names, name).removeprefix(".text.")] = [
            instructions(elf[begin + first:begin + last]) for first, last in zip(edges, edges[1:])]
    return kernels


def instructions(text):
    """How many instructions SASS has, without what fills it up at its end."""
    opcodes = [struct.unpack_from("<Q", text, place)[0] & 0xfff
               for place in range(0, len(text), SASS_BYTES)]
    while opcodes and opcodes[-1] == SASS_NOTHING:
        opcodes.pop()
    return len(opcodes) - (opcodes[-1:] == [SASS_JUMP])
