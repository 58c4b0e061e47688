"""Results of drops, and how to get them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
import pandas as pd

from . import _softanvil
from ._animation import Animation
from ._html import table
from ._numbers import OUTPUTS, Numbers
from ._plot import force
from ._scenario import Scenario, settings_of
from ._state import State

if TYPE_CHECKING:
    from matplotlib.figure import Figure

#: Interval of force samples, s.
SAMPLING_INTERVAL = 50e-6


class Result(Numbers):
    """A simulated drop: its measured numbers as attributes (``result.peak_force``), its trace, its states.

    All numbers are in SI units. Of a drop that ended in contact, those named by `cut` are the ones so far; of one without
    contact all are NaN.

    Attributes:
        scenario: What was simulated.
        outputs: Every output at the end, by name, such as "energy.elastic".
        complete: Whether the impactor has touched the anvil and left it.
        ending: "complete", "held" (a press at its depth), "in_contact" or "no_contact".
        cut: Names of the outputs whose values are those so far.
        trace_hash: Fingerprint of the trace: equal for equal bits.
        time_step: Time step, s.
        steps: Steps made.
        elements: Triangles of the mesh, or tetrahedra of a solid.
        warnings: What makes the numbers doubtful.
        state: The state at the end.
        frames: States at equal intervals, if they were asked for.
        earlier: Outputs of the impacts before the last, if there were several.
    """

    scenario: Scenario
    outputs: dict[str, float]
    complete: bool
    ending: Literal["complete", "held", "in_contact", "no_contact"]
    cut: list[str]
    trace_hash: str
    time_step: float
    steps: int
    elements: int
    warnings: list[str]
    state: State
    frames: list[State]
    earlier: list[dict[str, float]]

    def __init__(self, run: _softanvil.Run, scenario: Scenario) -> None:
        self.scenario, self.outputs, self.earlier = scenario, run.outputs(), run.earlier()
        self.__dict__.update(run.facts())
        self.state, self.frames = State(run.end()), [State(view) for view in run.frames()]
        self._run: _softanvil.Run | None = run
        self._trace: pd.DataFrame | None = None

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_trace": self.trace, "_run": None}

    @property
    def trace(self) -> pd.DataFrame:
        """Every output that changes with time, at the start and at the end of every force sample of 50 us.

        Returns:
            Rows by time in s (samples,), columns by name of the output, such as "contact.force"; their units, and that of the
            index "time", are in ``attrs["units"]``.
        """
        if self._trace is None and self._run is not None:
            names, units, values = self._run.trace()
            index = pd.Index(values[0], name="time")
            self._trace = pd.DataFrame(values[1:].T, index=index, columns=names[1:], copy=False)
            self._trace.attrs = {"units": dict(zip(names, units, strict=True)), "trace_hash": self.trace_hash}
            self._run = None
        assert self._trace is not None
        return self._trace

    def plot(self) -> Figure:
        """Draws contact force over time and over deformation; returns the figure."""
        return force([self])

    def animate(self, field: str = "element.von_mises_stress", interval: float = 250e-6) -> Animation:
        """The impact as an animation, which a notebook plays and ``save("impact.gif")`` writes.

        Args:
            field: Field of triangles with one component that colours the section.
            interval: Time between two frames, s, if the drop was simulated without frames; it is simulated again then.
        """
        frames = self.frames or run(self.scenario, frames=interval).frames
        return Animation(frames, field)

    def __getitem__(self, name: str) -> float:
        """An output at the end by its full name, such as "energy.elastic"."""
        return self.outputs[name]

    def _rows(self) -> list[tuple[str, str, str, str]]:
        rows = []
        for name, (unit, description) in OUTPUTS.items():
            if name.startswith("result.") and name != "result.complete":
                so_far = " *" if name in self.cut else ""
                shown = f"{self.outputs[name]:.5g}{so_far}"
                rows.append((name.removeprefix("result."), shown, "" if unit == "1" else unit, description))
        return rows

    def __repr__(self) -> str:
        end = f"{1e3 * self.state.time:.2f} ms, {self.steps} steps, {self.elements} elements"
        lines = [f"{name:<22} {value:>12} {unit}".rstrip() for name, value, unit, _ in self._rows()]
        note = ["* so far: cut off in contact, or held"] if self.cut else []
        return "\n".join([f"Result of {self.scenario!r}", f"{self.ending}: {end}", *self.warnings, *lines, *note])

    def _repr_html_(self) -> str:
        note = " * so far: cut off in contact, or held." if self.cut else ""
        head = f"{self.ending} after {1e3 * self.state.time:.2f} ms, {self.elements} elements.{note} {' '.join(self.warnings)}"
        return f"<p>{escape(repr(self.scenario))}: {escape(head)}</p>" + table(["", "value", "unit", "meaning"], self._rows())


def _samples(interval: float) -> int:
    samples = interval / SAMPLING_INTERVAL
    whole = round(samples) if np.isfinite(samples) else 0
    if not 1 <= whole <= 20_000 or abs(samples - whole) > 1e-6 * whole:
        raise ValueError(f"frames = {interval} s is refused: expected a whole multiple of 5e-05 s, up to 1 s")
    return whole


def run(scenario: Scenario, *, frames: float | None = None, impacts: int = 1, rest: float = 60.0) -> Result:
    """Simulates a drop until its contact has ended, or to the end of a ``time.duration`` that was given.

    Other Python threads run meanwhile, and Ctrl-C ends it.

    Args:
        scenario: What is dropped on what.
        frames: Time between two states to keep, s, a whole multiple of 50e-6; none keeps the last alone.
        impacts: Drops, one after the other, on the same anvil, which keeps its damage; 1 to 1000. The result is that of the last.
        rest: Time between two of them, s.

    Raises:
        ScenarioError: Values that have no effect, or do not fit together.
        SimulationError: A step that cannot be made.
        TypeError: Something else than a scenario.
    """
    if not 1 <= impacts <= 1000:
        raise ValueError(f"impacts = {impacts} is refused: expected 1 to 1000")
    samples = None if frames is None else _samples(frames)
    done = _softanvil.run(settings_of(scenario), samples, impacts, rest)
    return Result(done, scenario.copy())


@overload
def run_many(scenarios: Iterable[Scenario], *, threads: int = 0, errors: Literal["raise"] = "raise") -> list[Result]: ...


@overload
def run_many(
    scenarios: Iterable[Scenario], *, threads: int = 0, errors: Literal["return"]
) -> list[Result | Exception]: ...


def run_many(
    scenarios: Iterable[Scenario], *, threads: int = 0, errors: Literal["raise", "return"] = "raise"
) -> Sequence[Result | Exception]:
    """Simulates drops on all cores, in the order given; the results do not depend on how many cores there are.

    Args:
        scenarios: What to simulate. Every result holds its trace and last state: for more than some thousands see `sweep`.
        threads: How many at once; 0 for one per core.
        errors: Whether a drop that is refused or fails raises its exception, or puts it in its place.
    """
    if isinstance(scenarios, Scenario):
        raise TypeError("one scenario is refused: expected several; softanvil.run simulates one")
    listed = list(scenarios)
    if threads < 0:
        raise ValueError(f"threads = {threads} is refused: expected 0 (one per core) or more")
    results: list[Result | Exception] = []
    for done, scenario in zip(
        _softanvil.run_many([settings_of(scenario) for scenario in listed], threads), listed, strict=True
    ):
        if not isinstance(done, Exception):
            results.append(Result(done, scenario.copy()))
        elif errors == "raise":
            raise done
        else:
            results.append(done)
    return results
