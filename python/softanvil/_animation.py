"""The impact as an animation."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import Any

import numpy as np

from ._fields import Fields
from ._plot import Section


class Animation:
    """States after each other, which a notebook plays.

    Args:
        frames: The states.
        field: Field of triangles with one component that colours them, on one scale.
    """

    def __init__(self, frames: Sequence[Fields], field: str = "element.von_mises_stress") -> None:
        self.frames, self.field = list(frames), field

    def figure(self) -> tuple[Any, Any]:
        """The figure, and its ``matplotlib.animation.FuncAnimation``."""
        import matplotlib.pyplot as plt
        from matplotlib.animation import FuncAnimation

        section = Section(self.frames[0], self.field, largest=1.0)
        figure: Any = section.axes.figure
        section.cells.set_clim(*self._range(section))
        section.colorbar()

        def show(place: int) -> list[Any]:
            section.show(self.frames[place])
            return [section.cells, section.impactor]

        made = FuncAnimation(figure, show, frames=len(self.frames), interval=80, blit=False)
        plt.close(figure)
        return figure, made

    def _range(self, section: Section) -> tuple[float, float]:
        values = [section.scale * state.of_triangles(self.field) for state in self.frames]
        top = max(float(np.nanmax(np.abs(of_one))) for of_one in values) or 1.0
        return (-top if min(float(np.nanmin(of_one)) for of_one in values) < 0 else 0.0), top

    def to_html(self) -> str:
        """The animation with buttons, as HTML that needs nothing else."""
        return str(self.figure()[1].to_jshtml())

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the animation to a file, such as a .gif (by Pillow) or, where ffmpeg is, an .mp4."""
        self.figure()[1].save(os.fspath(path), writer="pillow" if str(path).endswith(".gif") else None)

    _repr_html_ = to_html

    def __repr__(self) -> str:
        return f"<Animation of {len(self.frames)} frames, {self.field}>"
