"""Simulations that go on by hand."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd

from . import _softanvil
from ._errors import ParameterError
from ._numbers import OUTPUTS
from ._scenario import Scenario
from ._state import State


class Simulation:
    """A drop, or a face that is driven from outside (``s.impactor.motion = "driven"``), step by step.

    A copy, an unpickled one and one restored from `save` go on with the same bits.

    Raises:
        ScenarioError: Values that have no effect, or do not fit together.
    """

    __slots__ = ("_core",)
    _core: _softanvil.Simulation

    def __init__(self, scenario: Scenario) -> None:
        self._core = _softanvil.Simulation(scenario._settings)

    @classmethod
    def of_state(cls, state: State) -> Simulation:
        """A simulation that goes on from a state."""
        made = cls.__new__(cls)
        made._core = _softanvil.Simulation.of_view(state._view)
        return made

    @property
    def scenario(self) -> Scenario:
        """What is simulated."""
        return Scenario._of(self._core.settings)

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self._core.time

    @property
    def step_index(self) -> int:
        """Steps made."""
        return self._core.step_index

    @property
    def time_step(self) -> float:
        """The fixed time step, s."""
        return self._core.dt

    def time_of(self, step_index: int) -> float:
        """Simulated time after so many steps from the start, s."""
        return self._core.time_of(step_index)

    @property
    def trace_hash(self) -> str:
        """Fingerprint of the force samples so far: equal for equal bits."""
        return self._core.trace_hash

    @property
    def digest(self) -> str:
        """Fingerprint of the whole state."""
        return self._core.digest()

    @property
    def state(self) -> State:
        """The state as it is now; it does not change when the simulation goes on."""
        return State(self._core.view())

    def output(self, name: str) -> float:
        """An output such as "contact.force", in SI units."""
        return self._core.output(name)

    __getitem__ = output

    def field(self, name: str) -> npt.NDArray[np.float64]:
        """The values of a field now; see `State.field`. The array does not change when the simulation goes on."""
        return self.state.field(name)

    def outputs(self) -> dict[str, float]:
        """Every output now, by name, in SI units."""
        return {name: self.output(name) for name in OUTPUTS}

    def step(
        self,
        steps: int = 1,
        *,
        position: float | None = None,
        velocity: float | None = None,
        external_force: float = 0.0,
    ) -> None:
        """Makes steps.

        Args:
            steps: How many.
            position: Height of a driven face above the undeformed anvil after the last of them, m; without it the face stays.
            velocity: Upward velocity of the driven face then, m/s: it moves along a cubic; without it along a line.
            external_force: Upward force on a falling impactor, N, held over the steps.

        Raises:
            ParameterError: An input that is refused; no step was made.
            SimulationError: A step that cannot be made; those before it are.
        """
        self._core.step(_count(steps, "steps"), external_force, position, velocity)

    def drive(
        self,
        position: npt.ArrayLike | None = None,
        velocity: npt.ArrayLike | None = None,
        *,
        external_force: npt.ArrayLike = 0.0,
        steps: int = 1,
        outputs: Sequence[str] = ("contact.force", "core.reaction", "impactor.position"),
    ) -> pd.DataFrame:
        """Makes `steps` steps for every entry of the inputs, and reads outputs after each.

        Args:
            position: Heights of a driven face (n,), m; see `step`.
            velocity: Its upward velocities (n,), m/s.
            external_force: Upward forces on a falling impactor (n,), N.
            steps: Steps from one entry to the next.
            outputs: Names of the outputs to read.

        Returns:
            A row for every entry by time in s, a column for every output; units in ``attrs["units"]``.
        """
        given = {"position": position, "velocity": velocity, "external_force": external_force}
        arrays = {name: np.asarray(value, dtype=float) for name, value in given.items() if value is not None}
        shape = np.broadcast_shapes((1,), *(array.shape for array in arrays.values()))
        if len(shape) != 1:
            raise ValueError(f"inputs of the shape {shape} are refused: expected one axis")
        rows = {name: np.ascontiguousarray(np.broadcast_to(array, shape)) for name, array in arrays.items()}
        first, each = self.step_index, _count(steps, "steps")
        values = self._core.step_rows(
            each, rows["external_force"], rows.get("position"), rows.get("velocity"), list(outputs)
        )
        times = [self.time_of(first + each * (row + 1)) for row in range(len(values))]
        frame = pd.DataFrame(values, index=pd.Index(times, name="time"), columns=list(outputs))
        frame.attrs["units"] = {"time": "s", **{name: OUTPUTS[name][0] for name in outputs}}
        return frame

    def run(self, duration: float) -> None:
        """Makes the steps that cover a duration in s, in whole sampling intervals of 50 us."""
        if not 5e-5 <= duration <= 100.0:
            message = f"duration = {duration} s is refused: expected 0.00005 to 100 s"
            raise ParameterError(message, "duration", duration, "s", 5e-5, 100.0)
        self._core.step(self._core.steps_in(duration), 0.0, None, None)

    def next_impact(self, rest: float = 60.0) -> None:
        """Lets the anvil rest for a time in s, and the impactor fall again on it, as it is then."""
        self._core.next_impact(rest)

    def reset(self) -> None:
        """Back to the start."""
        self._core.reset()

    def save(self) -> bytes:
        """The state as bytes, which `restore` takes on any platform.

        Raises:
            SimulationError: A state that has failed.
        """
        return self._core.save()

    def restore(self, state: bytes) -> None:
        """Goes on from what `save` gave, of the same model.

        Raises:
            SimulationError: Bytes that are no such state; nothing changes then.
        """
        self._core.restore(state)

    def copy(self) -> Simulation:
        """One that goes its own way."""
        return self.of_state(self.state)

    __copy__ = copy

    def __deepcopy__(self, memo: dict[int, Any]) -> Simulation:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (self._core.settings, self.save()))

    def __repr__(self) -> str:
        return f"<Simulation at {1e3 * self.time:.3f} ms, {self.step_index} steps: {self.scenario!r}>"


def _restored(settings: _softanvil.Settings, state: bytes) -> Simulation:
    made = Simulation(Scenario._of(settings))
    made.restore(state)
    return made


def _count(number: int, name: str) -> int:
    if isinstance(number, bool) or number != int(number) or number < 0:
        raise ValueError(f"{name} = {number} is refused: expected a whole number, 0 or more")
    return int(number)
