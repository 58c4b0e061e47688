"""The measured numbers of a drop as attributes, made from the kernel's table of outputs.

`_numbers.pyi` is this module for type checkers; `python stubs.py` writes it.
"""

from __future__ import annotations

from typing import Any

from . import _softanvil


class Number:
    """A measured number: gives its value."""

    def __init__(self, name: str, unit: str, description: str) -> None:
        self.name = name
        self.__doc__ = f"{description}{'' if unit == '1' else ', ' + unit}"

    def __get__(self, result: Any, owner: type | None = None) -> Any:
        return self if result is None else result.outputs[self.name]


#: Unit and meaning of every output, by its name.
OUTPUTS = {name: (unit, description) for name, unit, description in _softanvil.outputs()}

Numbers = type(
    "Numbers",
    (),
    {
        "__module__": __name__,
        "__doc__": "The measured numbers of a drop, in SI units.",
        **{
            name.removeprefix("result."): Number(name, unit, description)
            for name, (unit, description) in OUTPUTS.items()
            if name.startswith("result.") and name != "result.complete"
        },
    },
)
