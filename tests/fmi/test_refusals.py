"""What is not legal is refused with a reason in the log, and changes nothing."""

from ctypes import c_double, c_int, c_size_t, c_uint32, c_void_p, byref

import pytest
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import fmi2OK

NAN, INFINITY = float("nan"), float("inf")
UNKNOWN = 999


def step(slave, point=None, size=50e-6):
    slave.fmu.doStep(currentCommunicationPoint=slave.real("time") if point is None else point,
                     communicationStepSize=size)


def mixed(slave):
    """The first value is legal, the second is not."""
    slave.fmu.setReal([slave.references["impactor.external_force"], slave.references["impactor.driven_position"]],
                      [123.0, NAN])


# What is called in mid-impact, and what the log must say.
IN_MID_IMPACT = {
    "step is NaN": (lambda s: step(s, size=NAN), "communication step NaN s"),
    "step is infinite": (lambda s: step(s, size=INFINITY), "communication step inf s"),
    "step is negative": (lambda s: step(s, size=-50e-6), "communication step -0.00005 s is refused: expected above 0 s up to 100 s"),
    "step is zero": (lambda s: step(s, size=0.0), "expected above 0 s up to 100 s"),
    "step is huge": (lambda s: step(s, size=1e300), "expected above 0 s up to 100 s"),
    "step past the stop time": (lambda s: step(s, size=20e-3), "stop time of 0.015 s"),
    "point is NaN": (lambda s: step(s, point=NAN), "communication point NaN s"),
    "point is in the past": (lambda s: step(s, point=0.0), "where the instance is"),
    "point is in the future": (lambda s: step(s, point=1.0), "where the instance is"),
    "point is half a kernel step early": (
        lambda s: step(s, point=s.real("time") - 0.51 * s.real("model.time_step")), "where the instance is, within"),
    "point is half a kernel step late": (
        lambda s: step(s, point=s.real("time") + 0.51 * s.real("model.time_step")), "where the instance is, within"),
    "step just past the stop time": (lambda s: step(s, size=12.001e-3), "stop time of 0.015 s"),
    "parameter after initialization": (lambda s: s.set(impactor__mass=4.0), "impactor.mass = 4 [kg]"),
    "choice after initialization": (lambda s: s.set(impactor__motion=1), "impactor.motion = 1"),
    "input is NaN": (lambda s: s.set(impactor__external_force=NAN), "impactor.external_force = NaN N is refused"),
    "input is infinite": (lambda s: s.set(impactor__external_force=-INFINITY), "-inf N is refused: expected"),
    "input is out of range": (lambda s: s.set(impactor__driven_position=2.0), "expected -1 to 1 m"),
    "second of two inputs is NaN": (mixed, "impactor.driven_position = NaN m"),
    "output is set": (lambda s: s.set(contact__force=1.0), "contact.force has the causality output"),
    "time is set": (lambda s: s.set(time=1.0), "time has the causality independent"),
    "calculated parameter is set": (lambda s: s.set(model__elements=1), "calculatedParameter"),
    "unknown Real is read": (lambda s: s.fmu.getReal([UNKNOWN]), "value reference 999"),
    "unknown Integer is read": (lambda s: s.fmu.getInteger([UNKNOWN]), "value reference 999"),
    "unknown Boolean is read": (lambda s: s.fmu.getBoolean([UNKNOWN]), "value reference 999"),
    "unknown String is read": (lambda s: s.fmu.getString([UNKNOWN]), "value reference 999"),
    "unknown Real is set": (lambda s: s.fmu.setReal([UNKNOWN], [0.0]), "value reference 999"),
    "unknown Integer is set": (lambda s: s.fmu.setInteger([UNKNOWN], [0]), "value reference 999"),
    "unknown Boolean is set": (lambda s: s.fmu.setBoolean([UNKNOWN], [True]), "value reference 999"),
    "unknown String is set": (lambda s: s.fmu.setString([UNKNOWN], ["text"]), "value reference 999"),
    "Boolean output is set": (lambda s: s.fmu.setBoolean([s.references["contact.active"]], [True]), "causality output"),
    "String output is set": (lambda s: s.fmu.setString([s.references["result.trace_hash"]], ["0"]), "causality output"),
    "Real is read as Integer": (lambda s: s.integer("contact.force"), "is of type Real, not Integer"),
    "Enumeration is read as Real": (lambda s: s.real("impactor.motion"), "is of type Enumeration, not Real"),
    "setup in mid-run": (lambda s: s.fmu.setupExperiment(), "not legal between communication steps"),
    "initialization in mid-run": (lambda s: s.fmu.enterInitializationMode(), "not legal between communication steps"),
    "end of no initialization": (lambda s: s.fmu.exitInitializationMode(), "not legal between communication steps"),
    "cancelling": (lambda s: s.fmu.cancelStep(), "asynchronous step is not supported"),
    "directional derivative": (
        lambda s: s.fmu.getDirectionalDerivative([3000], [2000], [1.0]), "directional derivative is not supported"),
    "output derivative": (lambda s: s.fmu.getRealOutputDerivatives([3000], [1]), "not supported"),
    "input derivative": (lambda s: s.fmu.setRealInputDerivatives([2000], [1], [1.0]), "not supported"),
    "null state": (lambda s: s.fmu.setFMUstate(c_void_p()), "FMUState is null"),
    "no place for a state": (lambda s: s.fmu.fmi2GetFMUstate(s.fmu.component, None), "FMUState is null"),
    "no references": (
        lambda s: s.fmu.fmi2GetReal(s.fmu.component, None, c_size_t(1), (c_double * 1)()), "vr is null"),
    "no values": (
        lambda s: s.fmu.fmi2GetReal(s.fmu.component, (c_uint32 * 1)(0), c_size_t(1), None), "value is null"),
    "too many references": (
        lambda s: s.fmu.fmi2GetReal(s.fmu.component, (c_uint32 * 1)(0), c_size_t(2**63), (c_double * 1)()), "null"),
    "unknown kind of status": (
        lambda s: s.fmu.fmi2GetStatus(s.fmu.component, c_int(7), byref(c_int())), "fmi2StatusKind = 7"),
}


