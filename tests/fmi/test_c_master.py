"""Masters in C with the standard's own headers: a whole life and every illegal call, under sanitizers and valgrind, and on
the other platforms, where the trace hash of the drop must be the same; and a heap that refuses."""

import os
import pathlib
import shutil
import subprocess
import zipfile

import fmpy
import pytest

HEADERS = pathlib.Path(fmpy.__file__).parent / "c-code"
HERE = pathlib.Path(__file__).parent
STRICT = ["-std=c11", "-D_GNU_SOURCE", "-Wall", "-Wextra", "-Werror", "-g"]
PLATFORMS = {
    "aarch64": ("aarch64-linux-gnu-gcc", "aarch64-linux/softanvil.so", ["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"]),
    "windows": ("x86_64-w64-mingw32-gcc", "x86_64-windows/softanvil.dll", ["wine"]),
}


def build(folder, name, compiler="gcc", flags=()):
    program = folder / f"{name}.exe"
    source = HERE / f"{name}.c"
    libraries = ["-lm"] if "mingw" in compiler else ["-ldl", "-lm"]
    command = [compiler, *STRICT, *flags, f"-I{HEADERS}", f"-I{HERE}", source, "-o", program, *libraries]
    subprocess.run(command, check=True)
    return program


def run(command, **options):
    result = subprocess.run(command, capture_output=True, text=True, **options)
    assert result.returncode == 0, result.stderr
    return result


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("flags", [[], ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]])
def test_under_sanitizers(tmp_path, description, kernel, version, flags):
    program = build(tmp_path, f"fmi{version}_check", flags=flags)
    result = run([program, os.environ["SOFTANVIL_LIBRARY"], description.guid])
    assert (result.stdout.strip(), result.stderr) == (kernel(14.7)["trace_hash"], "")


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.skipif(not shutil.which("valgrind"), reason="valgrind is missing")
def test_under_valgrind(tmp_path, description, kernel, version):
    program = build(tmp_path, f"fmi{version}_check")
    valgrind = ["valgrind", "--quiet", "--leak-check=full", "--errors-for-leak-kinds=definite,indirect,possible", "--error-exitcode=1"]
    result = run([*valgrind, program, os.environ["SOFTANVIL_LIBRARY"], description.guid, "brief"])
    assert (result.stdout.strip(), result.stderr) == (kernel(14.7)["trace_hash"], "")


def test_a_heap_that_refuses_is_an_error_and_ends_nothing(tmp_path, description, kernel):
    program = build(tmp_path, "memory")
    lines = run([program, os.environ["SOFTANVIL_LIBRARY"], description.guid]).stdout.split()
    assert lines[1::2] == [kernel(14.7)["trace_hash"]] * 2
    # Name, instance, six arrays of the model, state; what the state needs; the model for a state of another instance.
    assert all(int(refused) >= 8 for refused in lines[0::2])


@pytest.fixture
def foreign(tmp_path, fmu3):
    """Runs a master of this folder on another platform, with that platform's library and the arguments given."""

    def run_foreign(platform, name, *arguments):
        compiler, member, runner = PLATFORMS[platform]
        missing = [tool for tool in (compiler, runner[0]) if not shutil.which(tool)]
        if missing:
            pytest.skip(f"{missing[0]} is missing")
        program = build(tmp_path, name, compiler)
        with zipfile.ZipFile(fmu3) as archive:
            library = archive.extract(f"binaries/{member}", tmp_path)
        # Wine keeps its folders in the home folder unless told otherwise.
        environment = {**os.environ, "WINEDEBUG": "-all", "WINEPREFIX": os.environ["SOFTANVIL_WINE"]}
        return run([*runner, program, library, *arguments], env=environment).stdout.strip()

    return run_foreign


@pytest.mark.parametrize("version", [2, 3])
@pytest.mark.parametrize("platform", PLATFORMS)
def test_on_other_platforms(foreign, description, kernel, platform, version):
    # Emulated, the many drops would take minutes; they are the same code on every platform, and in either version.
    brief = [] if (version, platform) == (3, "windows") else ["brief"]
    assert foreign(platform, f"fmi{version}_check", description.guid, *brief) == kernel(14.7)["trace_hash"]


def in_environments(folder, description, samples):
    program = build(folder, "environment")
    return run([program, os.environ["SOFTANVIL_LIBRARY"], description.guid, str(samples)]).stdout.strip()


def test_in_every_floating_point_environment(tmp_path, description, kernel):
    """Whatever rounding, flush-to-zero or traps the master has set: the same trace, and its environment put back."""
    assert in_environments(tmp_path, description, 300) == kernel(14.7)["trace_hash"]


@pytest.mark.parametrize("platform", PLATFORMS)
def test_in_environments_of_other_platforms(tmp_path, foreign, description, platform):
    """Until the face has touched the layer."""
    assert foreign(platform, "environment", description.guid, "20") == in_environments(tmp_path, description, 20)


def exported(nm, library):
    listed = run([nm, "-D", "--defined-only", library]).stdout
    return {line.split()[-1] for line in listed.splitlines()}


def test_the_library_exports_the_functions_of_the_standard_and_needs_the_c_library_alone():
    library = os.environ["SOFTANVIL_LIBRARY"]
    names = exported("nm", library)
    assert all(name.startswith(("fmi2", "fmi3")) for name in names)
    assert len([name for name in names if name.startswith("fmi3")]) == 75
    needed = [line for line in run(["readelf", "-d", library]).stdout.splitlines() if "NEEDED" in line]
    assert len(needed) == 1 and "libc.so.6" in needed[0]
    versions = {word for word in run(["readelf", "-V", library]).stdout.split() if word.startswith("GLIBC_")}
    assert max(tuple(map(int, version[6:].split("."))) for version in versions) <= (2, 14)
