"""The commands of the command line as functions: the same numbers, the same options."""

import inspect
import json

import numpy as np
import pytest

import softanvil as sa


def told(*arguments):
    return json.loads(sa._softanvil.command([*map(str, arguments), "--json"]))


@pytest.fixture
def trace(tmp_path):
    """A trace as an instrument writes it, of a drop of 9.8 J."""
    result = sa.run(sa.preset("study").update({"impactor.energy": 9.8}))
    path = tmp_path / "trace.csv"
    rows = "".join(f"{1e3 * time:.4f};{1e-3 * force:.6f}\n" for time, force in result.trace["contact.force"].items())
    path.write_text("time [ms];force [kN]\n" + rows)
    return path


#: Options of the command line that are another argument in Python, or that it has no use for.
OTHERS = {
    "measure": {"preset", "scenario", "material", "set", "energy", "height", "speed", "duration", "csv", "plot", "json",
                "overwrite"},
    "protect": {"preset", "scenario", "material", "set", "energy", "height", "speed", "duration", "out", "pictures", "json",
                "overwrite"},
    "reduction": {"preset", "scenario", "material", "set", "energy", "height", "speed", "duration", "json", "PARAMETER=LIST"},
    "fit": {"paper", "pictures", "json"},
    "calibrate": {"PROBLEM", "material_weights"},  # material_front
}


@pytest.mark.parametrize("name", OTHERS)
def test_every_option_of_the_command_line_is_an_argument(name):
    options = {option.replace("-", "_") for option, _ in sa._softanvil.command_options(name)} - OTHERS[name]
    arguments = inspect.signature(getattr(sa, name)).parameters
    assert options - arguments.keys() == set() and arguments.keys() - options <= {"scenario", "problem", "parameters"}
    for option in options:
        assert option in getattr(sa, name).__doc__


def test_reduction_is_that_of_the_command_line(tmp_path):
    scenario = sa.preset("study").update({"mesh.element_size": "7.5 mm"})
    found = sa.reduction(scenario, {"impactor.drop_energy": [9.8]}, plot=tmp_path / "energies.svg")
    line = told("reduction", "impactor.drop_energy=9.8", "--set", "mesh.element_size=0.0075")
    assert found.data["cases"] == line["cases"] and (tmp_path / "energies.svg").is_file()
    assert found.table["impactor.drop_energy [J]"].tolist() == [9.8, 14.7]
    assert found.table["peak_force of the solid"][1] == line["cases"][1]["solid"]["peak_force"]
    assert found._repr_html_().startswith("<table")
    assert sa.reduction(scenario, {"impactor.drop_energy": 9.8}).data == found.data
    with pytest.raises(sa.FileError, match="overwrite"):
        sa.reduction(scenario, plot=tmp_path / "energies.svg")


def test_measure_is_that_of_the_command_line(trace):
    scenario = sa.preset("study").update({"impactor.energy": 9.8})
    measured = sa.measure(scenario, trace=trace, cfc=600.0, noise=2.0)
    line = told("measure", "--energy", "9.8", "--trace", trace, "--cfc", "600", "--noise", "2")
    for key in ("peak_force", "impulse", "comparison", "channels", "trace_hash"):
        assert measured[key] == line[key]
    assert list(measured.trace.columns) == ["force", "measured force"]
    assert np.nanmax(measured.trace["measured force"]) == pytest.approx(4090, rel=0.01)
    with pytest.raises(sa.FileError, match="noise = -1 N is refused"):
        sa.measure(scenario, noise=-1.0)
    with pytest.raises(sa.FileError, match="nothing.csv"):
        sa.measure(scenario, trace="nothing.csv")


def test_traces_are_read(trace, tmp_path):
    read = sa.read_trace(trace)
    assert read["force"].max() == pytest.approx(4093.1, abs=0.1) and read.attrs["units"] == {"time": "s", "force": "N"}
    assert read.attrs["read_as"]
    bare = tmp_path / "bare.csv"
    bare.write_text("\n".join(trace.read_text().splitlines()[1:]))
    with pytest.raises(sa.FileError, match="name them by number, such as time"):
        sa.read_trace(bare)
    named = sa.read_trace(bare, time="1 [ms]", force_column="2 [kN]")
    assert (named["force"] == read["force"]).all()
    with pytest.raises(sa.FileError, match="mass = five is refused: expected a positive number with its unit"):
        sa.read_trace(trace, mass="five")
    with pytest.raises(sa.FileError, match="cannot|No such"):
        sa.read_trace(tmp_path / "none.csv")
    # Numbers are in SI units: samples of 50 us.
    forces = tmp_path / "forces.csv"
    forces.write_text("force [N]\n" + "\n".join(map(str, read["force"])))
    assert (sa.read_trace(forces, rate=20_000)["force"] == sa.read_trace(forces, rate="20kHz")["force"]).all()
    with pytest.raises(TypeError, match="trace of type DataFrame is refused"):
        sa.measure(sa.preset("study"), trace=read)


