"""Scenarios: attributes, units, what is given, refusals, TOML, copies."""

import copy
import math
import pickle

import numpy as np
import pint
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import softanvil as sa
from softanvil import _softanvil

ROWS = [row for row in _softanvil.parameters() if row["name"] != "layers.count"]
QUANTITIES = [row for row in ROWS if row["kind"] == "quantity"]


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["name"])
def test_every_parameter_of_the_table_is_an_attribute(row):
    s = sa.preset("study")
    group = s.layers[0] if row["group"] == "layers" else getattr(s, row["group"])
    value = getattr(group, row["field"])
    assert value == s[row["name"]]
    assert type(value) is {"quantity": float, "count": int, "choice": str}[row["kind"]]
    descriptor = getattr(type(group), row["field"])
    assert row["description"] in descriptor.__doc__ and descriptor.unit == row["unit"]
    for label in row["labels"]:
        setattr(group, row["field"], label)
        assert getattr(group, row["field"]) == label


@given(st.data())
@settings(max_examples=200, deadline=None)
def test_what_is_in_range_is_taken_and_what_is_not_changes_nothing(data):
    row = data.draw(st.sampled_from(QUANTITIES))
    s = sa.preset("study")
    before = s.copy()
    value = data.draw(st.floats(width=64))
    if row["minimum"] <= value <= row["maximum"]:
        s[row["name"]] = value
        assert s[row["name"]] == value and pickle.loads(pickle.dumps(s)) == s
    else:
        with pytest.raises(sa.ParameterError) as caught:
            s[row["name"]] = value
        error = caught.value
        assert (error.name, error.unit) == (row["name"], row["unit"])
        assert (error.minimum, error.maximum) == (row["minimum"], row["maximum"])
        assert error.value == value or math.isnan(value)
        assert row["name"] in str(error) and str(error) == str(pickle.loads(pickle.dumps(error)))
        assert s == before and s.given == {}


@given(st.sampled_from(QUANTITIES), st.floats(0.01, 1.0))
@settings(max_examples=100, deadline=None)
def test_a_quantity_of_pint_and_a_text_mean_the_same_number(row, part):
    value = row["minimum"] + part * (min(row["maximum"], 1e6) - row["minimum"])
    spelling = {"1": "", "kg/m3": "kg/m**3", "m/s2": "m/s**2", "N.s/m": "N*s/m"}.get(row["unit"], row["unit"])
    s = sa.preset("study")
    s[row["name"]] = pint.Quantity(value, spelling)
    assert s[row["name"]] == value
    s[row["name"]] = f"{value!r} {row['unit'] if row['unit'] != '1' else ''}"
    assert s[row["name"]] == value


