"""Parameters as attributes, made from the kernel's table: a row there is an attribute here.

`_groups.pyi` is this module for type checkers; `python stubs.py` writes it.
"""

from __future__ import annotations

from typing import Any

from . import _softanvil
from ._html import table

#: Short names of parameters of the start, with what they stand for and say.
SHORT = {
    "energy": "kinetic energy at the start, whatever states it; given, it states the drop",
    "height": "free fall before the start, whatever states it; given, it states the drop",
    "speed": "downward speed at the start, whatever states it; given, it states the drop",
}


class Parameter:
    """One parameter of a group: gives its value, takes numbers in its unit and texts such as "14.7 J"."""

    def __init__(self, field: str, row: dict[str, Any], description: str) -> None:
        self.field, self.unit, self.labels = field, row["unit"], tuple(row["labels"])
        self.minimum, self.maximum = row["minimum"], row["maximum"]
        unit = "" if self.unit == "1" else f" {self.unit}"
        legal = " | ".join(self.labels) or f"{self.minimum:g} to {self.maximum:g}{unit}"
        self.__doc__ = f"{description} ({legal})"

    def __get__(self, group: Group | None, owner: type | None = None) -> Any:
        return self if group is None else group._settings.get(group._prefix + self.field)

    def __set__(self, group: Group, value: object) -> None:
        group._settings.set(group._prefix + self.field, value)

    def __delete__(self, group: Group) -> None:
        group._settings.unset(group._prefix + self.field)


class Group:
    """Some parameters of a scenario, as attributes.

    What is given counts: an attribute that is set and has no effect beside the others is refused when the scenario is
    simulated; ``del`` takes it back.
    """

    __slots__ = ("_prefix", "_settings")

    def __init__(self, settings: _softanvil.Settings, prefix: str) -> None:
        object.__setattr__(self, "_settings", settings)
        object.__setattr__(self, "_prefix", prefix)

    @classmethod
    def _parameters(cls) -> dict[str, Parameter]:
        return {name: found for base in reversed(cls.__mro__) for name, found in vars(base).items()
                if isinstance(found, Parameter)}

    def _unknown(self, name: str) -> AttributeError:
        try:
            self._settings.get(self._prefix + name)
        except (ValueError, IndexError) as error:
            return AttributeError(str(error))
        return AttributeError(f"{self._prefix}{name} is no attribute")

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        raise self._unknown(name)

    def __setattr__(self, name: str, value: object) -> None:
        if getattr(type(self), name, None) is None:
            raise self._unknown(name)
        object.__setattr__(self, name, value)

    def as_dict(self) -> dict[str, Any]:
        """Value of every parameter of the group, by its name within the group; in SI units."""
        return {name: getattr(self, name) for name in self._parameters() if not self._is_short(name)}

    def _is_short(self, name: str) -> bool:
        return self._prefix == "impactor." and name in SHORT

    def _rows(self) -> list[tuple[str, str, str, str, bool]]:
        """Name, value, unit, meaning and whether it acts, of every parameter."""
        idle = set(self._settings.without_effect())
        rows = []
        for name, parameter in self._parameters().items():
            if not self._is_short(name):
                value, unit = getattr(self, name), "" if parameter.unit == "1" else parameter.unit
                shown = f"{value:g}" if isinstance(value, float) else str(value)
                rows.append((name, shown, unit, str(parameter.__doc__), self._prefix + name not in idle))
        return rows

    def __repr__(self) -> str:
        lines = [f"{self._prefix}{name} = {value} {unit}".rstrip() for name, value, unit, _, acts in self._rows() if acts]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        return table(["parameter", "value", "unit", "meaning"],
                     [[self._prefix + name, value, unit, meaning] for name, value, unit, meaning, acts in self._rows() if acts])


def _classes() -> dict[str, type[Group]]:
    members: dict[str, dict[str, Any]] = {}
    for row in _softanvil.parameters():
        group = members.setdefault(row["group"], {})
        group[row["field"]] = Parameter(row["field"], row, row["description"])
        short = row["field"].removeprefix("drop_")
        if row["group"] == "impactor" and short in SHORT:
            group[short] = Parameter(short, row, SHORT[short])
    made: dict[str, type[Group]] = {}
    for group, found in members.items():
        name = "LayerParameters" if group == "layers" else f"{group.capitalize()}Group"
        if group == "layers":
            found.pop("count")
        made[group] = type(name, (Group,), {"__slots__": (), "__module__": __name__, "__doc__": Group.__doc__, **found})
    return made


#: The class of every group, by the name of the group; that of "layers" is one of a single layer.
GROUPS = _classes()
globals().update({made.__name__: made for made in GROUPS.values()})
