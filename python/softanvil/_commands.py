"""What the command line does with files, as functions: the same code, the same options, with `_` for `-`."""

from __future__ import annotations

import contextlib
import json
import numbers
import os
import re
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pandas as pd

from . import _softanvil
from ._errors import SoftanvilError
from ._scenario import Scenario, settings_of

PathLike = str | os.PathLike[str]
Paths = PathLike | Sequence[PathLike]


def _arguments(options: dict[str, Any]) -> list[str]:
    """The options as the command line takes them.

    Raises:
        TypeError: A value that is none of an option, such as a data frame for a file.
    """
    given: list[str] = []
    for name, value in options.items():
        for one in value if isinstance(value, (list, tuple)) else [value]:
            if one is not None and not isinstance(one, (str, numbers.Real, np.bool_, os.PathLike)):
                raise TypeError(f"{name} of type {type(one).__name__} is refused: expected a text, a number or the path of a file")
        option = f"--{name.replace('_', '-')}"
        if value is None or isinstance(value, (bool, np.bool_)) and not value:
            continue
        if isinstance(value, (bool, np.bool_)):
            given.append(option)
        elif isinstance(value, (list, tuple)):
            given += [option, *(_text(one) for one in value)]
        else:
            given.append(f"{option}={_text(value)}")
    return given


def _text(value: object) -> str:
    if isinstance(value, float):
        return repr(float(value))
    return os.fspath(value) if isinstance(value, os.PathLike) else str(value)


def _with_unit(value: str | float | None, unit: str) -> str | None:
    """A number of an SI `unit` as the command line takes it, which wants one."""
    return value if value is None or isinstance(value, str) else f"{float(value)!r} {unit}"


def _call(command: str, arguments: Sequence[str]) -> str:
    """Carries out a command. Its options have in messages the names that they have in Python."""
    try:
        return _softanvil.command([command, *arguments])
    except SoftanvilError as error:
        renamed = re.sub(r"--([a-z][a-z-]*)", lambda found: found[1].replace("-", "_"), str(error))
        raise type(error)(renamed) from None


@contextlib.contextmanager
def _of_scenario(scenario: Scenario) -> Iterator[tuple[list[str], Path]]:
    """The options that say which drop, and a folder for files that go with it."""
    settings_of(scenario).validate()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scenario.toml"
        scenario.write(path)
        options = [f"--preset={scenario.preset}", f"--scenario={path}"]
        if "time.duration" in scenario.given:
            options.append(f"--duration={_text(scenario.time.duration)}")
        yield options, Path(folder)


def _json(text: str) -> dict[str, Any]:
    data: dict[str, Any] = json.loads(text)
    if isinstance(data.get("drop"), dict):
        # What Python gave stands in the scenario, not in a file.
        for key in ("scenario_file", "material_file", "set"):
            data["drop"].pop(key, None)
    return data


@dataclass(frozen=True)
class Measurement:
    """A drop as instruments see it.

    Attributes:
        data: All numbers, in SI units, as ``softanvil measure --json`` gives them: the four of the test, how they change with the
            channel, and, beside a measured trace, errors and ratings under "comparison".
        trace: Force as it is read by time (samples,), N, and the measured one aligned with it.
    """

    data: dict[str, Any]
    trace: pd.DataFrame

    def __getitem__(self, name: str) -> Any:
        return self.data[name]