def test_a_fit_gives_a_material(root, tmp_path):
    data = root / "data/treloar"
    files = {"uniaxial": data / "uniaxial.csv", "equibiaxial": [data / "equibiaxial.csv"]}
    found = sa.fit(**files, law="yeoh_3", out=tmp_path / "fit")
    line = told("fit", "--uniaxial", data / "uniaxial.csv", "--equibiaxial", data / "equibiaxial.csv", "--law", "yeoh_3")
    assert found.law == "yeoh_3" and found["laws"] == line["laws"] and "material.toml" in found.files
    assert found.laws["law"].tolist() == [law["law"] for law in line["laws"]]
    scenario = sa.preset("elastic").with_material(found.material)
    assert scenario.silicone.law == "yeoh" and scenario == sa.preset("elastic").with_material(tmp_path / "fit/material.toml")
    scenario.silicone.density = 1000.0
    assert sa.run(scenario).complete
    with pytest.raises(sa.FileError, match="there is nothing to fit"):
        sa.fit()
    with pytest.raises(sa.ScenarioError, match="in a material"):
        sa.preset("study").with_material("[impactor]\nmass = 4.0\n")


def test_a_pad_is_judged(tmp_path):
    anvil = sa.preset("study").update({"mesh.element_size": "6 mm", "impactor.energy": "4.9 J"})
    anvil.layers.add("pad", law="neo_hookean", c10="100 kPa", thickness="6 mm")
    verdict = sa.protect(anvil, thickness=["6 mm", 9e-3])
    assert verdict.table.index.tolist()[0] == "bare" and verdict.table["thickness"].tolist()[1:] == [6e-3, 9e-3]
    assert (verdict.table["peak_transmitted_force"].iloc[1:] < verdict.table["peak_transmitted_force"].iloc[0]).all()
    assert "<table" in verdict._repr_html_()
    anvil.write(tmp_path / "pad.toml")
    line = told("protect", "--scenario", tmp_path / "pad.toml", "--thickness", "6 mm", "0.009m")
    assert verdict["pads"] == line["pads"] and verdict["bare"] == line["bare"]
    with pytest.raises(sa.FileError, match="thickness"):
        sa.protect(anvil, thickness="10")


def test_a_standard_judges_a_pad(tmp_path):
    protector = sa.preset("en1621-1").update({"mesh.element_size": "4 mm"})
    limits = {"level 1": 35e3, "level 2": 20e3}
    for thickness, judgement, level in ((20e-3, "pass", "level 2"), (7e-3, "fail", "level 1")):
        scenario = protector.copy().update({"pad.thickness": thickness})
        scenario.write(tmp_path / "pad.toml")
        verdict = sa.protect(scenario)
        line = told("protect", "--preset", "en1621-1", "--scenario", tmp_path / "pad.toml")
        assert (verdict["standard"], verdict["pads"]) == (line["standard"], line["pads"]) and verdict["bare"] is line["bare"] is None
        assert {limit["level"]: limit["below"] for limit in verdict["standard"]["limits"]} == limits
        [row] = verdict.table.itertuples()
        assert (row.Index, row.verdict, row.level, row.thickness) == ("pad", judgement, level, thickness)
        assert row.peak_transmitted_force == verdict["pads"][0]["peak_transmitted_force"]
        assert (row.peak_transmitted_force < limits[level]) == (judgement == "pass")
    other = sa.protect(protector.copy().update({"impactor.energy": "40 J"}))
    assert other.table.loc["pad", "verdict"] == "other_test" and "4.000 m/s" in other["pads"][0]["verdict"]["changed"][0]


def test_a_foam_gives_a_pad(root):
    data = root / "data/foam"
    foam = sa.fit(uniaxial=data / "compression.csv", foam=True)
    assert foam.law.startswith("foam") and sa.preset("en1621-1").with_material(foam.material).pad.law == "hyperfoam"


def test_what_impacts_and_material_tests_cost_each_other(root, tmp_path):
    table = sa.material_front(root / "calibration/material-tests.toml", [0, 1], out=tmp_path / "out", evaluations=40)
    assert list(table.columns) == ["weight", "mean_error", "worst_error", "distance", "farthest", "converged"]
    assert table.attrs["units"] == {"weight": "1", "mean_error": "%", "worst_error": "%", "distance": "1", "farthest": "1"}
    assert list(table["weight"]) == [0, 1] and not table["converged"].any() and (table["mean_error"] > 0).all()
    with pytest.raises(sa.FileError, match="no .*material_test.* counts"):
        sa.material_front(root / "calibration/all.toml", [1], out=tmp_path / "none")


def test_a_calibration_goes_on_where_it_ended(root, tmp_path):
    problem = root / "calibration/only-14.7.toml"
    first = sa.calibrate(problem, out=tmp_path / "out", evaluations=20)
    more = sa.calibrate(problem, out=tmp_path / "out", evaluations=40)
    assert len(first.evaluations) == 20 and len(more.evaluations) == 40
    assert more.evaluations.iloc[:20].equals(first.evaluations)
    assert more.summary["score"] <= first.summary["score"]
    assert sa.run(more.scenario).complete and "Score" in repr(more)
    with pytest.raises(sa.FileError, match="none.toml"):
        sa.calibrate(tmp_path / "none.toml", out=tmp_path / "other")
