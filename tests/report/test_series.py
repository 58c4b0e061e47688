"""The series for ParaView, read by meshio and by Python's XML library: shapes, units and sums against the trace."""

import csv
import json
import math
import os
import xml.etree.ElementTree as xml
from pathlib import Path

import meshio
import numpy as np
import pytest

WORK = Path(os.environ["SOFTANVIL_WORK"])
SERIES = WORK / "series"
INTERVAL = 250e-6
# Preset: half section, so forces of the mesh are half of the anvil's.
HALVES = 2.0


@pytest.fixture(scope="module")
def frames():
    """Time, section and impactor of each frame."""
    found = {}
    for entry in xml.parse(SERIES / "impact.pvd").getroot().iter("DataSet"):
        found.setdefault(float(entry.get("timestep")), {})[entry.get("part")] = meshio.read(SERIES / entry.get("file"))
    return [(time, parts["0"], parts["1"]) for time, parts in sorted(found.items())]


@pytest.fixture(scope="module")
def trace():
    """Rows of the trace by sample."""
    with open(WORK / "trace.csv") as file:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(file)]


def test_frames_stand_at_their_interval_and_cover_the_run(frames, trace):
    times = [time for time, _, _ in frames]
    assert np.allclose(times, INTERVAL * np.arange(len(times)), atol=1e-12)
    assert math.isclose(times[-1], trace[-1]["time [s]"], abs_tol=INTERVAL)
    files = {path.name for path in SERIES.iterdir()}
    assert len(files) == 2 * len(frames) + 1


def test_every_field_has_its_shape(frames):
    triangles = json.loads((WORK / "run.json").read_text())["elements"]
    for _, section, impactor in frames:
        assert [block.type for block in section.cells] == ["triangle"] and len(section.cells[0].data) == triangles
        shapes = {name: values.shape[1:] for name, values in section.point_data.items()}
        assert shapes == {"reference_position": (3,), "displacement": (3,), "velocity": (3,), "force": (3,),
                          "contact_force": (3,), "contact_pressure": ()}
        shapes = {name: values[0].shape[1:] for name, values in section.cell_data.items()}
        assert shapes == {"pressure": (), "von_mises_stress": (), "principal_stress": (3,), "cauchy_stress": (6,),
                          "principal_stretch": (3,)}
        assert all(np.isfinite(values).all() for values in section.point_data.values())
        assert all(np.isfinite(values[0]).all() for values in section.cell_data.values())
        assert [block.type for block in impactor.cells] == ["line"]


def test_points_move_and_the_face_follows_the_trace(frames, trace):
    for time, section, impactor in frames:
        row = trace[round(time / 50e-6)]
        moved = section.point_data["reference_position"] + section.point_data["displacement"]
        assert np.abs(section.points - moved).max() < 1e-15
        top = section.point_data["reference_position"][:, 1].max()
        face = impactor.points[:, 1]
        assert np.allclose(face, top + row["impactor.position [m]"], atol=1e-12)
        # Nothing of the layer is above the face.
        assert section.points[:, 1].max() < face[0] + 30e-6
        assert np.isclose(impactor.cell_data["velocity"][0][0], row["impactor.velocity [m/s]"])
        assert np.isclose(impactor.cell_data["contact_force"][0][0], row["contact.force [N]"])


def test_stresses_agree_with_each_other(frames):
    for _, section, _ in frames:
        xx, yy, zz, xy, yz, xz = section.cell_data["cauchy_stress"][0].T
        assert not yz.any() and not xz.any()
        tensors = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]).transpose(2, 0, 1)
        values = np.linalg.eigvalsh(tensors)
        scale = np.abs(values).max() + 1.0
        principal = np.sort(section.cell_data["principal_stress"][0], axis=1)
        assert np.abs(values - principal).max() < 1e-9 * scale
        assert np.abs(section.cell_data["pressure"][0] + values.mean(axis=1)).max() < 1e-9 * scale
        a, b, c = values.T
        mises = np.sqrt(0.5 * ((a - b) ** 2 + (b - c) ** 2 + (c - a) ** 2))
        assert np.abs(section.cell_data["von_mises_stress"][0] - mises).max() < 1e-6 * scale


def test_contact_forces_add_up_to_the_force_of_the_trace(frames, trace):
    """The force of one step against the means of the samples around it, where the force is large."""
    compared = 0
    for time, section, _ in frames[:-1]:
        sample = round(time / 50e-6)
        around = 0.5 * (trace[sample]["contact.force [N]"] + trace[sample + 1]["contact.force [N]"])
        if around > 2000:
            force = HALVES * section.point_data["contact_force"][:, 0].sum()
            # Impulses of single nodes are in the force of a step.
            assert abs(force - around) < 0.15 * around, (time, force, around)
            assert section.point_data["contact_pressure"].max() > 1e5
            compared += 1
    assert compared > 3