def measure(
    scenario: Scenario,
    *,
    trace: PathLike | None = None,
    force: Literal["contact", "core"] = "contact",
    cfc: float | None = None,
    threshold: float | str | None = None,
    noise: float = 0.0,
    calibration_error: float = 0.0,
    seed: int = 1,
    camera: bool = False,
    filtered: bool = False,
    time: str | None = None,
    force_column: str | None = None,
    acceleration: str | None = None,
    displacement: str | None = None,
    mass: str | float | None = None,
    rate: str | float | None = None,
    offset: float | None = None,
    sign: Literal["+", "-"] | None = None,
    impact: int | None = None,
    sheet: str | None = None,
    decimal: Literal["point", "comma"] | None = None,
) -> Measurement:
    """Simulates a drop and reads it as load cells, filters and camera do; with a measured trace, beside it.

    Args:
        scenario: What is dropped on what.
        trace: File of a measured trace, of any layout (docs/measured-data.md).
        force: Force on the impactor, or of the load cells under the core.
        cfc: Channel frequency class of the filter on the force, Hz.
        threshold: Force from which on the impact lasts, N, or a part of the peak, "5%".
        noise: Standard deviation of a load cell's error, N.
        calibration_error: Standard deviation of the error of its calibration, %.
        seed: Seed of both errors.
        camera: Whether the deformation is read in the frames of a 10 kHz camera.
        filtered: Whether the measured trace has been filtered already.
        time, force_column, acceleration, displacement, mass, rate, offset, sign, impact, sheet, decimal: What the file leaves
            open; see `read_trace`.

    Raises:
        FileError: A file or an option that is refused.
    """
    options = {"trace": trace, "force": force, "cfc": cfc, "threshold": threshold, "noise": noise,
               "calibration_error": calibration_error, "seed": seed, "camera": camera, "filtered": filtered, "time": time,
               "force_column": force_column, "acceleration": acceleration, "displacement": displacement, "mass": _with_unit(mass, "kg"),
               "rate": _with_unit(rate, "Hz"), "offset": offset, "sign": sign, "impact": impact, "sheet": sheet, "decimal": decimal}
    with _of_scenario(scenario) as (drop, folder):
        csv = folder / "trace.csv"
        data = _json(_call("measure", [*drop, *_arguments(options), f"--csv={csv}", "--json"]))
        titles = csv.read_text(encoding="utf-8").splitlines()[0].split(",")
        values = np.loadtxt(csv, delimiter=",", skiprows=1, ndmin=2)
    names = [title.split(" [")[0] for title in titles]
    table = pd.DataFrame(values[:, 1:], index=pd.Index(values[:, 0], name="time"), columns=names[1:])
    table.attrs["units"] = {"time": "s", **dict.fromkeys(table.columns, "N")}
    return Measurement(data, table)


@dataclass(frozen=True)
class Verdict:
    """Pads beside the bare anvil.

    Attributes:
        data: All numbers, in SI units and g, as ``softanvil protect --json`` gives them; "standard" has the limits.
        table: A row for the bare anvil, and one for every pad: thickness, transmitted force, acceleration, energies, "verdict" of
            the standard, such as "pass", and the "level" that is met or, of a "fail", missed.
    """

    data: dict[str, Any]
    table: pd.DataFrame

    def __getitem__(self, name: str) -> Any:
        return self.data[name]

    def _repr_html_(self) -> str:
        return str(self.table.to_html())


def protect(
    scenario: Scenario, *, compare: Paths | None = None, thickness: float | str | Sequence[float | str] | None = None
) -> Verdict:
    """Simulates a drop on a pad and on the bare anvil, and judges the pad by a standard, whose set-up the preset is.

    Args:
        scenario: A drop on a pad: the layer called "pad" and all above it, or the topmost layer.
        compare: Scenario or material files with a pad each.
        thickness: Thicknesses of the pad's lowest layer, m, or texts such as "10mm".

    Raises:
        FileError: A file or an option that is refused, or no pad.
    """
    lengths = [thickness] if isinstance(thickness, (float, int, str)) else thickness
    in_m = None if lengths is None else [one if isinstance(one, str) else f"{_text(float(one))}m" for one in lengths]
    files = [compare] if isinstance(compare, (str, os.PathLike)) else compare
    options = {"compare": None if files is None else list(files), "thickness": in_m}
    with _of_scenario(scenario) as (drop, _):
        data = _json(_call("protect", [*drop, *_arguments(options), "--json"]))
    rows = [{"name": "bare", **data["bare"]}] if data.get("bare") else []
    rows += data["pads"]
    table = pd.DataFrame([_of_pad(row) for row in rows])
    return Verdict(data, table.set_index("name"))


def _of_pad(row: dict[str, Any]) -> dict[str, Any]:
    """What stands in a row of a table, of what came of a pad."""
    judged = row.get("verdict") or {}
    plain = {key: value for key, value in row.items() if not isinstance(value, (list, dict))}
    return {**plain, "verdict": judged.get("verdict"), "level": judged.get("level")}


# The four numbers of the test.
NUMBERS = ["peak_force", "max_deformation", "impact_duration", "impulse"]


