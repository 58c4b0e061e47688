"""Drops and what comes of them: numbers, traces, fields, pictures."""

import pickle
import threading
import time

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest

import softanvil as sa


@pytest.fixture(scope="module")
def result():
    return sa.run(sa.preset("study"), frames=1e-3)


def test_numbers_are_those_of_the_trace(result):
    trace = result.trace
    assert result.peak_force == trace["contact.force"].max() == result["result.peak_force"]
    assert result.complete and result.ending == "complete" and result.cut == []
    assert result.elements == 240 and result.steps * result.time_step == pytest.approx(result.state.time)
    # Impulse is the area under the force, of samples that are means over their intervals.
    assert result.impulse == pytest.approx(trace["contact.force"].sum() * 50e-6, rel=1e-9)


def test_the_trace_is_a_data_frame_with_units(result):
    trace = result.trace
    assert trace.index.name == "time" and np.allclose(np.diff(trace.index), 50e-6, rtol=1e-9)
    assert trace.attrs["units"]["contact.force"] == "N" and set(trace.attrs["units"]) == {"time", *trace.columns}
    assert len(trace) == result.steps // round(50e-6 / result.time_step) + 1


def test_the_trace_is_that_of_the_command_line(result, tmp_path):
    sa._softanvil.command(["run", "--csv", str(tmp_path / "trace.csv")])
    told = pd.DataFrame(np.loadtxt(tmp_path / "trace.csv", delimiter=",", skiprows=1))
    titles = (tmp_path / "trace.csv").read_text().splitlines()[0].split(",")
    told.columns = [title.split(" [")[0] for title in titles]
    pd.testing.assert_frame_equal(result.trace.reset_index(), told, check_exact=True, check_dtype=False)


def test_stored_fields_are_views_that_outlive_everything(result):
    state = sa.run(sa.preset("study")).state
    for name in ("node.displacement", "node.velocity", "node.force", "node.reference_position", "surface.contact_force"):
        array, again = state.field(name), state.field(name)
        assert not array.flags.owndata and not array.flags.writeable
        assert array.__array_interface__["data"][0] == again.__array_interface__["data"][0]
    kept = state.field("node.displacement")
    before = kept.copy()
    del state
    junk = [np.random.default_rng(0).random(100_000) for _ in range(20)]
    assert (kept == before).all() and len(junk) == 20


def test_fields_fit_together(result):
    for state in result.frames:
        rest, moved = state["node.reference_position"], state["node.displacement"]
        assert (state["node.position"] == rest + moved).all()
        assert (state["element.pressure"] >= -1e9).all() and state["element.cauchy_stress"].shape == (5, 48, 4)
        stress = state["element.cauchy_stress"]
        mean = stress[..., [0, 1, 3]].sum(axis=-1) / 3
        assert np.allclose(-mean, state["element.pressure"], rtol=1e-9, atol=1e-3)
    shapes = {name: result.state[name].shape for name in sa.fields().index}
    assert shapes["node.velocity"] == (6, 25, 2) and shapes["surface.contact_pressure"] == (25,)
    with pytest.raises(sa.ScenarioError, match="field \"stress\" is unknown: expected node.reference_position"):
        result.state["stress"]


def test_frames_are_at_equal_intervals_and_change_nothing(result):
    assert np.allclose([state.time for state in result.frames], np.arange(len(result.frames)) * 1e-3, atol=1e-12)
    assert result.trace_hash == sa.run(sa.preset("study")).trace_hash
    for interval in (0.0, -1e-3, 3e-5, 7.5e-5, 2.0, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="expected a whole multiple of 5e-05 s"):
            sa.run(sa.preset("study"), frames=interval)


def test_a_pyvista_mesh_has_the_fields(result):
    grid = result.frames[4].to_pyvista()
    assert grid.n_cells == 240 and grid.n_points == 150
    assert grid.cell_data["element.von_mises_stress"].max() == result.frames[4]["element.von_mises_stress"].max()
    assert np.allclose(grid.points[:, :2], result.frames[4].positions(), atol=1e-7)


