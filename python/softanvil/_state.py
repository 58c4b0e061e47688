"""States of a simulation: fields as arrays, meshes, pictures of the section."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ._fields import FIELDS, Fields
from ._plot import section

if TYPE_CHECKING:
    from matplotlib.axes import Axes


class State(Fields):
    """The model at one time. It does not change, and arrays of its fields stay valid as long as they live.

    Fields that lie in memory (those of nodes but for ``node.position``, and ``surface.contact_force``) come without a copy,
    read-only; the others, and all of a solid, are computed. A simulation that shares the memory takes its own copy when it goes on.
    """

    __slots__ = ()

    def to_pyvista(self) -> Any:
        """The deformed mesh as a ``pyvista.UnstructuredGrid`` with every field of nodes and triangles (needs pyvista)."""
        import pyvista

        cells, positions = self.mesh()[1], self.positions()
        points = np.pad(positions, ((0, 0), (0, 3 - positions.shape[1])))
        kind = pyvista.CellType.TETRA if self._view.is_solid else pyvista.CellType.TRIANGLE
        grid = pyvista.UnstructuredGrid({kind: cells.astype(np.int64)}, points)
        for name in FIELDS:
            if name.startswith("node."):
                values = self.field(name)
                grid.point_data[name] = values.reshape(len(points), *values.shape[2:])
            elif name.startswith("element."):
                grid.cell_data[name] = self.of_triangles(name)
        grid.field_data["time"] = [self.time]
        return grid

    def plot(self, field: str = "element.von_mises_stress", ax: Axes | None = None) -> Axes:
        """Draws the deformed section, coloured by a field of triangles with one component; returns the axes.

        Raises:
            ScenarioError: A solid, which has no section; `to_pyvista` has its tetrahedra.
        """
        return section(self, field, ax)

    def __reduce__(self) -> tuple[Any, ...]:
        return (State, (self._view,))

    def __repr__(self) -> str:
        return f"<State at {1e3 * self.time:.3f} ms: {len(self.mesh()[1])} {'tetrahedra' if self._view.is_solid else 'triangles'}>"