@dataclass(frozen=True)
class Reduction:
    """Drops as a section and as a solid.

    Attributes:
        data: All that was found, in SI units, as ``softanvil reduction --json`` gives it.
        table: A row for each scenario: its parameters, the four numbers "of the solid" and "of the section", the difference of their
            forces, %, and the ``geometry.length``, m, with which the section bears what the solid does, none if there is none.
    """

    data: dict[str, Any]
    table: pd.DataFrame

    def _repr_html_(self) -> str:
        return str(self.table.to_html())


def reduction(
    scenario: Scenario, parameters: Mapping[str, float | str | Sequence[float | str]] | None = None, *,
    plot: PathLike | None = None, overwrite: bool = False
) -> Reduction:
    """Simulates a drop as a section and as a solid, and finds the length with which the section bears what the solid does.

    Args:
        scenario: A drop; its formulation says which section.
        parameters: A value or several, in SI units, or labels of a choice, by the names of parameters; all combinations are
            simulated, among them the scenario's own value. A solid of the study's size takes some seconds.
        plot: File to which the differences are drawn, .svg or .png.
        overwrite: Replace that file if it is there.

    Raises:
        FileError: A scenario or value that is refused, also as a solid, or a file that is there.
    """
    what = []
    for name, values in (parameters or {}).items():
        several = [values] if isinstance(values, (str, float, int, np.number)) else values
        what.append(f"{name}={','.join(_text(value) for value in several)}")
    with _of_scenario(scenario) as (drop, _):
        options = _arguments({"plot": plot, "overwrite": overwrite})
        data = _json(_call("reduction", [*what, *drop, *options, "--json"]))
    return Reduction(data, pd.DataFrame([_of_case(case) for case in data["cases"]]))


def _of_case(case: dict[str, Any]) -> dict[str, Any]:
    """What stands in a row of a table, of a scenario as a section and as a solid."""
    numbers = {f"{key} of the {body}": case[body][key] for key in NUMBERS for body in ("solid", "section")}
    return {**case["settings"], **numbers, "difference": case["section_difference_percent"], "length": case["effective_length"]}


@dataclass(frozen=True)
class Fit:
    """Laws fitted to material tests.

    Attributes:
        data: All that was found, in SI units, as ``softanvil fit --json`` gives it.
        material: The chosen law as a material file, which `Scenario.with_material` takes; none if there were no curves.
        files: Names of the files that were written for this and other programs.
    """

    data: dict[str, Any]
    material: str | None
    files: list[str]

    @property
    def law(self) -> str | None:
        """Name of the chosen law."""
        chosen: str | None = self.data.get("chosen")
        return chosen

    @property
    def laws(self) -> pd.DataFrame:
        """The laws in the order of their ranking, with their residuals."""
        plain = [{key: value for key, value in law.items() if not isinstance(value, (list, dict))} for law in self.data["laws"]]
        return pd.DataFrame(plain)

    def __getitem__(self, name: str) -> Any:
        return self.data[name]


