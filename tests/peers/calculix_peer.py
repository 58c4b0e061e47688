"""CalculiX: tetrahedra, or wedges one cell thick between rollers, in explicit dynamics.

The surface is in penalty contact with a brick, which is the impactor: free to fall, and so much stiffer than the layer that
it is rigid.
"""
import re
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import problem

DT = 4e-6
# Increments between printed reactions of the core.
STRIDE = 5
# The brick: width, height, how far it reaches beyond the layer elsewhere, m, and modulus, Pa; its density gives the mass.
WIDTH, HEIGHT, MARGIN, YOUNG = 70e-3, 20e-3, 5e-3, 1e9


def lines(numbers, per_line=10):
    numbers = list(numbers)
    return [", ".join(map(str, numbers[i:i + per_line])) for i in range(0, len(numbers), per_line)]


def faces(corners, of):
    """The nodes of each face of a triangle's wedge between its ends or of a tetrahedron, by their number in CalculiX."""
    if not of.slices:
        return {3 + edge: {corners[edge], corners[(edge + 1) % 3]} for edge in range(3)}
    a, b, c, d = corners
    return {1: {a, b, c}, 2: {a, d, b}, 3: {b, d, c}, 4: {c, d, a}}


def top_faces(of):
    surface = set(of.surface)
    return [f"{index}, S{face}" for index, corners in enumerate(of.elements, 1) for face, nodes in faces(corners, of).items()
            if nodes <= surface]


def layer(of):
    """Nodes and elements of the layer, from 1; a section between z = 0 and its length."""
    if of.slices:
        return of.nodes, "C3D4", of.elements
    n = len(of.nodes)
    nodes = [(*node, z) for z in (0.0, of.length) for node in of.nodes]
    return nodes, "C3D6", [(*corners, *(corner + n for corner in corners)) for corners in of.elements]


def brick(of):
    """Nodes of the impactor, and its density."""
    # A little beyond the planes of symmetry and the ends, so that the nodes on them lie within the face.
    width, length = (-MARGIN, WIDTH), (-MARGIN, of.meshed_length + MARGIN)
    nodes = [(x, y, z) for z in length for y in (problem.START, problem.START + HEIGHT) for x in width]
    volume = (WIDTH + MARGIN) * HEIGHT * (of.meshed_length + 2 * MARGIN)
    return nodes, problem.MASS / of.parts / volume


def block(header, rows, first=1):
    """A block of numbered lines of the deck, the first number `first`."""
    return [header, *(", ".join(f"{number:.9g}" for number in (index, *row)) for index, row in enumerate(rows, first))]


def held(of, nodes):
    """Boundary conditions of the layer: what the core and planes of symmetry hold, and a section along its length."""
    copies = len(nodes) // len(of.nodes)
    text = []
    for axis in range(3):
        members = [node + 1 + copy * len(of.nodes) for copy in range(copies) for node in of.held(axis)]
        text += [f"*NSET, NSET=HELD{axis + 1}", *lines(members)]
    return text + ["*BOUNDARY", *(f"HELD{axis}, {axis}, {axis}" for axis in (1, 2, 3))]


def deck(of):
    nodes, shape, elements = layer(of)
    box, density = brick(of)
    first, impactor = len(nodes) + 1, len(elements) + 1
    corners = [first, first + 1, first + 3, first + 2]
    text = block("*NODE, NSET=ALL", nodes) + block("*NODE, NSET=BRICK", box, first)
    text += block(f"*ELEMENT, TYPE={shape}, ELSET=LAYER", ([corner + 1 for corner in element] for element in elements))
    text += block("*ELEMENT, TYPE=C3D8, ELSET=IMPACTOR", [corners + [corner + 4 for corner in corners]], impactor)
    # HELD2 is the core: no plane of symmetry holds along y.
    text += [*held(of, nodes), "BRICK, 1, 1", "BRICK, 3, 3"]
    text += ["*SURFACE, NAME=SLAVE", *top_faces(of), "*SURFACE, NAME=MASTER", f"{impactor}, S3"]
    text += ["*MATERIAL, NAME=RUBBER", "*HYPERELASTIC, NEO HOOKE", f"{problem.SHEAR / 2:.9g}, {2 / problem.BULK:.9g}",
             "*DENSITY", f"{problem.DENSITY}", "*SOLID SECTION, ELSET=LAYER, MATERIAL=RUBBER",
             "*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG:.9g}, 0.3", "*DENSITY", f"{density:.9g}",
             "*SOLID SECTION, ELSET=IMPACTOR, MATERIAL=STEEL"]
    text += ["*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{problem.PENALTY:.9g}",
             "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "SLAVE, MASTER"]
    text += ["*INITIAL CONDITIONS, TYPE=VELOCITY", f"BRICK, 2, {-problem.SPEED:.9g}"]
    text += [f"*STEP, NLGEOM, INC={10 * round(of.duration / DT)}",
             "*DYNAMIC, EXPLICIT", f"{DT:.9g}, {of.duration:.9g}, {DT:.9g}, {DT:.9g}",
             "*DLOAD", f"IMPACTOR, GRAV, {problem.GRAVITY}, 0., -1., 0.",
             f"*NODE PRINT, NSET=HELD2, TOTALS=ONLY, FREQUENCY={STRIDE}", "RF", "*END STEP"]
    return "\n".join(text) + "\n"


def computed():
    """Processor time of all finished children, s."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def solve(text):
    """What CalculiX says and prints of a deck, and its processor and wall time, s."""
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "drop.inp").write_text(text)
        before, start = computed(), time.perf_counter()
        done = subprocess.run(["ccx", "drop"], cwd=work, capture_output=True, text=True,
                              env={"OMP_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"})
        wall = time.perf_counter() - start
        if done.returncode != 0 or "Job finished" not in done.stdout:
            sys.exit(f"CalculiX failed:\n{done.stdout[-2000:]}{done.stderr}")
        return done.stdout, (work / "drop.dat").read_text(), computed() - before, wall


def peer(of):
    version = re.search(r"Version (\S+)", subprocess.run(["ccx", "-v"], capture_output=True, text=True).stdout)[1]
    said, printed, computing, wall = solve(deck(of))
    steps = round(of.duration / float(re.search(r"SELECTED time increment:(\S+)", said)[1]))
    forces = [float(line.split()[1]) for line in printed.splitlines() if len(line.split()) == 3 and "." in line]
    what = ("" if of.slices else "wedges, ") + "penalty contact with a brick, force on the core; start included"
    return problem.row(of, "CalculiX explicit", version, what, steps, computing, wall, of.parts * max(map(abs, forces)))


if __name__ == "__main__":
    problem.main(peer)