@pytest.mark.parametrize("case", IN_MID_IMPACT)
def test_in_mid_impact(slave, case):
    call, reason = IN_MID_IMPACT[case]
    slave.start(stop_time=15e-3).run(60)
    before = slave.bytes()
    with pytest.raises(FMICallException) as refused:
        call(slave)
    assert refused.value.status == 3
    status, category, text = slave.messages[-1]
    assert (status, category) == (3, "logStatusError")
    assert reason in text and text.startswith("fmi2")
    assert slave.bytes() == before
    slave.run(240)


# What is set in initialization mode, and what the log must say.
IN_INITIALIZATION = {
    "negative mass": ({"impactor__mass": -1.0}, "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg"),
    "mass is NaN": ({"impactor__mass": NAN}, "impactor.mass = NaN kg"),
    "mass is infinite": ({"impactor__mass": INFINITY}, "impactor.mass = inf kg"),
    "no such choice": ({"impactor__drop_by": 3}, "impactor.drop_by = 3 is refused: expected 0 to 2"),
    "too many layers": ({"layers__count": 5}, "layers.count = 5 is refused: expected 1 to 4"),
    "no layers": ({"layers__count": 0}, "layers.count = 0 is refused: expected 1 to 4"),
    "negative choice": ({"impactor__drop_by": -1}, "impactor.drop_by = -1"),
}


def test_a_value_without_effect_is_logged_as_a_warning(slave):
    slave.start(**{"layers[0].prony_tau_2": 0.1})
    warnings = [message for message in slave.messages if message[1] == "logStatusWarning"]
    assert warnings == [
        (1, "logStatusWarning", "layers[0].prony_tau_2 = 0.1 s has no effect: layers[0].prony_g_2 is 0")]
    slave.run(1)


def test_a_value_of_a_layer_that_is_not_there_is_logged_as_a_warning(slave):
    slave.start(**{"layers[2].density": 900.0})
    reason = "layers[2].density = 900 kg/m3 has no effect: layers.count is 1"
    assert (1, "logStatusWarning", reason) in slave.messages
    slave.run(1)


def test_a_layer_without_a_thickness_can_be_given_one(slave):
    slave.fmu.setupExperiment()
    slave.fmu.enterInitializationMode()
    slave.set(layers__count=3, **{"layers[1].thickness": 2e-3})
    with pytest.raises(FMICallException):
        slave.fmu.exitInitializationMode()
    assert "layers[2].thickness = 0 m is refused: expected at least 0.00001 m" in slave.messages[-1][2]
    slave.set(**{"layers[2].thickness": 1e-3})
    slave.fmu.exitInitializationMode()
    assert slave.integer("layers.count") == 3
    slave.run(1)