def fit(
    *,
    uniaxial: Paths | None = None,
    planar: Paths | None = None,
    equibiaxial: Paths | None = None,
    simple_shear: Paths | None = None,
    relaxation: PathLike | None = None,
    out: PathLike | None = None,
    columns: str | None = None,
    relaxation_columns: str | None = None,
    sheet: str | None = None,
    decimal: Literal["point", "comma"] | None = None,
    strain_measure: Literal["engineering", "true", "green"] | None = None,
    stress_measure: Literal["engineering", "true", "green"] | None = None,
    direction: Literal["tension", "compression"] | None = None,
    area: str | float | None = None,
    diameter: str | float | None = None,
    height: str | float | None = None,
    repeats: Literal["median", "all"] = "median",
    drop_first_cycle: bool = False,
    unloading: bool = False,
    foam: bool = False,
    law: str | None = None,
    weighting: Literal["absolute", "relative", "tests"] | None = None,
    stable: bool = False,
    stable_range: tuple[float, float] | None = None,
    terms: int | None = None,
    ramp_time: float | None = None,
    relaxation_start: float | None = None,
    relaxation_strain: float | None = None,
    moduli: Literal["long-term", "instantaneous"] = "long-term",
    layer: str | None = None,
    density: float | None = None,
    poissons_ratio: float | None = None,
    overwrite: bool = False,
) -> Fit:
    """Fits hyperelastic laws and Prony series to material tests (docs/identification.md).

    Args:
        uniaxial, planar, equibiaxial, simple_shear: Files of curves; several are repeats.
        relaxation: File of a stress relaxation.
        out: Folder for the material files of this and other programs and pictures; without it nothing is kept.
        columns, relaxation_columns: Titles of the columns instead of the file's, "strain [%], stress [kPa]".
        sheet, decimal, strain_measure, stress_measure, direction: What the files leave open.
        area, diameter, height: Size of the specimens, m2 and m or with unit, "660mm2", for columns of force and displacement.
        repeats, drop_first_cycle, unloading: Which specimens, cycles and branches count.
        foam: Whether the specimens are of a foam.
        law: Law to choose instead of the stable one of lowest residual.
        weighting: Of residuals.
        stable, stable_range: Whether only stable laws count, and over which stretches.
        terms, ramp_time, relaxation_start, relaxation_strain: Of the relaxation; s, and engineering strain.
        moduli: Whether the curves were slow or fast against the relaxation.
        layer: Layer that the material is for: its name, its place, or both, "pad=0".
        density: kg/m3.
        poissons_ratio: If it is known.
        overwrite: Whether files of others in `out` may be replaced.

    Raises:
        FileError: A file or an option that is refused.
        SimulationError: No law that can be fitted.
    """
    def listed(paths: Paths | None) -> list[PathLike] | None:
        return [paths] if isinstance(paths, (str, os.PathLike)) else None if paths is None else list(paths)

    options = {"uniaxial": listed(uniaxial), "planar": listed(planar), "equibiaxial": listed(equibiaxial),
               "simple_shear": listed(simple_shear), "relaxation": relaxation, "columns": columns,
               "relaxation_columns": relaxation_columns, "sheet": sheet, "decimal": decimal, "strain_measure": strain_measure,
               "stress_measure": stress_measure, "direction": direction, "area": _with_unit(area, "m2"),
               "diameter": _with_unit(diameter, "m"), "height": _with_unit(height, "m"),
               "repeats": repeats, "drop_first_cycle": drop_first_cycle, "unloading": unloading, "foam": foam, "law": law,
               "weighting": weighting, "stable": stable,
               "stable_range": stable_range and ":".join(map(_text, map(float, stable_range))), "terms": terms,
               "ramp_time": ramp_time, "relaxation_start": relaxation_start, "relaxation_strain": relaxation_strain,
               "moduli": moduli, "layer": layer, "density": density, "poissons_ratio": poissons_ratio, "overwrite": overwrite}
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(out) if out is not None else Path(scratch) / "fit"
        data = _json(_call("fit", [*_arguments(options), f"--out={folder}", "--json"]))
        material = folder / "material.toml"
        text = material.read_text(encoding="utf-8") if material.exists() else None
        files = sorted(path.name for path in folder.iterdir()) if out is not None else []
    return Fit(data, text, files)


@dataclass(frozen=True)
class Calibration:
    """What a search has found.

    Attributes:
        text: The tables for people.
        scenario: The best scenario.
        summary: All numbers, in SI units.
        evaluations: A row for every evaluation: score and values of the parameters.
    """

    text: str
    scenario: Scenario
    summary: dict[str, Any]
    evaluations: pd.DataFrame

    def __repr__(self) -> str:
        return self.text


def calibrate(
    problem: PathLike,
    *,
    out: PathLike = "softanvil-calibration",
    evaluations: int | None = None,
    seed: int | None = None,
    threads: int = 0,
    uncertainty: bool = False,
    overwrite: bool = False,
) -> Calibration:
    """Searches for the parameters with which simulated impacts come closest to measured ones (docs/calibration.md).

    Ctrl-C ends the search with what was found so far; called again it goes on.

    Args:
        problem: Problem file (TOML): parameters with ranges, impacts, score.
        out: Folder for the log, the best scenario and the summary; a search that stands there is continued.
        evaluations: How many to spend in all, instead of the problem's.
        seed: Instead of the problem's.
        threads: 0 for one per core.
        uncertainty: Whether to infer a posterior after the search has converged: `posterior.json` in `out`, and what it
            tells under `uncertainty` in the summary.
        overwrite: Whether files of others, or the log of another problem, in `out` may be replaced.

    Raises:
        FileError: A problem that is refused, or the log of another one.
    """
    options = {"out": out, "evaluations": evaluations, "seed": seed, "threads": threads, "uncertainty": uncertainty,
               "overwrite": overwrite}
    text = _call("calibrate", [_text(problem), *_arguments(options)])
    folder = Path(out)
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    return Calibration(
        text=text,
        scenario=Scenario.read(folder / "best.toml"),
        summary=summary,
        evaluations=pd.read_csv(folder / "evaluations.csv"),
    )


