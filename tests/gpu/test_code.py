# SPDX-License-Identifier: Apache-2.0
"""What a kernel may call compiles for GPUs, without toolkits and with them, and to few instructions.
Needs no GPU: scripts/gpu-check has the tests that run there."""

import os
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent.parent / "scripts"))
import device_code  # noqa: E402

# The most instructions of a kernel, of PTX by clang, and of SASS and registers by nvcc. From the
# pixel to the sample, with all that a kernel needs around it.
LIMITS = {
    "context": (28, 25, 14),
    "table_1d": (84, 70, 14),
    "table_2d": (90, 76, 14),
    "table_3d": (98, 84, 16),
    "table_2d_four": (270, 225, 26),
    "joint_2d": (110, 92, 20),
    "long_2d": (95, 90, 14),
    "long_3d": (137, 125, 18),
    "long_slot_2d": (131, 130, 22),
    "blue_2d": (180, 160, 18),
    "blue_slot_2d": (200, 186, 28),
}
MOST_OF_A_PLAIN_DRAW = 1.5  # a draw from a slot
SLOTS = (("joint_2d", "table_2d"), ("long_slot_2d", "long_2d"), ("blue_slot_2d", "blue_2d"))


class CodeTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def require(self, program):
        if device_code.program(program) is None:
            self.skipTest(f"{program} is not installed")

    def assert_slots_cost_little(self, code):
        for slot, plain in SLOTS:
            self.assertLessEqual(code[slot].instructions,
                                 MOST_OF_A_PLAIN_DRAW * code[plain].instructions, slot)

    def test_ptx_by_clang(self):
        self.require("clang++-16")
        ptx = device_code.clang_ptx(self.folder)
        code = device_code.ptx_code(ptx)
        for kernel, (most, _, _) in LIMITS.items():
            self.assertLessEqual(code[kernel].instructions, most, kernel)
        self.assert_slots_cost_little(code)
        self.assertIn("brev.b32", ptx.read_text(), "the instruction that reverses bits")

    def test_amd_by_clang(self):
        self.require("clang++-16")
        assembly = device_code.clang_amd(self.folder)
        self.assertLessEqual(LIMITS.keys(), device_code.amd_code(assembly).keys())
        self.assertIn("v_bfrev_b32", assembly.read_text(), "the instruction that reverses bits")

    def test_amd_by_hipcc(self):
        self.require("hipcc")
        self.assertIn(b"table_2d", device_code.hipcc_object(self.folder).read_bytes())

    def test_sass_by_nvcc(self):
        self.require("nvcc")
        code = device_code.sass_code(*device_code.nvcc_cubin(self.folder))
        for kernel, (_, most, registers) in LIMITS.items():
            self.assertLessEqual(code[kernel].instructions, most, kernel)
            self.assertLessEqual(code[kernel].registers, registers, kernel)
            self.assertEqual(code[kernel].spilled_bytes, 0, kernel)
        self.assert_slots_cost_little(code)

    def test_device_code_gives_the_golden_values(self):
        """Run on the processor: what the headers have for device code alone is plain C++ to clang,
        but for the name of the place where it runs."""
        self.require("clang++-16")
        root, program = device_code.ROOT, self.folder / "gpu_check"
        parts = ("golden_questions", "gpu_check", "host", "without_gpu")
        device_code.run(
            device_code.program("clang++-16"), *device_code.CXX, "-O1", "-pthread",
            "-D__HIP_DEVICE_COMPILE__=1", "-D__device__=", f"-I{root / 'src'}",
            f"-I{os.environ['WELLSTRAT_GENERATED']}", *(root / "src/core").glob("*.cpp"),
            *(root / f"tests/gpu/{part}.cpp" for part in parts), "-o", program)
        files = (root / f"tests/golden/{name}.txt" for name in ("samples", "joint", "long", "blue"))
        self.assertIn("\nall agree", device_code.run(program, "18", *files))

    def test_all_headers_compile_in_device_code(self):
        self.require("clang++-16")
        include = device_code.ROOT / "include"
        headers = (path.relative_to(include) for path in sorted(include.rglob("*.h")))
        source = self.folder / "headers.cu"
        source.write_text("".join(f'#include "{header}"\n' for header in headers
                                  if "analysis" not in header.parts))
        for compile_with in (device_code.clang_ptx, device_code.clang_amd):
            compile_with(self.folder, source)

    def test_a_warning_is_an_error(self):
        self.require("clang++-16")
        source = self.folder / "warning.cu"
        source.write_text("__device__ void f(int unused) {}\n")
        for compile_with in (device_code.clang_ptx, device_code.clang_amd):
            with self.assertRaisesRegex(device_code.CompilerError, "unused"):
                compile_with(self.folder, source)


if __name__ == "__main__":
    unittest.main()
