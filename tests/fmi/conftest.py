"""The FMU under test, and the kernel's own results to compare it with."""

import json
import os
import subprocess

import pytest
from fmpy import extract, read_model_description

from slave import Slave


@pytest.fixture(scope="session")
def fmu():
    """Path of the FMU."""
    return os.environ["SOFTANVIL_FMU"]


@pytest.fixture(scope="session")
def fmu3():
    """Path of the FMU of FMI 3.0."""
    return os.environ["SOFTANVIL_FMU3"]


@pytest.fixture(scope="session")
def description(fmu):
    return read_model_description(fmu)


@pytest.fixture(scope="session")
def folder(fmu, tmp_path_factory):
    """The FMU unpacked, in a folder whose name is no plain one."""
    return extract(fmu, str(tmp_path_factory.mktemp("a folder with späces 100%20")))


@pytest.fixture
def slave(folder, description):
    """A new instance."""
    with Slave(folder, description) as slave:
        yield slave


@pytest.fixture
def another(folder, description):
    """Makes further instances, which end with the test."""
    made = []

    def make(**options):
        made.append(Slave(folder, description, name=f"another {len(made)}", **options))
        return made[-1]

    yield make
    for slave in made:
        slave.__exit__()


@pytest.fixture(scope="session")
def kernel():
    """The command line's results of a drop with a given energy in J, and other settings."""
    known = {}

    def run(energy, *settings):
        if (energy, settings) not in known:
            command = [os.environ["SOFTANVIL_CLI"], "run", "--energy", str(energy), "--json"]
            command += [word for setting in settings for word in ("--set", setting)]
            said = subprocess.run(command, check=True, capture_output=True, text=True).stdout
            known[energy, settings] = json.loads(said)
        return known[energy, settings]

    return run
