"""The package itself: its stubs are those of the kernel's tables, type checkers agree, and it is built as the workspace is."""

import importlib.metadata
import importlib.util
import platform
import re
import subprocess
import sys
import tomllib

import softanvil as sa


def test_the_version_is_that_of_the_workspace(root):
    version = tomllib.loads((root / "Cargo.toml").read_text())["workspace"]["package"]["version"]
    assert sa.__version__ == version == importlib.metadata.version("softanvil")


def test_kernel_and_target_are_stated(root):
    stated = re.search("KERNEL_DIGEST: u64 = 0x([0-9a-f_]+)", (root / "kernel/src/identity.rs").read_text())
    assert sa.kernel_digest == stated[1].replace("_", "")
    assert sa.target.split("-")[:2] == [{"AMD64": "x86_64"}.get(platform.machine(), platform.machine()), sys.platform]


def test_stubs_are_those_of_the_tables(root):
    sys.path.insert(0, str(root / "python"))
    try:
        import stubs
    finally:
        sys.path.pop(0)
    for name, text in stubs.STUBS.items():
        assert (root / "python/softanvil" / name).read_text() == text(), f"python python/stubs.py renews {name}"


def test_it_is_built_as_the_workspace_is(root):
    """With its profiles, and what it has of others is what the other tests have tried."""
    manifest = tomllib.loads((root / "python/Cargo.toml").read_text())
    assert "python" in tomllib.loads((root / "Cargo.toml").read_text())["workspace"]["members"]
    assert "profile" not in manifest and "workspace" not in manifest and not (root / "python/Cargo.lock").exists()


def test_modules_import_each_other_one_way(root, tmp_path):
    found = importlib.util.spec_from_file_location("imports", root / "tests/imports.py")
    imports = importlib.util.module_from_spec(found)
    found.loader.exec_module(imports)
    assert imports.check(root / "python/softanvil") == []
    package = tmp_path / "circle"
    package.mkdir()
    (package / "_compiled.pyi").touch()
    (package / "__init__.py").write_text("from . import _compiled\nfrom ._a import a\n")
    (package / "_a.py").write_text("from . import _b, _compiled\n")
    (package / "_b.py").write_text("import numpy\n")
    assert imports.check(package) == []
    late = {"from ._a import a": "_a, _b", "import circle._a": "_a, _b", "import circle": "__init__, _a, _b"}
    for line, circle in late.items():
        (package / "_b.py").write_text(f"def b():\n    {line}\n")
        assert imports.check(package) == [f"{package}: modules import each other: {circle}"]


def test_every_public_name_is_documented():
    for name in sa.__all__:
        item = getattr(sa, name)
        assert item.__doc__ and name in dir(sa)
        for member in dir(item) if isinstance(item, type) else []:
            value = getattr(item, member)
            if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                assert value.__doc__, f"{name}.{member}"


def check(root, *arguments):
    done = subprocess.run([sys.executable, "-m", *arguments], cwd=root / "python", capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_mypy_agrees(root):
    # What it makes of the stubs of pandas takes half a minute, and is kept.
    cache = root / "target/python/mypy"
    check(root, "mypy", "--strict", "--warn-unused-ignores", "--cache-dir", str(cache), "softanvil", "tests/typed.py")


def test_pyright_agrees(root):
    check(root, "pyright", "--pythonpath", sys.executable)


def test_the_stub_of_the_compiled_part_is_true(root):
    check(root, "mypy.stubtest", "--mypy-config-file", "tests/stubtest.ini", "softanvil._softanvil")


def test_base_needs_nothing_that_is_optional():
    optional = ["pint", "pyvista", "distributed", "dask", "pyarrow", "tqdm", "SALib", "scipy"]
    script = f"import sys; [sys.modules.__setitem__(name, None) for name in {optional}]\nimport softanvil as sa\n" \
             "s = sa.preset('study'); s.impactor.energy = '9.8 J'; sa.run(s).trace; sa.sweep(s, {'impactor.energy': [4.9]})"
    subprocess.run([sys.executable, "-c", script], check=True)