def test_two_values_that_state_the_same_thing_are_refused(slave):
    with pytest.raises(FMICallException):
        slave.start(impactor__drop_height=0.1, impactor__drop_energy=9.8)
    assert "state the same thing" in slave.messages[-1][2]


@pytest.mark.parametrize("case", IN_INITIALIZATION)
def test_in_initialization_mode(slave, case):
    values, reason = IN_INITIALIZATION[case]
    slave.fmu.setupExperiment()
    slave.fmu.enterInitializationMode()
    before = slave.bytes()
    with pytest.raises(FMICallException):
        slave.set(**values)
    assert reason in slave.messages[-1][2]
    assert slave.bytes() == before


def test_a_scenario_that_does_not_fit_together_can_be_corrected(slave):
    slave.fmu.setupExperiment()
    slave.fmu.enterInitializationMode()
    slave.set(**{"layers[0].prony_g_1": 0.9, "layers[0].prony_g_2": 0.9})
    for call in (lambda: slave.real("contact.force"), slave.fmu.exitInitializationMode):
        with pytest.raises(FMICallException):
            call()
        assert "sum to 1.8" in slave.messages[-1][2]
    slave.set(**{"layers[0].prony_g_2": 0.0})
    slave.fmu.exitInitializationMode()
    slave.run(1)


@pytest.mark.parametrize("start, stop", [(NAN, None), (INFINITY, None), (0.0, -1.0), (0.0, NAN), (0.0, INFINITY)])
def test_an_impossible_experiment(slave, start, stop):
    with pytest.raises(FMICallException):
        slave.fmu.setupExperiment(startTime=start, stopTime=stop)
    assert "is refused" in slave.messages[-1][2]
    slave.start().run(1)


@pytest.mark.parametrize("call", ["doStep", "terminate", "exitInitializationMode", "getReal"])
def test_a_new_instance_is_not_ready(slave, call):
    arguments = {"doStep": (0.0, 50e-6), "getReal": ([3000],)}.get(call, ())
    with pytest.raises(FMICallException):
        getattr(slave.fmu, call)(*arguments)
    assert "not legal after instantiation" in slave.messages[-1][2]
    slave.start().run(1)


def test_after_termination_results_can_be_read_and_nothing_else(slave):
    slave.start().run(60)
    slave.fmu.terminate()
    assert slave.real("contact.force") > 0
    for call in (lambda: step(slave), slave.fmu.terminate, lambda: slave.set(impactor__external_force=1.0)):
        with pytest.raises(FMICallException):
            call()
        assert "not legal after termination" in slave.messages[-1][2]


def test_messages_are_escaped_for_a_logger_that_formats(slave):
    """An unknown category is told by its place, so nothing of the caller's gets into a format."""
    with pytest.raises(FMICallException):
        slave.fmu.setDebugLogging(True, ["%s%n#r1#"])
    assert "%" not in slave.messages[-1][2]


def test_changes_of_mode_are_told_only_when_asked(another):
    silent, talking = another(), another(logging=True)
    for slave in (silent, talking):
        slave.start().run(1)
    assert silent.messages == []
    assert [category for _, category, _ in talking.messages] == ["logEvents"] * len(talking.messages) != []
    talking.fmu.setDebugLogging(False, [])
    told = len(talking.messages)
    talking.fmu.reset()
    assert len(talking.messages) == told


@pytest.mark.parametrize("steps, complete", [(60, 0.0), (300, 1.0)])
def test_a_run_that_ends_in_contact_says_so(slave, steps, complete):
    slave.start().run(steps)
    assert slave.real("result.peak_force") > 0.0 and slave.real("result.complete") == complete
    told = len(slave.messages)
    slave.fmu.terminate()
    warnings = [(status, category) for status, category, text in slave.messages[told:] if "in contact" in text]
    assert warnings == ([] if complete else [(1, "logStatusWarning")])
    assert slave.real("result.complete") == complete


def test_status_inquiries(slave):
    slave.start().run(3)
    status, time, flag = c_int(), c_double(), c_int()
    assert slave.fmu.fmi2GetRealStatus(slave.fmu.component, c_int(2), byref(time)) == fmi2OK
    assert time.value == slave.real("time")
    assert slave.fmu.fmi2GetStatus(slave.fmu.component, c_int(0), byref(status)) == fmi2OK
    assert status.value == fmi2OK
    assert slave.fmu.fmi2GetBooleanStatus(slave.fmu.component, c_int(3), byref(flag)) == fmi2OK
    assert flag.value == 0
