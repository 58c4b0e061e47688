"""The fields of a model at one time, as arrays."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from . import _softanvil

#: Unit and meaning of every field, by its name.
FIELDS = {name: (unit, description) for name, unit, description in _softanvil.fields()}

Array = npt.NDArray[np.float64]


class Fields:
    """A model at one time: numbers, fields and mesh."""

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
            surface (columns,); with an axis of components behind, if there are several. A solid has a row for every slice of a
            row, 6 columns of a cell, and a surface of (slices, columns).

        Raises:
            ScenarioError: There is no such field; the message lists those that there are.
        """
        return self._view.field(name)

    __getitem__ = field

    def mesh(self) -> tuple[Array, npt.NDArray[np.uintp], npt.NDArray[np.uintp]]:
        """Nodes and triangles, or tetrahedra of a solid.

        Returns:
            Positions of the nodes at rest (nodes, 2) in m, x outwards and y upwards from the centre of the core, in the order of
            a field of nodes; nodes of every triangle (triangles, 3); its place among the values of a field of triangles
            (triangles,), which has those beside narrower layers, too. Of a solid (nodes, 3), with z along the axis of a prism,
            and (tetrahedra, 4).
        """
        return self._view.mesh()

    def positions(self) -> Array:
        """Current positions of the nodes (nodes, 2), of a solid (nodes, 3), m."""
        section = self.field("node.position").reshape(-1, 2)
        if not self._view.is_solid:
            return section
        return np.column_stack([section, (self.field("node.reference_z") + self.field("node.displacement_z")).ravel()])

    def of_triangles(self, name: str) -> Array:
        """The values of a field of triangles, or of tetrahedra, of those that are there: (triangles,) or (triangles, components)."""
        values, places = self.field(name), self.mesh()[2]
        return values.reshape(-1, *values.shape[2:])[places]