@pytest.mark.parametrize(
    ("name", "text", "value"),
    [("impactor.energy", "14700 mJ", 14.7), ("impactor.energy", "9.8 N m", 9.8), ("impactor.mass", "5000 g", 5.0),
     ("impactor.speed", "7.2 km/h", 2.0), ("impactor.speed", "200 cm/s", 2.0), ("silicone.density", "1.1 g/cm3", 1100.0),
     ("silicone.c10", "0.15 MPa", 1.5e5), ("silicone.thickness", "1.2cm", 12e-3), ("time.duration", "15 ms", 15e-3),
     ("impactor.gravity", "1 G", 9.80665), ("measurement.channel_class", "0.18 kHz", 180.0),
     ("silicone.maxwell_beta_1", "2 kHz", 2000.0), ("impactor.rail_damping", "2 N s/mm", 2000.0),
     ("core.friction_coefficient", "30 %", 0.3), ("impactor.gap", "-0 mm", 0.0)],
)
def test_texts_with_units(name, text, value):
    s = sa.preset("study")
    s[name] = text
    assert s[name] == pytest.approx(value, rel=1e-14)


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [("impactor.mass", -1, "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg"),
     ("impactor.mass", "-1 kg", "impactor.mass = -1 kg is refused: expected 0.001 to 10000 kg"),
     ("impactor.mass", "heavy", "impactor.mass = 'heavy' is refused: expected a number, 0.001 to 10000 kg, or a text"),
     ("impactor.mass", "5", "impactor.mass = '5' is refused: expected a number, 0.001 to 10000 kg, or a text with a unit"),
     ("impactor.mass", "5 J", "impactor.mass = '5 J' is refused"),
     ("impactor.mass", pint.Quantity(5, "J"), "is refused: expected a number, 0.001 to 10000 kg"),
     ("impactor.mass", None, "impactor.mass = None is refused"),
     ("impactor.mass", True, "impactor.mass = True is refused"),
     ("impactor.mass", float("nan"), "impactor.mass = NaN kg is refused"),
     ("layers[0].rows", 2.5, "layers[0].rows = 2.5 is refused"),
     ("layers[0].rows", "3", "layers[0].rows = '3' is refused: expected a whole number"),
     ("core.interface", "glued", "core.interface = 'glued' is refused: expected \"bonded\" or \"frictional\""),
     ("core.interface", 1, "core.interface = 1 is refused: expected \"bonded\""),
     ("impactor.mas", 5.0, "impactor.mas is unknown (did you mean impactor.mass?)"),
     ("skin.c10", 1e5, "skin.c10 is refused: no layer is called skin")],
)
def test_refusals_say_what_is_legal_and_change_nothing(name, value, message):
    s = sa.preset("study")
    with pytest.raises(sa.ScenarioError) as caught:
        s[name] = value
    assert message in str(caught.value)
    assert s.given == {} and s == sa.preset("study")


def test_attributes_that_are_not_there_are_refused():
    s = sa.preset("study")
    with pytest.raises(AttributeError, match=r"impactor.mas is unknown \(did you mean impactor.mass"):
        s.impactor.mas = 3.0
    with pytest.raises(AttributeError, match="did you mean"):
        _ = s.impactor.mas
    with pytest.raises(AttributeError, match="energy is no group of parameters"):
        s.energy = 9.8
    with pytest.raises(AttributeError, match="impactor cannot be replaced"):
        s.impactor = 3
    with pytest.raises(IndexError, match="layers.count is 1"):
        _ = s.layers[1]
    with pytest.raises(KeyError, match="no layer is called 'pad'"):
        _ = s.layers["pad"]
    with pytest.raises(AttributeError, match=r"layers.thickness is no attribute"):
        s.layers.thickness = 1
    with pytest.raises(sa.ScenarioError, match="expected study, "):
        sa.preset("stdy")


def test_of_what_states_the_same_thing_the_last_counts():
    s = sa.preset("study")
    s.impactor.energy = 9.8
    s.impactor.height = 0.2
    assert s.given == {"impactor.drop_height": 0.2} and s.impactor.drop_by == "height"
    assert s.impactor.energy == pytest.approx(5.0 * 9.81 * 0.2) and s.impactor.speed == pytest.approx((2 * 9.81 * 0.2) ** 0.5)
    s.impactor.speed = 2.0
    assert s.impactor.drop_by == "speed" and s.impactor.energy == 10.0
    del s.impactor.drop_speed
    assert s == sa.preset("study") and s.given == {}
    with pytest.raises(sa.ScenarioError, match="was not given"):
        del s.impactor.drop_speed


def test_what_has_no_effect_is_refused_by_a_run():
    s = sa.preset("study")
    s.silicone.law = "neo_hookean"
    s.silicone.c10 = 1e5
    s.validate()
    s.silicone.c01 = 1e5
    for use in (s.validate, lambda: sa.run(s), lambda: sa.Simulation(s), lambda: sa.measure(s), lambda: sa.run_many([s])):
        with pytest.raises(sa.ScenarioError, match=r"layers\[0\].c01 = 100000 Pa has no effect: layers\[0\].law is neo_hookean"):
            use()
    del s.silicone.c01
    assert sa.run(s).complete


