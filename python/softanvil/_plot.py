"""Pictures by matplotlib."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np
import pandas as pd

from ._errors import ScenarioError
from ._fields import FIELDS, Array, Fields

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


class Traced(Protocol):
    """What has a trace: a `softanvil.Result`."""

    @property
    def trace(self) -> pd.DataFrame:
        """Outputs by time in s; here "contact.force" and "impactor.deformation"."""
        ...


def force(results: Sequence[Traced], labels: Sequence[str] | None = None) -> Figure:
    """Contact force over time and over deformation, a line per result."""
    import matplotlib.pyplot as plt

    figure, (over_time, over_depth) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained", sharey=True)
    for place, result in enumerate(results):
        trace, label = result.trace, labels[place] if labels else None
        over_time.plot(1e3 * trace.index.to_numpy(), 1e-3 * trace["contact.force"], label=label)
        over_depth.plot(1e3 * trace["impactor.deformation"], 1e-3 * trace["contact.force"], label=label)
    over_time.set(xlabel="time (ms)", ylabel="contact force (kN)")
    over_depth.set(xlabel="deformation (mm)", xlim=(0, None))
    for axes in (over_time, over_depth):
        axes.grid(alpha=0.3)
        axes.spines[["top", "right"]].set_visible(False)
    if labels:
        over_time.legend(frameon=False)
    return figure


def compare(results: Sequence[Traced], labels: Sequence[str]) -> Figure:
    """Draws contact force over time and over deformation of several results, one line each; returns the figure."""
    if len(labels) != len(results):
        raise ValueError(f"{len(labels)} labels are refused: expected {len(results)}, one per result")
    return force(results, labels)


#: Pressures and stresses are shown in kPa.
_SHOWN = {"Pa": ("kPa", 1e-3)}


class Section:
    """The deformed section in some axes, by default new ones, whole, coloured by a field of triangles."""

    def __init__(self, state: Fields, field: str, axes: Axes | None = None, largest: float | None = None) -> None:
        import matplotlib.pyplot as plt
        from matplotlib.collections import PolyCollection

        if state._view.is_solid:
            raise ScenarioError("a solid has no section to draw: expected a section; State.to_pyvista has the solid")
        axes = axes if axes is not None else plt.subplots(figsize=(7, 4), layout="constrained")[1]
        self.field, self.axes = field, axes
        unit = FIELDS[field][0] if field in FIELDS else "1"
        self.unit, self.scale = _SHOWN.get(unit, (unit, 1.0))
        self.sides = (1.0, -1.0) if state._view.is_half else (1.0,)
        values = self._values(state)
        top = largest if largest is not None else float(np.nanmax(np.abs(values), initial=1e-12))
        lowest = float(np.nanmin(values, initial=0.0))
        self.cells = PolyCollection([], edgecolors="face", linewidths=0.2)
        axes.add_collection(self.cells)
        self.cells.set_clim(-top if lowest < 0 else 0.0, top)
        self.cells.set_cmap("RdBu_r" if lowest < 0 else "viridis")
        self.impactor = axes.fill([], [], color="0.6", zorder=0)[0]
        axes.set_aspect("equal")
        axes.set_xlabel("mm")
        self.show(state)
        points = 1e3 * state.mesh()[0]
        reach = 1.05 * np.abs(points[:, 0]).max()
        above = points[:, 1].max()
        axes.set_xlim(-reach, reach)
        axes.set_ylim(points[:, 1].min() - 0.05 * above, above + 12)

    def _values(self, state: Fields) -> Array:
        values = state.of_triangles(self.field)
        if values.ndim != 1:
            raise ValueError(f"field {self.field!r} is refused: expected a field of triangles with one component")
        return self.scale * values

    def show(self, state: Fields) -> None:
        """Draws another state."""
        corners = 1e3 * state.positions()[state.mesh()[1]]
        self.cells.set_verts([triangle * [side, 1.0] for side in self.sides for triangle in corners])
        self.cells.set_array(np.tile(self._values(state), len(self.sides)))
        rest = state.mesh()[0][:, 1].max()
        lift = [state._view.offset, rest + state.output("impactor.position")]
        self.impactor.set_xy(1e3 * (state._view.impactor() + lift))
        self.axes.set_title(f"{1e3 * state.time:.2f} ms")

    def colorbar(self) -> Any:
        """The scale of colours."""
        label = f"{self.field.split('.')[1].replace('_', ' ').replace('von mises', 'von Mises')} ({self.unit})"
        return self.axes.figure.colorbar(self.cells, ax=self.axes, label=label, shrink=0.8)


def section(state: Fields, field: str, ax: Axes | None) -> Axes:
    """Draws the deformed section; returns the axes."""
    drawn = Section(state, field, ax)
    drawn.colorbar()
    return drawn.axes
