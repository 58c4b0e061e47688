"""Simulations by hand: steps, a driven face, states that are saved."""

import copy
import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import softanvil as sa


@pytest.fixture
def driven():
    return sa.preset("study").update({"impactor.motion": "driven"})


def test_steps_and_runs_have_the_same_bits():
    scenario = sa.preset("study")
    whole, steps = sa.run(scenario), sa.Simulation(scenario)
    steps.run(scenario.time.duration)
    assert steps.trace_hash == whole.trace_hash and steps.time == scenario.time.duration
    single = sa.Simulation(scenario)
    for _ in range(50):
        single.step()
    many = sa.Simulation(scenario)
    many.step(50)
    assert single.digest == many.digest and single.step_index == 50


@given(st.lists(st.integers(0, 400), min_size=1, max_size=6), st.sampled_from(["copy", "pickle", "save", "view"]))
@settings(max_examples=25, deadline=None)
def test_however_it_is_cut_it_goes_on_with_the_same_bits(parts, how):
    sim = sa.Simulation(sa.preset("study"))
    for part in parts:
        sim.step(part)
        if how == "copy":
            sim = copy.deepcopy(sim)
        elif how == "pickle":
            sim = pickle.loads(pickle.dumps(sim))
        elif how == "view":
            sim = sa.Simulation.of_state(pickle.loads(pickle.dumps(sim.state)))
        else:
            state = sim.save()
            sim = sa.Simulation(sim.scenario)
            sim.restore(state)
    whole = sa.Simulation(sa.preset("study"))
    whole.step(sum(parts))
    assert sim.digest == whole.digest and sim.time == whole.time


def test_arrays_do_not_change_when_the_simulation_goes_on():
    sim = sa.Simulation(sa.preset("study"))
    sim.run(3e-3)
    state, velocity = sim.state, sim.field("node.velocity")
    before, digest = velocity.copy(), sim.digest
    other = sim.copy()
    sim.run(1e-3)
    assert (velocity == before).all() and not (sim.field("node.velocity") == before).all()
    assert state.time == pytest.approx(3e-3) and other.digest == digest
    assert velocity.flags.owndata is False


def test_a_driven_face_in_arrays_is_the_same_as_call_by_call(driven):
    position = -3e-3 * np.sin(np.linspace(0, np.pi, 40)) ** 2
    velocity = np.gradient(position, 1e-4)
    rows, calls = sa.Simulation(driven), sa.Simulation(driven)
    each = round(1e-4 / rows.time_step)
    table = rows.drive(position, velocity, steps=each, outputs=["contact.force", "impactor.position"])
    forces = []
    for x, v in zip(position, velocity, strict=True):
        calls.step(each, position=x, velocity=v)
        forces.append(calls["contact.force"])
    assert rows.digest == calls.digest and table["contact.force"].tolist() == forces
    assert table["impactor.position"].to_numpy() == pytest.approx(position, abs=1e-15)
    assert table.index[-1] == calls.time and table.attrs["units"]["contact.force"] == "N"
    assert table["contact.force"].max() > 1000


def test_a_call_without_a_position_is_one_way_however_long(driven):
    """A velocity alone leaves the face where it is and sets how it arrives there."""
    whole, through_rows = sa.Simulation(driven), sa.Simulation(driven)
    for sim in (whole, through_rows):
        sim.step(100, position=-1e-3, velocity=-0.5)
    # More than what Ctrl-C waits for.
    whole.step(20_001, velocity=0.1)
    through_rows.drive(velocity=np.array([0.1]), steps=20_001, outputs=["impactor.position"])
    assert whole.digest == through_rows.digest


def test_a_force_is_an_array_too():
    sim = sa.Simulation(sa.preset("study"))
    table = sim.drive(external_force=np.linspace(0, 50, 30), outputs=["impactor.velocity"])
    assert len(table) == 30 and sim.step_index == 30


def test_inputs_that_are_refused_change_nothing(driven):
    sim = sa.Simulation(driven)
    before = sim.digest
    with pytest.raises(sa.ParameterError) as caught:
        sim.step(position=-5.0)
    assert (caught.value.name, caught.value.unit, caught.value.minimum) == ("impactor.driven_position", "m", -1.0)
    with pytest.raises(ValueError, match="steps = -1 is refused"):
        sim.step(-1)
    with pytest.raises(ValueError, match=r"shape \(2, 2\)"):
        sim.drive(np.zeros((2, 2)))
    with pytest.raises(ValueError, match="broadcast"):
        sim.drive(np.zeros(3), np.zeros(2))
    with pytest.raises(sa.ScenarioError, match="output \"force\" is unknown"):
        sim.drive([0.0], outputs=["force"])
    with pytest.raises(sa.ParameterError, match="duration = 0 s is refused"):
        sim.run(0)
    assert sim.digest == before and sim.step_index == 0


def test_a_failed_simulation_says_so_until_it_is_reset(driven):
    sim = sa.Simulation(driven)
    with pytest.raises(sa.SimulationError):
        sim.step(2000, position=-0.05)
    with pytest.raises(sa.SimulationError):
        sim.step()
    with pytest.raises(sa.SimulationError):
        sim.save()
    sim.reset()
    sim.step()
    assert sim.step_index == 1


def test_states_of_another_model_are_refused():
    sim = sa.Simulation(sa.preset("study"))
    digest = sim.digest
    for state in (b"", b"softanvil", sa.Simulation(sa.preset("elastic")).save()):
        with pytest.raises(sa.SimulationError):
            sim.restore(state)
    assert sim.digest == digest


def test_another_impact_on_the_same_anvil():
    scenario = sa.preset("elastic").update({"silicone.softening_r": 1.5, "silicone.softening_m": "20 kPa"})
    sim = sa.Simulation(scenario)
    sim.run(scenario.time.duration)
    first = sim.outputs()
    sim.next_impact(1.0)
    sim.run(scenario.time.duration)
    assert sim["result.max_deformation"] > first["result.max_deformation"]
    assert "Simulation at" in repr(sim)
