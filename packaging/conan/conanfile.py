# SPDX-License-Identifier: Apache-2.0
"""Conan 2's recipe: the library, and on demand the one that measures point sets. Run `conan create .`
in this folder."""

import os

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Wellstrat(ConanFile):
    name = "wellstrat"
    version = "0.1.0"
    license = "Apache-2.0"
    url = homepage = "https://github.com/wellstrat/wellstrat"
    description = "Well-stratified samples for renderers through the RixRNG interface"
    topics = ("rendering", "sampling", "quasi-monte-carlo")
    package_type = "library"
    settings = "os", "compiler", "build_type", "arch"
    options = {"shared": [True, False], "fPIC": [True, False], "analysis": [True, False]}
    default_options = {"shared": False, "fPIC": True, "analysis": False}
    implements = ["auto_shared_fpic"]

    def export_sources(self):
        root = os.path.join(self.recipe_folder, os.pardir, os.pardir)
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*", "include/*", "src/*"):
            copy(self, pattern, root, self.export_sources_folder)

    def layout(self):
        cmake_layout(self)

    def build_requirements(self):
        self.tool_requires("cmake/[>=3.25]")

    def requirements(self):
        self.requires("highway/[>=1.0.3]", visible=False)  # its headers only, to build
        if self.options.analysis:
            self.requires("fftw/[>=3.3]")

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["WELLSTRAT_BUILD_ANALYSIS"] = bool(self.options.analysis)
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        # The package has CMake's files of its own.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = [os.path.join("lib", "cmake", "wellstrat")]
        self.cpp_info.libs = [f"wellstrat{suffix}" for suffix in self.suffixes()]

    def suffixes(self):
        """Of the libraries, those that need others first."""
        return [*(["-analysis"] if self.options.analysis else []), "-debug", ""]
