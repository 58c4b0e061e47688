"""A master in C with the standard's own headers, under sanitizers."""

import os
import pathlib
import subprocess

import fmpy
import pytest


@pytest.mark.parametrize("sanitizers", ["", "-fsanitize=address,undefined -fno-sanitize-recover=all"])
def test_a_c_master_with_the_official_headers(tmp_path, description, kernel, sanitizers):
    headers = pathlib.Path(fmpy.__file__).parent / "c-code"
    source, program = pathlib.Path(__file__).with_name("fmi2_check.c"), tmp_path / "master"
    flags = ["-std=c11", "-D_GNU_SOURCE", "-Wall", "-Wextra", "-Werror", "-g", *sanitizers.split()]
    subprocess.run(["gcc", *flags, f"-I{headers}", source, "-o", program, "-ldl", "-lm"], check=True)
    command = [program, os.environ["SOFTANVIL_LIBRARY"], description.guid]
    run = subprocess.run(command, capture_output=True, text=True)
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout.strip() == kernel(14.7)["trace_hash"]
