"""Scenarios: what is dropped on what."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _softanvil
from ._groups import GROUPS, LayerParameters
from ._named import Groups

if TYPE_CHECKING:
    from ._groups import Value


class Layer(LayerParameters):
    """A soft layer: its parameters as attributes, and its name."""

    __slots__ = ("_place",)
    _place: int

    def __init__(self, settings: _softanvil.Settings, place: int) -> None:
        super().__init__(settings, f"layers[{place}].")
        object.__setattr__(self, "_place", place)

    @property
    def name(self) -> str:
        """What people call it; 1 to 23 letters, digits, _ and -, or nothing."""
        return self._settings.layers[self._place]

    @name.setter
    def name(self, name: str) -> None:
        self._settings.name_layer(self._place, name)

    def __repr__(self) -> str:
        return f"layers[{self._place}].name = {self.name!r}\n{super().__repr__()}"


class Layers:
    """The layers of a scenario, from the core to the surface: by place, or by name."""

    __slots__ = ("_settings",)

    def __init__(self, settings: _softanvil.Settings) -> None:
        object.__setattr__(self, "_settings", settings)

    _settings: _softanvil.Settings

    def __setattr__(self, name: str, value: object) -> None:
        if name != "count":
            raise AttributeError(f"layers.{name} is no attribute: expected layers.count, or layers[0].{name}")
        object.__setattr__(self, name, value)

    @property
    def count(self) -> int:
        """How many layers there are, 1 to 4; more are spare ones, of plain elastic silicone, that need a thickness."""
        return len(self)

    @count.setter
    def count(self, count: int) -> None:
        self._settings.set("layers.count", count)

    def __len__(self) -> int:
        return len(self._settings.layers)

    def __getitem__(self, place: int | str) -> Layer:
        names = self._settings.layers
        if isinstance(place, str):
            if place not in names:
                raise KeyError(f"no layer is called {place!r}: expected {', '.join(filter(None, names)) or 'a number'}")
            return Layer(self._settings, names.index(place))
        found = range(len(names))
        if not -len(names) <= place < len(names):
            raise IndexError(f"layers[{place}] is not there: layers.count is {len(names)}")
        return Layer(self._settings, found[place])

    def __iter__(self) -> Iterator[Layer]:
        return (self[place] for place in range(len(self)))

    def add(self, name: str | None = None, **values: Value) -> Layer:
        """Lays another layer on the others.

        Args:
            name: What to call it.
            values: Its parameters, such as ``thickness="10 mm"``; the others are those of a plain elastic silicone.

        Returns:
            The layer.

        Raises:
            ParameterError: There are four already, or a value is refused; nothing is added then.
        """
        trial = self._settings.copy()
        trial.set("layers.count", len(self) + 1)
        place = len(self)
        for target in (trial, self._settings):
            target.set("layers.count", place + 1)
            if name is not None:
                target.name_layer(place, name)
            for field, value in values.items():
                target.set(f"layers[{place}].{field}", value)
        return self[place]

    def __repr__(self) -> str:
        return f"<{len(self)} layers: {', '.join(name or '(no name)' for name in self._settings.layers)}>"


class Scenario(Groups):
    """One drop test: parameters by group, ``s.impactor.energy = 9.8``, ``s.layers[0].thickness = "12 mm"``, ``s.silicone.c10``.

    A scenario is a preset with what is given over it. Of values that state the same thing (energy, height and speed; bulk
    modulus and Poisson's ratio; time step and safety factor) the last one counts. Numbers are in SI units; texts with a unit
    and quantities of pint are taken as well.

    Args:
        preset: Name of the preset to start from; `softanvil.presets()` lists them.
    """

    __slots__ = ("_settings",)
    _settings: _softanvil.Settings

    def __init__(self, preset: str = "study") -> None:
        object.__setattr__(self, "_settings", _softanvil.Settings(preset))

    @classmethod
    def _of(cls, settings: _softanvil.Settings) -> Scenario:
        made = cls.__new__(cls)
        object.__setattr__(made, "_settings", settings)
        return made

    @classmethod
    def from_toml(cls, text: str, preset: str = "study") -> Scenario:
        """The scenario that a TOML text, as `to_toml` and the command line write it, makes of a preset.

        Raises:
            ScenarioError: A line that is no TOML, names no parameter, or gives it an illegal value; with its number.
        """
        made = cls(preset)
        made._settings.read(text, False)
        return made

    @classmethod
    def read(cls, path: str | os.PathLike[str], preset: str = "study") -> Scenario:
        """The same from a file."""
        return cls.from_toml(Path(path).read_text(encoding="utf-8"), preset)

    def to_toml(self) -> str:
        """The scenario as a TOML text, with unit, legal range and meaning of every line."""
        return self._settings.to_toml()

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes that text to a file."""
        Path(path).write_text(self.to_toml(), encoding="utf-8")

    def with_material(self, material: str | os.PathLike[str]) -> Scenario:
        """A copy with the material of a file that `fit` has written (``material.toml``), or of its text; what was given stays
        over it."""
        made = self.copy()
        is_text = isinstance(material, str) and "\n" in material
        text = str(material) if is_text else Path(material).read_text(encoding="utf-8")
        made._settings.read(text, True)
        return made

    def copy(self) -> Scenario:
        """A copy that goes its own way."""
        return self._of(self._settings.copy())

    __copy__ = copy

    def __deepcopy__(self, memo: dict[int, Any]) -> Scenario:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        return (Scenario._of, (self._settings,))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scenario) and self._settings == other._settings

    __hash__ = None  # type: ignore[assignment]

    @property
    def preset(self) -> str:
        """Name of the preset that it starts from."""
        return self._settings.preset

    @property
    def given(self) -> dict[str, Any]:
        """The values given over the preset, or over the text that was read, by name."""
        return {name: self._settings.get(name) for name in self._settings.given}

    @property
    def layers(self) -> Layers:
        """The soft layers, from the core to the surface."""
        return Layers(self._settings)

    def __getattr__(self, name: str) -> Layer:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self._settings.layers:
            return self.layers[name]
        known = ", ".join([*(group for group in GROUPS if group != "layers"), "layers", *filter(None, self._settings.layers)])
        raise AttributeError(f"{name} is no group of parameters: expected {known}")

    def __setattr__(self, name: str, value: object) -> None:
        getattr(self, name)
        raise AttributeError(f"{name} cannot be replaced: set its attributes")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *filter(None, self._settings.layers)]

    def __getitem__(self, name: str) -> Any:
        """The value of a parameter by its full name, such as "impactor.mass", "layers[0].c10" or "silicone.c10"."""
        return self._settings.get(name)

    def __setitem__(self, name: str, value: Value) -> None:
        self._settings.set(name, value)

    def __delitem__(self, name: str) -> None:
        self._settings.unset(name)

    def update(self, values: Mapping[str, Value]) -> Scenario:
        """Gives several values by name, all of them or, if one is refused, none; returns the scenario itself."""
        for target in (self._settings.copy(), self._settings):
            for name, value in values.items():
                target.set(name, value)
        return self

    def validate(self) -> None:
        """Checks that every given value acts and that they fit together, as a run does before it starts.

        Raises:
            ScenarioError: What does not.
        """
        self._settings.validate()

    def summary(self) -> str:
        """What is simulated, in lines: the drop, the anvil, and what its materials are."""
        return self._settings.text()

    def __repr__(self) -> str:
        given = "".join(f", {name}={value!r}" for name, value in self.given.items())
        return f"Scenario({self.preset!r}{given})"

    def _repr_html_(self) -> str:
        try:
            text = self.summary()
        except ValueError as error:
            text = f"{self!r}\nrefused: {error}"
        return f"<pre>{escape(text)}</pre>"


def preset(name: str = "study") -> Scenario:
    """The preset called `name`; `presets()` lists them."""
    return Scenario(name)


def presets() -> dict[str, str]:
    """The presets: what each is, by name."""
    return dict(_softanvil.presets())


def settings_of(scenario: object) -> _softanvil.Settings:
    """What the library takes for a scenario.

    Raises:
        TypeError: Something else than a scenario.
    """
    if not isinstance(scenario, Scenario):
        raise TypeError(f'{scenario!r} is no scenario: expected a softanvil.Scenario, such as softanvil.preset("study")')
    return scenario._settings
