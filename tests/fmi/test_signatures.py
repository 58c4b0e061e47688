"""The signatures of the exported functions against the standard's own headers, by the C compiler: it takes no two declarations
of a function that differ."""

import pathlib
import re
import subprocess

import fmpy
import pytest

HEADERS = pathlib.Path(fmpy.__file__).parent / "c-code"
ROOT = pathlib.Path(__file__).parents[2]
CODE = """
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "fmi{version}Functions.h"
#include "prototypes.h"
"""
# The library takes enumerations as integers, and truth values of FMI 3.0 as bytes.
SIZES = {
    2: "_Static_assert(sizeof(fmi2Status) == 4 && sizeof(fmi2Type) == 4 && sizeof(fmi2StatusKind) == 4, \"\");",
    3: "_Static_assert(sizeof(fmi3Status) == 4 && sizeof(fmi3Boolean) == 1 && sizeof(fmi3Clock) == 1, \"\");",
}


@pytest.fixture(scope="module", params=[2, 3])
def prototypes(request):
    """Version, and the prototypes of the library in C."""
    # As the Rust tests build it, which may run at the same time.
    build = ["cargo", "build", "--quiet", "--profile", "checked", "--workspace", "--exclude", "softanvil-python",
             "--lib", "--bins", "--examples", "--tests"]
    subprocess.run(build, cwd=ROOT, check=True)
    program = ROOT / "target" / "checked" / "examples" / "fmi_prototypes"
    made = subprocess.run([program, str(request.param)], cwd=ROOT, check=True, capture_output=True, text=True)
    return request.param, made.stdout


def compiled(folder, version, prototypes):
    """What the compiler says."""
    (folder / "prototypes.h").write_text(prototypes)
    (folder / "check.c").write_text(CODE.format(version=version) + SIZES[version])
    command = ["gcc", "-std=c11", "-Wall", "-Wextra", "-fsyntax-only", f"-I{HEADERS}", folder / "check.c"]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.stderr


def official(version):
    """The functions of the header."""
    text = (HEADERS / f"fmi{version}Functions.h").read_text()
    return set(re.findall(rf"FMI{version}_Export\s+fmi{version}\w+TYPE\s+(fmi{version}\w+);", text))


def test_every_signature_is_the_standards(tmp_path, prototypes):
    version, text = prototypes
    assert set(re.findall(rf"\b(fmi{version}[A-Z]\w*)\(", text)) == official(version)
    assert compiled(tmp_path, version, text) == ""


@pytest.mark.parametrize("change", [(r"\b(fmi\d[A-Z]\w*)\((void\))?", r"\1(float, "), (r"^\S.*?\*?(?=fmi\d[A-Z]\w*\()", "float ")])
def test_another_argument_or_result_of_any_function_is_found(tmp_path, prototypes, change):
    version, text = prototypes
    altered = re.sub(*change, text, flags=re.MULTILINE).replace("float, ;", "float);")
    found = set(re.findall(r"conflicting types for .(fmi\w+)", compiled(tmp_path, version, altered)))
    assert found == official(version)


@pytest.mark.parametrize("change", [("const ", ""), ("double", "float"), ("uint32_t", "int32_t"), ("size_t", "unsigned int")])
def test_other_types_of_numbers_and_pointers_are_found(tmp_path, prototypes, change):
    version, text = prototypes
    assert "conflicting types" in compiled(tmp_path, version, text.replace(*change))