def material_front(
    problem: PathLike,
    weights: Sequence[float],
    *,
    out: PathLike = "softanvil-calibration",
    evaluations: int | None = None,
    seed: int | None = None,
    threads: int = 0,
    overwrite: bool = False,
) -> pd.DataFrame:
    """Searches once for each weight of the material tests: what impacts and tests cost each other (docs/calibration.md).

    Args:
        problem: Problem file (TOML) with material tests.
        weights: Points of score for a mean square distance of one standard deviation, one search each.
        out: Folder for a folder of each search, and for the table and its picture, ``front.svg``.
        evaluations: How many each search spends, instead of the problem's.
        seed: Instead of the problem's.
        threads: 0 for one per core.
        overwrite: Whether files of others, or the log of another problem, in `out` may be replaced.

    Returns:
        A row for each weight: mean and largest error of the impacts in %, distance from the material tests (root mean square)
        and the largest in standard deviations, and whether its search has converged; units in ``attrs``.

    Raises:
        FileError: A problem that is refused or without material tests that count, or the log of another one.
    """
    options = {"out": out, "evaluations": evaluations, "seed": seed, "threads": threads, "overwrite": overwrite,
               "material_weights": list(weights)}
    _call("calibrate", [_text(problem), *_arguments(options)])
    table = pd.read_csv(Path(out) / "front.csv")
    units = [title.partition(" [")[2].rstrip("]") for title in table.columns]
    table.columns = pd.Index([title.partition(" [")[0] for title in table.columns])
    table.attrs["units"] = {name: unit for name, unit in zip(table.columns, units, strict=True) if unit}
    return table


def read_trace(
    path: PathLike,
    scenario: Scenario | None = None,
    *,
    time: str | None = None,
    force_column: str | None = None,
    acceleration: str | None = None,
    displacement: str | None = None,
    mass: str | float | None = None,
    rate: str | float | None = None,
    offset: float | None = None,
    sign: Literal["+", "-"] | None = None,
    impact: int | None = None,
    sheet: str | None = None,
    decimal: Literal["point", "comma"] | None = None,
) -> pd.DataFrame:
    """Reads a measured force over time, from text or a workbook of any layout (docs/measured-data.md).

    Args:
        path: The file.
        scenario: The drop that it is of, which tells what is plausible.
        time, force_column, acceleration, displacement: Columns, by title or number, with unit if the file states none: "t [ms]".
        mass: Of the falling body, kg or with unit, "5kg", for an acceleration.
        rate: Samples in a second, Hz or with unit, "20kHz", instead of a column of time.
        offset: Force without contact, N, to be taken off.
        sign: Which side of the record a push is on.
        impact: Which impact of the record, from 1.
        sheet: Sheet of a workbook.
        decimal: Decimal sign.

    Returns:
        Column "force" in N, positive in compression, by time in s; ``attrs`` has the units, the largest deformation in m if the
        file has it, and how the file was read.

    Raises:
        FileError: What cannot be understood, or in two ways, with the option that decides.
    """
    settings = None if scenario is None else scenario._settings
    try:
        times, forces, deformation, understood = _softanvil.read_trace(
            path, settings, time=time, force_column=force_column, acceleration=acceleration, displacement=displacement,
            mass=_with_unit(mass, "kg"), rate=_with_unit(rate, "Hz"), offset=offset, sign=sign, impact=impact, sheet=sheet, decimal=decimal)
    except SoftanvilError as error:
        raise type(error)(re.sub(r"--([a-z][a-z-]*)", lambda found: found[1].replace("-", "_"), str(error))) from None
    frame = pd.DataFrame({"force": forces}, index=pd.Index(times, name="time"))
    frame.attrs = {"units": {"time": "s", "force": "N"}, "max_deformation": deformation, "read_as": json.loads(understood)}
    return frame
