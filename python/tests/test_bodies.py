"""Bodies other than the study's section: pads, stacks and solids run, and their results and fields are there."""

import math

import matplotlib.pyplot as plt
import numpy as np
import pytest

import softanvil as sa
from test_commands import told


def stack():
    """A pad that is narrower than the anvil below it and may lift from it."""
    s = sa.preset("study").update({"mesh.element_size": "5 mm", "impactor.energy": 4.9})
    s.layers.add("pad", thickness="10 mm", width="60 mm", interface="separating", law="neo_hookean", c10="50 kPa")
    return s


def solid(body="prism", symmetry="quarter"):
    """The study's anvil in three dimensions, coarsely, until shortly after the first touch."""
    return sa.preset("study").update({"geometry.formulation": "solid", "geometry.body": body, "geometry.symmetry": symmetry,
                                      "mesh.element_size": "7.5 mm", "time.duration": "3 ms"})


def test_presets_of_pads_run():
    for name in ("rugby-soft-anvil", "en13061"):
        s = sa.preset(name).update({"mesh.element_size": "7.5 mm"})
        result = sa.run(s, frames=1e-3)
        assert result.complete and result.trace["contact.force"].max() == result.peak_force > 0
        stress = [state.of_triangles("element.von_mises_stress") for state in result.frames]
        assert all(np.isfinite(of_one).all() for of_one in stress) and max(of_one.max() for of_one in stress) > 0


def test_a_narrow_pad_has_fields_and_pictures():
    result = sa.run(stack(), frames=1e-3)
    assert result.complete and result.peak_force < sa.run(sa.preset("study").update({"impactor.energy": 4.9})).peak_force
    state = max(result.frames, key=lambda state: state.output("impactor.deformation"))
    points, triangles, places = state.mesh()
    # The field has cells beside the pad as well, which are no triangles of the mesh.
    assert len(triangles) == len(places) < state["element.pressure"].size
    assert not np.isnan(state.of_triangles("element.pressure")).any()
    corners = points[triangles]
    side, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    assert (side[:, 0] * other[:, 1] > side[:, 1] * other[:, 0]).all()
    assert state.to_pyvista().n_cells == len(triangles)
    assert len(state.plot().collections[0].get_paths()) == 2 * len(triangles)
    plt.close("all")


@pytest.mark.parametrize("body", ["prism", "revolved"])
def test_a_solid_runs_with_the_bits_of_the_command_line(body, tmp_path):
    result = sa.run(solid(body), frames=1e-3)
    solid(body).write(tmp_path / "solid.toml")
    line = told("run", "--scenario", tmp_path / "solid.toml", "--duration", "0.003")
    assert (result.trace_hash, result.peak_force, result.ending) == (line["trace_hash"], line["peak_force"], "in_contact")
    assert [state.time for state in result.frames] == pytest.approx([0, 1e-3, 2e-3, 3e-3], abs=1e-12)
    sim = sa.Simulation(solid(body))
    sim.run(1e-3)
    again = sa.Simulation.of_state(sim.state)
    for one in (sim, again):
        one.run(2e-3)
        assert one.trace_hash == result.trace_hash


def test_a_solid_has_tetrahedra_with_all_fields():
    for symmetry, part in (("quarter", 1 / 4), ("half", 1 / 2)):
        state = sa.run(solid(symmetry=symmetry)).state
        rest, tetrahedra, places = state.mesh()
        assert f"{len(tetrahedra)} tetrahedra" in repr(state) and (places == np.arange(len(tetrahedra))).all()
        assert (rest[:, :2] == state["node.reference_position"].reshape(-1, 2)).all()
        assert (rest[:, 2] == state["node.reference_z"].ravel()).all()
        edges = rest[tetrahedra[:, 1:]] - rest[tetrahedra[:, :1]]
        volume = np.linalg.det(edges) / 6
        s = solid()
        inner, outer = s.geometry.core_radius, s.geometry.core_radius + s.silicone.thickness
        assert (volume > 0).all()
        assert volume.sum() == pytest.approx(part * math.pi / 2 * (outer**2 - inner**2) * s.geometry.length, rel=0.02)
        surface = state["surface.contact_pressure"]
        assert surface.ndim == 2 and surface.max() > 0 and state["surface.contact_force"].shape == (*surface.shape, 2)
        grid = state.to_pyvista()
        assert grid.n_cells == len(tetrahedra) and grid.n_points == len(rest)
        moved = rest + np.column_stack([state["node.displacement"].reshape(-1, 2), state["node.displacement_z"].ravel()])
        assert np.allclose(grid.points, moved, atol=1e-7) and np.abs(moved[:, 2] - rest[:, 2]).max() > 0
        assert {name for name in sa.fields().index if not name.startswith("surface.")} == {*grid.point_data, *grid.cell_data}
        assert not np.isnan(grid.cell_data["element.von_mises_stress"]).any()


def test_a_solid_refuses_what_it_has_not():
    result = sa.run(solid())
    for draw in (result.state.plot, result.animate().to_html):
        with pytest.raises(sa.ScenarioError, match="a solid has no section to draw"):
            draw()
    assert plt.get_fignums() == []
    with pytest.raises(sa.ScenarioError, match=r"impactor\.offset is refused: expected .* with geometry.formulation = solid"):
        sa.run(solid().update({"impactor.offset": "4 mm"}))


@pytest.mark.parametrize("body", ["prism", "revolved"])
def test_a_narrow_pad_on_a_solid_has_the_cells_that_are_there(body):
    bare, padded = solid(body), solid(body)
    padded.layers.add("pad", thickness="5 mm", width="60 mm", interface="separating")
    volumes = []
    for s in (bare, padded):
        state = sa.run(s).state
        rest, tetrahedra, places = state.mesh()
        assert state["node.displacement"].reshape(-1, 2)[tetrahedra].any()
        assert state.to_pyvista().n_cells == len(tetrahedra) == len(places)
        volumes.append((np.linalg.det(rest[tetrahedra[:, 1:]] - rest[tetrahedra[:, :1]]) / 6).sum())
    assert len(tetrahedra) < state["element.von_mises_stress"].size and len(set(places)) == len(places)
    # A quarter of the pad, whose lower side is 60 mm wide.
    below = padded.geometry.core_radius + padded.silicone.thickness
    angle, shells = 0.5 * 0.06 / below, [(below + 5e-3) ** n - below**n for n in (2, 3)]
    pad = {"prism": angle * shells[0] / 2 * padded.geometry.length / 2,
           "revolved": math.pi / 2 * (1 - math.cos(angle)) * shells[1] / 3}
    assert volumes[1] - volumes[0] == pytest.approx(pad[body], rel=0.03)
