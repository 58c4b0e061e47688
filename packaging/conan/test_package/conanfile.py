"""A program against the package: conan create builds and runs it."""

import os

from conan import ConanFile
from conan.tools.build import can_run
from conan.tools.cmake import CMake, cmake_layout


class Program(ConanFile):
    settings = "os", "arch", "compiler", "build_type"
    generators = "CMakeDeps", "CMakeToolchain"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        cmake_layout(self)

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def test(self):
        if can_run(self):
            digest = self.dependencies["softanvil"].cpp_info.get_property("cmake_extra_variables")["softanvil_KERNEL_DIGEST"]
            self.run(f"{os.path.join(self.cpp.build.bindir, 'drop')} {digest}", env="conanrun")
