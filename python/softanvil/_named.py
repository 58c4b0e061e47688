"""The groups of parameters as attributes of a scenario, from the kernel's table.

`_named.pyi` is this module for type checkers; `python stubs.py` writes it.
"""

from __future__ import annotations

from typing import Any

from ._groups import GROUPS


def _group(name: str) -> property:
    return property(lambda scenario: GROUPS[name](scenario._settings, f"{name}."), doc=f"Parameters {name}.*")


Groups: Any = type(
    "Groups",
    (),
    {"__slots__": (), "__module__": __name__, "__doc__": __doc__,
     **{name: _group(name) for name in GROUPS if name != "layers"}},
)
