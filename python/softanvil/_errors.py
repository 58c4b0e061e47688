"""What goes wrong, as exceptions."""

from __future__ import annotations


class SoftanvilError(Exception):
    """Base of all exceptions of this package."""


class ScenarioError(SoftanvilError, ValueError):
    """A scenario, or something said about one, that is refused: nothing was simulated."""


class ParameterError(ScenarioError):
    """A value that is refused.

    Attributes:
        name: Name of the parameter or input, such as "impactor.mass".
        value: The refused value.
        unit: Unit of the value; "1" for ratios, counts and choices.
        minimum: Smallest legal value, in that unit; of a choice, 0.
        maximum: Largest legal value.
    """

    def __init__(
        self, message: str, name: str, value: object, unit: str, minimum: float, maximum: float
    ) -> None:
        super().__init__(message, name, value, unit, minimum, maximum)
        self.name = name
        self.value = value
        self.unit = unit
        self.minimum = minimum
        self.maximum = maximum

    def __str__(self) -> str:
        return str(self.args[0])


class FileError(SoftanvilError, ValueError):
    """A file, or an option of a function that reads one, that is refused."""


class SimulationError(SoftanvilError, RuntimeError):
    """A simulation that failed on its way, or a file that cannot be written."""
