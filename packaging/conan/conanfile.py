"""The library for C and C++ as a package of Conan 2, built from the sources by cargo: conan create packaging/conan."""

import json
import os
import re

from conan import ConanFile
from conan.errors import ConanInvalidConfiguration
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load, rm, rmdir

#: What is taken of the repository besides the members of the workspace, of which cargo asks for all.
SOURCES = ("Cargo.*", "CMakeLists.txt", "LICENSE-*", "README.md", "include/*")

#: What cargo, Python and fuzzers leave there.
LEFT_THERE = ("*/target/*", "*/fuzz/*", "*/__pycache__/*")

#: The names that rustc has for what it builds for.
TARGETS = {("Linux", "x86_64"): "x86_64-unknown-linux-gnu", ("Linux", "armv8"): "aarch64-unknown-linux-gnu"}


class Softanvil(ConanFile):
    name = "softanvil"
    license = "MIT OR Apache-2.0"
    author = "The Softanvil developers"
    description = "Deterministic simulation of drop-weight impact on a soft anvil"
    topics = ("finite-element", "impact", "deterministic", "simulation")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False]}
    default_options = {"shared": False}

    def _root(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def _of_workspace(self, pattern):
        return re.search(pattern, load(self, os.path.join(self._root(), "Cargo.toml")), re.M)[1]

    def set_version(self):
        self.version = self._of_workspace(r'^version = "(.*)"')

    def export_sources(self):
        members = json.loads(self._of_workspace(r"^members = (\[.*\])"))
        for pattern in (*SOURCES, *(f"{member}/*" for member in members)):
            copy(self, pattern, self._root(), self.export_sources_folder, excludes=LEFT_THERE)

    def configure(self):
        # No compiler of C or C++ has a part in the library, whose ABI is that of C.
        self.settings.rm_safe("compiler.cppstd")
        self.settings.rm_safe("compiler.libcxx")

    def validate(self):
        if (str(self.settings.os), str(self.settings.arch)) not in TARGETS:
            known = ", ".join(" on ".join(pair) for pair in TARGETS)
            raise ConanInvalidConfiguration(f"{self.settings.os} on {self.settings.arch}: expected {known}")

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["SOFTANVIL_RUST_TARGET"] = TARGETS[str(self.settings.os), str(self.settings.arch)]
        toolchain.cache_variables["CMAKE_INSTALL_LIBDIR"] = "lib"
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE-*", self.source_folder, os.path.join(self.package_folder, "licenses"))
        # Conan writes these for its package, which has one of the two libraries.
        rmdir(self, os.path.join(self.package_folder, "lib", "cmake"))
        rmdir(self, os.path.join(self.package_folder, "lib", "pkgconfig"))
        rm(self, "*.a" if self.options.shared else "*.so*", os.path.join(self.package_folder, "lib"))

    def package_info(self):
        self.cpp_info.libs = ["softanvil"]
        self.cpp_info.set_property("cmake_file_name", "softanvil")
        self.cpp_info.set_property("cmake_target_name", "softanvil::softanvil")
        self.cpp_info.set_property("pkg_config_name", "softanvil")
        header = load(self, os.path.join(self.package_folder, "include", "softanvil.h"))
        digest = re.search(r"SOFTANVIL_KERNEL_DIGEST UINT64_C\(0x([0-9a-f]{16})\)", header)[1]
        self.cpp_info.set_property("cmake_extra_variables", {"softanvil_KERNEL_DIGEST": digest})
        self.cpp_info.set_property("pkg_config_custom_content", f"kernel_digest={digest}")
        if not self.options.shared:
            self.cpp_info.system_libs = ["pthread", "dl", "m"]
