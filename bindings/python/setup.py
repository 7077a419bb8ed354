# SPDX-License-Identifier: Apache-2.0
"""What pyproject.toml cannot say: the version is CMake's, and CMake builds the compiled modules.

Honors what Debian's builds set in the environment: CXX, CXXFLAGS, CPPFLAGS, LDFLAGS.
"""

import os
import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.sdist import sdist

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGETS = {"wellstrat._core": "wellstrat_python", "wellstrat._analysis": "wellstrat_python_analysis"}


def version():
    text = (ROOT / "CMakeLists.txt").read_text()
    found = re.search(r"project\(wellstrat VERSION (\S+)", text)
    assert found, "CMakeLists.txt has no project(wellstrat VERSION ...)"
    return found[1]


class CMakeBuild(build_ext):
    """Builds the libraries and the modules that they are compiled into."""

    def build_extension(self, ext):
        build = pathlib.Path(self.build_temp).resolve()
        module = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        flags = " ".join(os.environ.get(name, "") for name in ("CXXFLAGS", "CPPFLAGS"))
        self.cmake("-S", ROOT, "-B", build,
                   "-DCMAKE_BUILD_TYPE=Release", "-DBUILD_SHARED_LIBS=OFF",
                   "-DWELLSTRAT_BUILD_PYTHON=ON", "-DWELLSTRAT_INSTALL=OFF",
                   f"-DCMAKE_CXX_FLAGS={flags.strip()}",
                   f"-DCMAKE_MODULE_LINKER_FLAGS={os.environ.get('LDFLAGS', '')}",
                   f"-DPython_EXECUTABLE={sys.executable}",
                   f"-DCMAKE_LIBRARY_OUTPUT_DIRECTORY={module.parent}")
        self.cmake("--build", build, "--target", TARGETS[ext.name],
                   "--parallel", str(len(os.sched_getaffinity(0))))

    def cmake(self, *arguments):
        command = ["cmake", *map(str, arguments)]
        print(*command, flush=True)
        subprocess.run(command, check=True)


class NoSdist(sdist):
    """The sources of the package are the sources of the whole project."""

    def run(self):
        sys.exit("wellstrat has no source archive of its own: build a wheel in bindings/python "
                 "of the project's source archive.")


setup(version=version(), ext_modules=[Extension(name, sources=[]) for name in TARGETS],
      cmdclass={"build_ext": CMakeBuild, "sdist": NoSdist})
