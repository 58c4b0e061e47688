"""Saving, restoring, resetting, and several instances at once."""

from concurrent.futures import ThreadPoolExecutor
from ctypes import byref

import pytest
from fmpy.fmi1 import FMICallException

from slave import STEP

HALF, WHOLE = 60, 300


@pytest.fixture
def uninterrupted(another):
    """Results of a run without interruption."""
    return another().start().run(WHOLE).results()


def test_going_back_in_mid_impact_gives_the_same_end(slave, uninterrupted):
    slave.start().run(HALF)
    assert slave.boolean("contact.active")
    state = slave.fmu.getFMUstate()
    there = slave.results()
    for _ in range(2):
        assert slave.run(WHOLE - HALF).results() == uninterrupted
        slave.fmu.setFMUstate(state)
        assert slave.results() == there
        assert slave.real("time") == pytest.approx(HALF * STEP)
    slave.fmu.freeFMUstate(state)


def test_another_instance_continues_from_the_bytes(slave, another, uninterrupted):
    data = slave.start(impactor__drop_energy=14.7).run(HALF).bytes()
    other = another()
    other.restore(data)
    assert other.run(WHOLE - HALF).results() == uninterrupted


def test_the_bytes_carry_the_parameters(slave, another):
    data = slave.start(impactor__mass=4.0, mesh__element_size=4e-3).run(HALF).bytes()
    other = another().start()
    other.restore(data)
    assert other.real("impactor.mass") == 4.0
    assert other.run(WHOLE - HALF).results() == slave.run(WHOLE - HALF).results()


def test_equal_states_have_equal_bytes(slave, another):
    assert slave.start().run(HALF).bytes() == another().start().run(HALF // 2, 2 * STEP).bytes()


def test_a_handle_is_used_again(slave):
    slave.start().run(HALF)
    state = slave.fmu.getFMUstate()
    address = state.value
    slave.run(1)
    slave.fmu.fmi2GetFMUstate(slave.fmu.component, byref(state))
    assert state.value == address
    assert bytes(slave.fmu.serializeFMUstate(state)) == slave.bytes()
    slave.fmu.freeFMUstate(state)
    assert state.value is None
    slave.fmu.freeFMUstate(state)


@pytest.mark.parametrize("mode", ["new", "initialization", "terminated"])
def test_other_modes_are_saved_too(slave, another, mode):
    if mode == "initialization":
        slave.fmu.enterInitializationMode()
    elif mode == "terminated":
        slave.start().run(HALF).fmu.terminate()
    data = slave.bytes()
    other = another()
    other.restore(data)
    assert other.bytes() == data
    if mode == "new":
        other.start()
    elif mode == "initialization":
        other.fmu.exitInitializationMode()
    else:
        assert other.results() == slave.results()


def test_bytes_that_are_no_state_are_refused(slave):
    slave.start().run(HALF)
    data = slave.bytes()
    before = slave.results()
    altered = [data[:i] + bytes([data[i] ^ 1]) + data[i + 1:] for i in range(0, len(data), 997)]
    shortened = [data[:n] for n in (0, 1, 8, 64, len(data) // 2, len(data) - 8, len(data) - 1)]
    for bad in [*altered, *shortened, data + bytes(8), bytes(len(data)), b"\xff" * 4096]:
        with pytest.raises(FMICallException):
            slave.restore(bad)
        assert slave.messages[-1][1] == "logStatusError"
    assert slave.results() == before
    slave.restore(data)


def test_reset_gives_a_new_instance(slave, uninterrupted):
    slave.start(impactor__mass=3.0, mesh__element_size=4e-3).run(HALF)
    slave.set(impactor__external_force=500.0)
    slave.fmu.reset()
    assert slave.start().run(WHOLE).results() == uninterrupted
    slave.fmu.reset()
    assert slave.start().run(WHOLE).results() == uninterrupted


def test_reset_after_an_unstable_run(slave, uninterrupted):
    """A step that is stable at rest is above the limit of the compressed layer."""
    slave.start(time__step_by=1, time__step=5e-6, impactor__drop_energy=1e3, impactor__mass=5.0)
    with pytest.raises(FMICallException):
        slave.run(WHOLE)
    status, category, text = slave.messages[-1]
    assert (status, category) == (3, "logStatusError")
    assert "element" in text and " s" in text
    with pytest.raises(FMICallException):
        slave.run(1)
    with pytest.raises(FMICallException):
        slave.fmu.getFMUstate()
    slave.real("result.peak_force")
    slave.fmu.reset()
    assert slave.start().run(WHOLE).results() == uninterrupted


def test_two_instances_interleaved_do_not_know_of_each_other(another):
    energies = [14.7, 4.9]
    alone = [another().start(impactor__drop_energy=energy).run(WHOLE).results() for energy in energies]
    pair = [another().start(impactor__drop_energy=energy) for energy in energies]
    for _ in range(WHOLE // 10):
        pair[0].run(10)
        pair[1].run(5).run(5)
    assert [slave.results() for slave in pair] == alone


def test_eight_instances_in_eight_threads(another, uninterrupted):
    slaves = [another().start() for _ in range(8)]
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(lambda slave: slave.run(WHOLE).results(), slaves)) == [uninterrupted] * 8