def test_pictures(result, tmp_path):
    figure = result.plot()
    line = figure.axes[0].lines[0]
    assert line.get_ydata().max() == pytest.approx(1e-3 * result.peak_force)
    assert figure.axes[0].get_xlabel() == "time (ms)"
    axes = result.frames[4].plot()
    assert len(axes.collections[0].get_paths()) == 2 * result.elements
    with pytest.raises(ValueError, match="one component"):
        result.state.plot("element.principal_stress")
    both = sa.compare([result, result], ["a", "b"])
    assert [text.get_text() for text in both.axes[0].get_legend().get_texts()] == ["a", "b"]
    assert result.animate().frames == result.frames
    animation = sa.Animation(result.frames[::4])
    html = animation._repr_html_()
    assert html.count("data:image/png;base64") >= len(animation.frames) and "<script" in html
    animation.save(tmp_path / "impact.gif")
    assert (tmp_path / "impact.gif").read_bytes()[:3] == b"GIF"
    plt.close("all")


def test_results_pickle(result):
    again = pickle.loads(pickle.dumps(result))
    pd.testing.assert_frame_equal(again.trace, result.trace, check_exact=True)
    assert again.outputs == result.outputs and repr(again) == repr(result)
    assert (again.frames[5]["node.velocity"] == result.frames[5]["node.velocity"]).all()


def test_texts_for_people(result):
    assert "peak_force" in repr(result) and "complete" in repr(result)
    assert "<table>" in result._repr_html_() and "5443" in result._repr_html_()


def test_a_drop_that_is_cut_says_so():
    cut = sa.run(sa.preset("study").update({"time.duration": "4 ms"}))
    assert cut.ending == "in_contact" and not cut.complete and "result.impulse" in cut.cut
    assert "*" in repr(cut) and "so far" in cut._repr_html_()
    short = sa.run(sa.preset("study").update({"time.duration": "0.5 ms"}))
    assert short.ending == "no_contact" and np.isnan(short.peak_force)


def test_several_impacts_on_the_same_anvil():
    s = sa.preset("elastic").update({"silicone.softening_r": 1.5, "silicone.softening_m": "20 kPa"})
    once, thrice = sa.run(s), sa.run(s, impacts=3, rest=1.0)
    assert len(thrice.earlier) == 2 and thrice.earlier[0] == once.outputs
    assert thrice.max_deformation > once.max_deformation
    for impacts in (0, 1001):
        with pytest.raises(ValueError, match="expected 1 to 1000"):
            sa.run(s, impacts=impacts)


def test_a_driven_scenario_cannot_be_run():
    s = sa.preset("study").update({"impactor.motion": "driven"})
    with pytest.raises(sa.ScenarioError, match="impactor.motion = driven is refused"):
        sa.run(s)


def test_many_on_any_number_of_threads():
    scenarios = [sa.preset("study").update({"impactor.energy": energy}) for energy in (14.7, 9.8, 4.9)]
    alone = [sa.run(s).trace_hash for s in scenarios]
    for threads in (0, 1, 2, 5):
        assert [r.trace_hash for r in sa.run_many(scenarios, threads=threads)] == alone
    scenarios.insert(1, sa.preset("study").update({"layers.count": 2}))
    with pytest.raises(sa.ScenarioError, match=r"layers\[1\].thickness = 0 m is refused"):
        sa.run_many(scenarios)
    results = sa.run_many(scenarios, errors="return")
    assert isinstance(results[1], sa.ScenarioError) and [r.trace_hash for r in results if isinstance(r, sa.Result)] == alone
    assert sa.run_many([]) == []


def test_other_threads_run_meanwhile():
    slow = sa.preset("study").update({"mesh.element_size": "1 mm"})
    count, done = 0, threading.Event()

    def work():
        sa.run(slow)
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.is_set():
        count += 1
        time.sleep(1e-3)
    thread.join()
    assert count > 20


def test_ctrl_c_ends_a_run():
    import _thread

    slow = sa.preset("study").update({"mesh.element_size": "0.3 mm"})
    threading.Timer(0.3, _thread.interrupt_main).start()
    start = time.monotonic()
    with pytest.raises(KeyboardInterrupt):
        sa.run(slow)
    assert time.monotonic() - start < 20
