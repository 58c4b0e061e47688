"""The problems that every code solves: a layer of 15 mm on a rigid core, under a flat impactor of 5 kg with 14.7 J.

The layer is neo-Hookean without damping, bonded to the core; the face covers it and is frictionless. The meshes are those of
Softanvil at 3 mm: 24 x 5 cells of two triangles, or 24 x 5 x 25 of six tetrahedra. SI units.
"""
import csv
import math
import os
import sys
from dataclasses import dataclass
from functools import cached_property

CORE_RADIUS, LAYER = 37.5e-3, 15e-3
MASS, ENERGY, GAP, GRAVITY = 5.0, 14.7, 2e-3, 9.81
DENSITY, SHEAR, BULK = 1072.0, 1.0e6, 4.0e6
YOUNG = 9 * BULK * SHEAR / (3 * BULK + SHEAR)
POISSON = YOUNG / (2 * SHEAR) - 1
COLUMNS, ROWS = 24, 5
# Simulated time of codes whose only law is Saint Venant-Kirchhoff's, s. Pressed by more than two fifths it bears ever less, and
# the impactor goes through.
UNTIL_COLLAPSE = 3e-3
FIRST = f"first {1e3 * UNTIL_COLLAPSE:g} ms"
# Pressure per depth, Pa/m, of the codes in which a penalty stands for the contact: the face indents by some tenths of a
# millimetre at most.
PENALTY = 8e9

# Speed of the impactor at the start, when the gap is still open.
SPEED = math.sqrt(2 * ENERGY / MASS)
# Height of the surface at rest, and of the impactor at the start.
TOP = CORE_RADIUS + LAYER
START = TOP + GAP

# Tetrahedra of a cell: from corner 0 to 7 along its three edges in each order; an edge of a corner is a bit of its number.
PATHS = [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]


@dataclass(frozen=True)
class Problem:
    """A part of the anvil, symmetric to the others: a section in plane strain, or a solid with `slices` of cells along z."""

    name: str
    # How many such parts the anvil has.
    parts: int
    # Of the anvil along z, m.
    length: float
    slices: int
    # Simulated time: until the impactor has left, s.
    duration: float

    @property
    def axes(self):
        return 3 if self.slices else 2

    @property
    def meshed_length(self):
        return self.length / 2 if self.slices else self.length

    @cached_property
    def places(self):
        """Column, row and slice of the nodes, in their order."""
        return [(u, v, w) for w in range(self.slices + 1) for v in range(ROWS + 1) for u in range(COLUMNS + 1)]

    def number(self, u, v, w=0):
        return (w * (ROWS + 1) + v) * (COLUMNS + 1) + u

    @cached_property
    def nodes(self):
        """Positions: x across the anvil, y upwards and, in a solid, z along it."""
        return [self.position(*place)[:self.axes] for place in self.places]

    def position(self, u, v, w):
        angle = math.pi / 2 * u / COLUMNS
        radius = CORE_RADIUS + LAYER * v / ROWS
        return radius * math.sin(angle), radius * math.cos(angle), w * self.meshed_length / max(1, self.slices)

    @cached_property
    def elements(self):
        """Corners of the triangles, counter-clockwise, or of the tetrahedra, of positive volume."""
        cells = [(u, v) for v in range(ROWS) for u in range(COLUMNS)]
        if not self.slices:
            return [corners for cell in cells for corners in self.triangles(*cell)]
        return [corners for w in range(self.slices) for cell in cells for corners in self.tetrahedra(*cell, w)]

    def triangles(self, u, v):
        a, b, c, d = (self.number(*corner) for corner in ((u, v), (u + 1, v), (u + 1, v + 1), (u, v + 1)))
        return [(a, b, c), (a, c, d)] if (u + v) % 2 == 0 else [(a, b, d), (b, c, d)]

    def tetrahedra(self, u, v, w):
        """From the corner next to the centre line, the surface and z = 0 to the opposite one."""
        corner = [self.number(u + (i & 1), v + 1 - (i >> 1 & 1), w + (i >> 2)) for i in range(8)]
        ways = [(0, 1 << a, 1 << a | 1 << b, 7) for a, b, _ in PATHS]
        # The orders that are even permutations would be of negative volume.
        return [tuple(corner[i] for i in (way if odd(path) else (way[1], way[0], *way[2:]))) for path, way in zip(PATHS, ways)]

    @cached_property
    def surface(self):
        return [node for node, (_, v, _) in enumerate(self.places) if v == ROWS]

    @cached_property
    def areas(self):
        """Area that each node of the surface stands for, m2."""
        across = math.pi / 2 * TOP / COLUMNS
        along = self.meshed_length / max(1, self.slices)
        places = [self.places[node] for node in self.surface]
        return [across * half_at_ends(u, COLUMNS) * along * half_at_ends(w, self.slices) for u, _, w in places]

    @property
    def volume(self):
        return math.pi / 4 * (TOP**2 - CORE_RADIUS**2) * self.meshed_length

    def held(self, axis):
        """Nodes that the core or a plane of symmetry holds along the axis."""
        return [node for node, place in enumerate(self.places) if place[1] == 0 or place[axis] == 0]


def odd(path):
    return sum(path[i] > path[j] for i, j in ((0, 1), (0, 2), (1, 2))) % 2 == 1


def half_at_ends(place, last):
    return 0.5 if last and place in (0, last) else 1.0


# The section is below every chord of the study's face, and so its thickness is constant.
SECTION = Problem("section", parts=2, length=75e-3, slices=0, duration=9e-3)
SOLID = Problem("solid", parts=4, length=150e-3, slices=25, duration=7e-3)
PROBLEMS = {problem.name: problem for problem in (SECTION, SOLID)}


class Impactor:
    """The rigid impactor, for codes without a contact for it: it pushes the surface by a penalty, and moves step by step."""

    def __init__(self, problem, step):
        self.problem, self.step = problem, step
        self.height, self.velocity, self.peak = START, -SPEED, 0.0

    def push(self, heights):
        """Moves by a step; returns the forces downwards on the nodes of the surface, which are at these heights, N."""
        depths = (max(0.0, height - self.height) for height in heights)
        forces = [PENALTY * area * depth for area, depth in zip(self.problem.areas, depths)]
        force = self.problem.parts * sum(forces)
        self.peak = max(self.peak, force)
        self.velocity += self.step * (force / MASS - GRAVITY)
        self.height += self.step * self.velocity
        return forces


COLUMNS_OF_RESULTS = ["problem", "code", "version", "what runs", "elements", "steps", "wall time of the event s",
                      "ns per element and step", "element steps per second and core", "peak force N"]


def row(problem, code, version, what, steps, computing, wall=None, peak=None):
    """Results of a code: `computing` of one core for its steps, s; of the whole event its `wall` time, s, and `peak`, N."""
    work = len(problem.elements) * steps
    figures = [f"{wall:.3g}" if wall else "", f"{1e9 * computing / work:.3g}", f"{work / computing:.2e}",
               f"{peak:.0f}" if peak else ""]
    return [problem.name, code, version, what, len(problem.elements), steps, *figures]


def main(peer):
    """Lets a peer solve a problem: PEER FILE PROBLEM adds a line to the file of results, and says what processor it is from."""
    path, name, *arguments = sys.argv[1:]
    results = peer(PROBLEMS[name], *arguments)
    with open("/proc/cpuinfo") as lines:
        processor = next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), "")
    new = not os.path.exists(path)
    with open(path, "a", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        if new:
            writer.writerow([*COLUMNS_OF_RESULTS, "processor"])
        writer.writerow([*results, processor])
    print(*results, sep=", ")