def test_layers():
    s = sa.preset("study")
    skin = s.layers.add("skin", thickness="1 mm", law="yeoh", c10=5e5)
    assert (len(s.layers), skin.name, s.skin.thickness, s.layers[-1].c10) == (2, "skin", 1e-3, 5e5)
    assert [layer.name for layer in s.layers] == ["silicone", "skin"]
    assert sa.run(s).elements > sa.run(sa.preset("study")).elements
    for name in ("impactor", "skin", "two words", ""):
        with pytest.raises(sa.ScenarioError, match="is refused: expected"):
            s.layers[0].name = name
    with pytest.raises(sa.ParameterError):
        s.layers.add("third", thickness="2 m")
    assert len(s.layers) == 2
    s.layers.count = 1
    assert s.given.keys() == {"layers.count"} and len(s.layers) == 1
    with pytest.raises(sa.ParameterError, match="expected 1 to 4"):
        s.layers.count = 5


def test_toml_goes_there_and_back(tmp_path):
    s = sa.preset("elastic").update({"impactor.energy": 3.0, "time.duration": "12 ms"})
    s.layers.add("skin", thickness=1e-3)
    again = sa.Scenario.from_toml(s.to_toml(), "elastic")
    assert again == s and sa.run(again).trace_hash == sa.run(s).trace_hash
    s.write(tmp_path / "mine.toml")
    assert sa.Scenario.read(tmp_path / "mine.toml", "elastic") == s
    with pytest.raises(sa.ScenarioError, match="line 2: impactor.mas is unknown"):
        sa.Scenario.from_toml("[impactor]\nmas = 4.0\n")


def test_copies_go_their_own_way():
    s = sa.preset("study").update({"impactor.energy": 9.8})
    s.layers[0].name = "gel"
    for other in (s.copy(), copy.copy(s), copy.deepcopy(s), pickle.loads(pickle.dumps(s))):
        assert other == s and other.given == s.given and other.gel.name == "gel"
        other.impactor.mass = 4.0
        assert other != s and s.impactor.mass == 5.0


def test_an_update_that_is_refused_changes_nothing():
    s = sa.preset("study")
    with pytest.raises(sa.ParameterError):
        s.update({"impactor.energy": 9.8, "impactor.mass": -1.0})
    assert s == sa.preset("study")


def test_numbers_of_numpy_are_numbers():
    s = sa.preset("study")
    s.impactor.energy = np.float32(9.5)
    s.layers[0].rows = np.int64(3)
    assert (s.impactor.energy, s.layers[0].rows) == (9.5, 3)


@pytest.mark.parametrize("value", [True, np.bool_(True)])
def test_truth_values_are_no_numbers(value):
    with pytest.raises(sa.ParameterError, match="impactor.mass = .*True.* is refused"):
        sa.preset("study").impactor.mass = value


def test_a_duration_that_is_given_makes_another_scenario():
    s = sa.preset("study")
    s.time.duration = s.time.duration
    assert s != sa.preset("study")


def test_texts_for_people():
    s = sa.preset("study").update({"impactor.energy": 9.8})
    assert repr(s) == "Scenario('study', impactor.drop_energy=9.8)"
    assert "Drop: 5 kg with 9.8 J" in s.summary() and "Drop: 5 kg" in s._repr_html_()
    assert "impactor.mass = 5 kg" in repr(s.impactor) and "drop_height" not in repr(s.impactor)
    assert "<table>" in s.impactor._repr_html_()
    assert "silicone" in dir(s) and "impactor" in dir(s) and "energy" in dir(s.impactor)
    assert {"study", "en1621-1"} <= sa.presets().keys()
    assert sa.parameters().loc["impactor.mass", "unit"] == "kg" and sa.outputs().loc["result.peak_force", "unit"] == "N"
