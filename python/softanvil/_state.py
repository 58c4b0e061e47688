"""States of a simulation: fields as arrays, meshes, pictures of the section."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _softanvil

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ._simulation import Simulation

#: Unit and meaning of every field, by its name.
FIELDS = {name: (unit, description) for name, unit, description in _softanvil.fields()}

Array = npt.NDArray[np.float64]


class State:
    """The model at one time. It does not change, and arrays of its fields stay valid as long as they live.

    Fields that lie in memory (those of nodes but for ``node.position``, and ``surface.contact_force``) come without a copy,
    read-only; the others are computed. A simulation that shares the memory takes its own copy when it goes on.
    """

    __slots__ = ("_view",)

    def __init__(self, view: _softanvil.StateView) -> None:
        self._view = view

    @property
    def time(self) -> float:
        """Simulated time, s."""
        return self._view.time

    def output(self, name: str) -> float:
        """An output such as "contact.force", in SI units; `softanvil.outputs()` lists them."""
        return self._view.output(name)

    def field(self, name: str) -> Array:
        """The values of a field, in SI units; `softanvil.fields()` lists them.

        Returns:
            Of nodes (rows, columns) from the core to the surface and along it, of triangles (rows, 2 columns of cells), of the
            surface (columns,); with an axis of components behind, if there are several.

        Raises:
            ScenarioError: There is no such field; the message lists those that there are.
        """
        return self._view.field(name)

    __getitem__ = field

    def mesh(self) -> tuple[Array, npt.NDArray[np.uintp], npt.NDArray[np.uintp]]:
        """Nodes and triangles.

        Returns:
            Positions of the nodes at rest (nodes, 2) in m, x outwards and y upwards from the centre of the core, in the order of
            a field of nodes; nodes of every triangle (triangles, 3); its place among the values of a field of triangles
            (triangles,), which has those beside narrower layers, too.
        """
        return self._view.mesh()

    def positions(self) -> Array:
        """Current positions of the nodes (nodes, 2), m."""
        return self.field("node.position").reshape(-1, 2)

    def of_triangles(self, name: str) -> Array:
        """The values of a field of triangles, of those that are there (triangles,) or (triangles, components)."""
        values, places = self.field(name), self.mesh()[2]
        return values.reshape(-1, *values.shape[2:])[places]

    def to_pyvista(self) -> Any:
        """The deformed mesh as a ``pyvista.UnstructuredGrid`` with every field of nodes and triangles (needs pyvista)."""
        import pyvista

        _, triangles, _ = self.mesh()
        points = np.column_stack([self.positions(), np.zeros(len(self.positions()))])
        grid = pyvista.UnstructuredGrid({pyvista.CellType.TRIANGLE: triangles.astype(np.int64)}, points)
        for name in FIELDS:
            if name.startswith("node."):
                values = self.field(name)
                grid.point_data[name] = values.reshape(len(points), *values.shape[2:])
            elif name.startswith("element."):
                grid.cell_data[name] = self.of_triangles(name)
        grid.field_data["time"] = [self.time]
        return grid

    def plot(self, field: str = "element.von_mises_stress", ax: Axes | None = None) -> Axes:
        """Draws the deformed section, coloured by a field of triangles with one component; returns the axes."""
        from ._plot import section

        return section(self, field, ax)

    def simulation(self) -> Simulation:
        """A simulation that goes on from here."""
        from ._simulation import Simulation

        return Simulation._of(_softanvil.Simulation.of_view(self._view))

    def __reduce__(self) -> tuple[Any, ...]:
        return (State, (self._view,))

    def __repr__(self) -> str:
        return f"<State at {1e3 * self.time:.3f} ms: {len(self.mesh()[1])} triangles>"
