"""The package gives the bits of the golden traces, in every scene and at every record."""

import pytest

import softanvil as sa
from scenes import SAMPLES_PER_RECORD, SCENES


@pytest.mark.parametrize("name", SCENES)
def test_every_record_has_the_bits_of_the_trace(root, name):
    lines = (root / "tests/golden/traces" / f"{name}.txt").read_text().splitlines()
    records = [line.split() for line in lines if not line.startswith("#")]
    make, advance = SCENES[name]
    scenario = make()
    sim = sa.Simulation(scenario)
    each = round(SAMPLES_PER_RECORD * 50e-6 / sim.time_step)
    for step, force, position, digest in records:
        while sim.step_index < int(step):
            advance(sim)
        assert sim["contact.force_step"] == float(force), (name, step)
        assert sim["impactor.position"] == float(position), (name, step)
        assert sim.digest == digest, (name, step)
    assert sim.step_index == each * (len(records) - 1)


def test_a_run_and_the_command_line_have_the_same_hash():
    import json

    scenario = sa.preset("study")
    scenario.impactor.energy = 9.8
    told = json.loads(sa._softanvil.command(["run", "--energy", "9.8", "--json"]))
    result = sa.run(scenario)
    assert result.trace_hash == told["trace_hash"]
    assert result.peak_force == told["peak_force"] and result["energy.elastic"] == told["energy_elastic"]
