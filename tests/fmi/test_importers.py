"""Importers and a checker that others wrote: what each computes for the three drops is what the kernel computes, to the last
bit."""

import subprocess
import sys
from pathlib import Path

import pytest
from fmpy import read_model_description, simulate_fmu
from fmpy.validation import validate_fmu
from fmuloader.fmi2 import Fmi2Slave, Fmi2Type
from fmuloader.fmi3 import Fmi3Slave
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

from slave import STEP

ENERGIES = [14.7, 9.8, 4.9]
STEPS = 300
ENERGY, PEAK, IMPULSE, HASH = 1014, 3007, 3010, 5001


def numbers(kernel, energy):
    return [kernel(energy)["peak_force"], kernel(energy)["impulse"]]


@pytest.mark.parametrize("energy", ENERGIES)
def test_fmuloader_fmi2(folder, description, kernel, energy):
    with Fmi2Slave(folder, model_identifier="softanvil") as slave:
        slave.instantiate("impact", Fmi2Type.CO_SIMULATION, guid=description.guid)
        slave.setup_experiment(start_time=0.0)
        slave.set_real([ENERGY], [energy])
        slave.enter_initialization_mode()
        slave.exit_initialization_mode()
        for i in range(STEPS):
            slave.do_step(i * STEP, STEP)
        assert slave.get_string([HASH]) == [kernel(energy)["trace_hash"]]
        assert slave.get_real([PEAK, IMPULSE]) == numbers(kernel, energy)
        slave.terminate()


@pytest.mark.parametrize("energy", ENERGIES)
def test_fmuloader_fmi3(fmu3, description, kernel, energy):
    with Fmi3Slave(fmu3, model_identifier="softanvil") as slave:
        slave.instantiate_co_simulation("impact", instantiation_token=description.guid)
        slave.set_float64([ENERGY], [energy])
        slave.enter_initialization_mode()
        slave.exit_initialization_mode()
        for i in range(STEPS):
            slave.do_step(i * STEP, STEP)
        assert slave.get_string([HASH]) == [kernel(energy)["trace_hash"]]
        assert slave.get_float64([PEAK, IMPULSE]) == numbers(kernel, energy)
        slave.terminate()


@pytest.mark.parametrize("energy", ENERGIES)
def test_ecos(fmu, kernel, energy):
    ecospy = pytest.importorskip("ecospy", exc_type=OSError, reason="ecospy needs Debian's libtbb12")
    from ecospy.EcosParameterSet import EcosParameterSet

    with ecospy.EcosSimulationStructure() as structure, EcosParameterSet() as parameters:
        structure.add_model("impact", fmu)
        parameters.add_real("impact::impactor.drop_energy", energy)
        structure.add_parameter_set("drop", parameters)
        with ecospy.EcosSimulation(structure=structure, step_size=STEP) as simulation:
            simulation.init(parameter_set="drop")
            simulation.step(STEPS)
            found = [simulation.get_real(f"impact::result.{name}") for name in ("peak_force", "impulse")]
            assert found == numbers(kernel, energy)
            simulation.terminate()


@pytest.mark.parametrize("energy", ENERGIES)
def test_libcosim(fmu, kernel, energy):
    execution = CosimExecution.from_step_size(step_size=STEP * 1e9)
    slave = CosimLocalSlave(fmu_path=fmu, instance_name="impact")
    index = execution.add_local_slave(local_slave=slave)
    execution.real_initial_value(slave_index=index, variable_reference=ENERGY, value=energy)
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer=observer)
    assert execution.step(step_count=STEPS)
    found = observer.last_real_values(slave_index=index, variable_references=[PEAK, IMPULSE])
    assert list(found) == numbers(kernel, energy)


@pytest.mark.parametrize("energy", ENERGIES)
@pytest.mark.parametrize("events, early_return", [(False, False), (True, False), (True, True)])
def test_fmpy_fmi3(fmu3, kernel, energy, events, early_return):
    """With event mode there are rows at events besides those of the communication points."""
    rows = simulate_fmu(fmu3, start_values={"impactor.drop_energy": energy}, output_interval=STEP,
                        output=["result.peak_force", "result.impulse", "surface.height"],
                        use_event_mode=events, early_return_allowed=early_return)
    assert [rows["result.peak_force"][-1], rows["result.impulse"][-1]] == numbers(kernel, energy)
    assert (len(rows) > STEPS + 1) == events and rows["surface.height"].shape[1:] == (25,)
    assert rows["surface.height"].min() < -5e-3


@pytest.mark.parametrize("version", ["fmu", "fmu3"])
def test_fmpys_defaults(request, kernel, version):
    """The default experiment as the importer runs it by itself, and in 500 steps."""
    path = request.getfixturevalue(version)
    for options in ({}, {"output_interval": 15e-3 / 500}):
        rows = simulate_fmu(path, output=["result.peak_force", "result.impulse"], **options)
        assert [rows["result.peak_force"][-1], rows["result.impulse"][-1]] == numbers(kernel, 14.7)


@pytest.mark.parametrize("size", [30e-6, 1 / 60, 1e-6 * 2**0.5])
@pytest.mark.parametrize("events, early_return", [(False, False), (True, False), (True, True)])
def test_fmpy_fmi3_in_steps_of_any_length(fmu3, kernel, size, events, early_return):
    stop = round(16e-3 / size + 0.5) * size
    rows = simulate_fmu(fmu3, output_interval=size, stop_time=stop, output=["result.peak_force", "model.time"],
                        use_event_mode=events, early_return_allowed=early_return)
    assert rows["result.peak_force"][-1] == kernel(14.7)["peak_force"]
    assert max(abs(rows["model.time"] - rows["time"])) <= 0.5 * kernel(14.7)["dt"] + 1e-14


@pytest.mark.parametrize("version", ["fmu", "fmu3"])
def test_checkers_find_nothing(request, version):
    path = request.getfixturevalue(version)
    assert validate_fmu(path) == []
    tool = Path(sys.executable).with_name("fmutool")
    checked = subprocess.run([tool, "-input", path, "-check"], capture_output=True, text=True)
    said = checked.stdout + checked.stderr
    assert checked.returncode == 0 and "seems to be compliant" in said and "No semantic error" in said, said


def test_both_versions_describe_the_same_variables(description, fmu3):
    second = {v.name: (v.valueReference, v.causality, v.variability, v.unit, v.start) for v in description.modelVariables}
    third = {v.name: (v.valueReference, v.causality, v.variability, v.unit, v.start)
             for v in read_model_description(fmu3).modelVariables}
    assert second == {name: third[name] for name in second}
    assert set(third) - set(second) == {
        "surface.points", "surface.x", "surface.height", "surface.contact_pressure"}
