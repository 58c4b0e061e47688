"""The model description says what the binary does."""

import csv
import os
import pathlib
import struct
import zipfile
from math import isfinite

import pytest
from fmpy.validation import validate_fmu

from slave import Slave


def test_fmpy_validates_without_a_message(fmu):
    assert validate_fmu(fmu) == []


def test_start_values_are_the_compiled_ones_to_the_last_bit(slave, description):
    slave.fmu.enterInitializationMode()
    settable = [variable for variable in description.modelVariables if variable.start is not None]
    assert {variable.causality for variable in settable} == {"parameter", "input"}
    for variable in settable:
        if variable.type == "Boolean":
            assert slave.boolean(variable.name) == (variable.start == "true"), variable.name
            continue
        read = slave.integer if variable.type in ("Enumeration", "Integer") else slave.real
        assert struct.pack("d", read(variable.name)) == struct.pack("d", float(variable.start)), variable.name


def test_every_variable_can_be_read(slave, description):
    slave.start().run(100)
    read = {"Real": slave.real, "Integer": slave.integer, "Enumeration": slave.integer, "Boolean": slave.boolean}
    for variable in description.modelVariables:
        if variable.type == "String":
            assert int(slave.trace_hash(), 16) and len(slave.trace_hash()) == 16
        else:
            assert isfinite(read[variable.type](variable.name)), variable.name


def test_ranges_in_the_description_are_those_of_the_setters(slave, description):
    slave.fmu.enterInitializationMode()
    for variable in description.modelVariables:
        if variable.type == "Integer" and variable.start is not None:
            low, high = int(variable.min), int(variable.max)
            for legal in (low, high, int(variable.start)):
                slave.set(**{variable.name: legal})
                assert slave.integer(variable.name) == legal
            for refused in (low - 1, high + 1):
                with pytest.raises(Exception):
                    slave.set(**{variable.name: refused})
                assert slave.integer(variable.name) == int(variable.start)
        if variable.type == "Real" and variable.start is not None:
            low, high = float(variable.min), float(variable.max)
            for legal in (low, high):
                slave.set(**{variable.name: legal})
                assert slave.real(variable.name) == legal
            slave.set(**{variable.name: float(variable.start)})
            for refused in (low - 1.0, high + 1.0 + abs(high)):
                with pytest.raises(Exception):
                    slave.set(**{variable.name: refused})
                assert slave.real(variable.name) == float(variable.start)
                unit = "" if variable.unit == "1" else f" {variable.unit}"
                assert variable.name in slave.messages[-1][2] and slave.messages[-1][2].endswith(unit)


def test_quantities_have_defined_units(description):
    defined = {unit.name: unit for unit in description.unitDefinitions}
    for variable in description.modelVariables:
        if variable.type == "Real":
            assert defined[variable.unit].baseUnit is not None, variable.name
            assert variable.description


def test_references_types_and_roles_never_change(description):
    """Whoever uses the FMU names variables by these; a change here breaks his model."""
    rows = [[str(v.valueReference), v.name, v.type, v.causality, v.variability, v.unit or ""]
            for v in description.modelVariables]
    golden = pathlib.Path(__file__).with_name("variables.csv")
    with golden.open(newline="") as file:
        assert rows == list(csv.reader(file))[1:]


def test_capabilities_and_default_experiment(description):
    capable = description.coSimulation
    assert capable.canHandleVariableCommunicationStepSize
    assert capable.canGetAndSetFMUstate and capable.canSerializeFMUstate
    assert not capable.canBeInstantiatedOnlyOncePerProcess and not capable.needsExecutionTool
    experiment = description.defaultExperiment
    assert [float(experiment.startTime), float(experiment.stopTime), float(experiment.stepSize)] == [0, 0.015, 50e-6]


def test_another_guid_is_refused(folder, description):
    with pytest.raises(Exception, match="instantiate"):
        Slave(folder, description, guid="{00000000-0000-0000-0000-000000000000}")


def test_contents_of_the_archive(fmu):
    with zipfile.ZipFile(fmu) as archive:
        names = set(archive.namelist())
        assert all(info.date_time == (1980, 1, 1, 0, 0, 0) for info in archive.infolist())
        assert archive.read("model.png").startswith(b"\x89PNG")
        page = archive.read("documentation/index.html").decode()
        library = archive.read("binaries/linux64/softanvil.so")
    assert {"modelDescription.xml", "documentation/licenses/license.txt"} <= names
    assert "<code>impactor.mass</code>" in page and "<!--" not in page
    assert library == pathlib.Path(os.environ["SOFTANVIL_LIBRARY"]).read_bytes()
