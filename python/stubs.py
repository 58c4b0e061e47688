"""Writes the stubs of what is made from the kernel's tables: stubs.py. tests/test_package.py shows that they are those."""

from pathlib import Path

from softanvil import _softanvil
from softanvil._groups import GROUPS, SHORT

PACKAGE = Path(__file__).parent / "softanvil"

GROUPS_HEAD = '''\
# Written by stubs.py from the kernel's table of parameters.
from typing import Any, Generic, Literal, Protocol, SupportsFloat, TypeVar, overload

from . import _softanvil

class _Quantity(Protocol):
    """A quantity of pint."""

    @property
    def magnitude(self) -> Any: ...
    def to(self, other: Any, /) -> Any: ...

#: What a parameter takes: a number in its unit, a text ("14.7 J", or a label), or a quantity of pint.
Value = SupportsFloat | str | _Quantity

SHORT: dict[str, str]

_T = TypeVar("_T")

class Parameter(Generic[_T]):
    field: str
    unit: str
    labels: tuple[str, ...]
    minimum: float
    maximum: float
    @overload
    def __get__(self, group: None, owner: type) -> Parameter[_T]: ...
    @overload
    def __get__(self, group: Group, owner: type) -> _T: ...
    def __set__(self, group: Group, value: Value) -> None: ...
    def __delete__(self, group: Group) -> None: ...

class Choice(Generic[_T]):
    """One of several labels."""

    field: str
    labels: tuple[str, ...]
    @overload
    def __get__(self, group: None, owner: type) -> Choice[_T]: ...
    @overload
    def __get__(self, group: Group, owner: type) -> _T: ...
    def __set__(self, group: Group, value: _T) -> None: ...
    def __delete__(self, group: Group) -> None: ...

class Group:
    _settings: _softanvil.Settings
    _prefix: str
    def __init__(self, settings: _softanvil.Settings, prefix: str) -> None: ...
    def as_dict(self) -> dict[str, Any]: ...
    def _repr_html_(self) -> str: ...
'''

NUMBERS_HEAD = """\
# Written by stubs.py from the kernel's table of outputs.
OUTPUTS: dict[str, tuple[str, str]]

class Numbers:
    outputs: dict[str, float]
"""

SCENARIO_HEAD = """\
# Written by stubs.py: the groups of parameters as attributes.
from ._groups import {classes}

class Groups:
"""


def legal(row):
    """Unit and range of a row, for people."""
    unit = "" if row["unit"] == "1" else f" {row['unit']}"
    return " | ".join(row["labels"]) or f"{row['minimum']:g} to {row['maximum']:g}{unit}"


def groups():
    """The text of _groups.pyi."""
    text, rows = GROUPS_HEAD, _softanvil.parameters()
    for group, made in GROUPS.items():
        text += f"\nclass {made.__name__}(Group):\n"
        for row in rows:
            if row["group"] != group or row["name"] == "layers.count":
                continue
            labels = ", ".join(f'"{label}"' for label in row["labels"])
            kind = {"quantity": "Parameter[float]", "count": "Parameter[int]", "choice": f"Choice[Literal[{labels}]]"}
            entry = f'    {{}}: {kind[row["kind"]]}\n    """{{}} ({legal(row)})"""\n'
            text += entry.format(row["field"], row["description"])
            short = row["field"].removeprefix("drop_")
            if group == "impactor" and short in SHORT:
                text += entry.format(short, SHORT[short])
    return text + "\nGROUPS: dict[str, type[Group]]\n"


def numbers():
    """The text of _numbers.pyi."""
    text = NUMBERS_HEAD
    for name, unit, description in _softanvil.outputs():
        if name.startswith("result.") and name != "result.complete":
            shown = "" if unit == "1" else f", {unit}"
            text += f'    @property\n    def {name.removeprefix("result.")}(self) -> float:\n        """{description}{shown}"""\n'
    return text


def scenario():
    """The text of _named.pyi."""
    made = {group: found.__name__ for group, found in GROUPS.items() if group != "layers"}
    text = SCENARIO_HEAD.format(classes=", ".join(sorted(made.values())))
    for group, name in made.items():
        text += f"    @property\n    def {group}(self) -> {name}: ...\n"
    return text


#: The text of every stub that is written, by its name.
STUBS = {"_groups.pyi": groups, "_numbers.pyi": numbers, "_named.pyi": scenario}

if __name__ == "__main__":
    for name, text in STUBS.items():
        (PACKAGE / name).write_text(text(), encoding="utf-8")
