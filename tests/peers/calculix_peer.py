"""CalculiX: wedges one cell thick between rollers, surface-to-surface penalty contact with a brick, explicit dynamics.

The brick is the impactor: so much stiffer than the layer that it is rigid, and free to fall.
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
# Penalty pressure per overclosure, Pa/m: indents by some hundredths of a millimetre.
PENALTY = 5e9
# Increments between printed reactions of the core.
STRIDE = 5
# The brick: width, height, and modulus, m and Pa. Its density gives half the impactor's mass.
WIDTH, HEIGHT, YOUNG = 70e-3, 20e-3, 1e9


def lines(numbers, per_line=10):
    numbers = list(numbers)
    return [", ".join(map(str, numbers[i:i + per_line])) for i in range(0, len(numbers), per_line)]


def top_faces():
    """The faces of the wedges on the surface."""
    surface = set(problem.surface())
    return [f"{index}, S{3 + edge}" for index, corners in enumerate(problem.triangles(), 1) for edge in range(3)
            if {corners[edge], corners[(edge + 1) % 3]} <= surface]


def deck():
    plane = problem.nodes()
    n = len(plane)
    nodes = [(x, y, z) for z in (0.0, problem.LENGTH) for x, y in plane]
    bottom = problem.CORE_RADIUS + problem.LAYER + problem.GAP
    # A little beyond the symmetry plane, so that the nodes on it lie within the face.
    box = [(x, y) for y in (bottom, bottom + HEIGHT) for x in (-5e-3, WIDTH)]
    brick = [(x, y, z) for z in (-5e-3, problem.LENGTH + 5e-3) for x, y in box]
    volume = (WIDTH + 5e-3) * HEIGHT * (problem.LENGTH + 10e-3)
    first = len(nodes) + 1
    text = ["*NODE, NSET=ALL"]
    text += [f"{i}, {x:.9g}, {y:.9g}, {z:.9g}" for i, (x, y, z) in enumerate(nodes, 1)]
    text += ["*NODE, NSET=BRICK"]
    text += [f"{i}, {x:.9g}, {y:.9g}, {z:.9g}" for i, (x, y, z) in enumerate(brick, first)]
    text += ["*ELEMENT, TYPE=C3D6, ELSET=LAYER"]
    for index, (a, b, c) in enumerate(problem.triangles(), 1):
        text.append(f"{index}, {a + 1}, {b + 1}, {c + 1}, {a + 1 + n}, {b + 1 + n}, {c + 1 + n}")
    block = len(problem.triangles()) + 1
    corners = [first, first + 1, first + 3, first + 2]
    text += ["*ELEMENT, TYPE=C3D8, ELSET=IMPACTOR",
             f"{block}, " + ", ".join(map(str, corners + [corner + 4 for corner in corners]))]
    core = [problem.number(u, 0) + 1 + z * n for u in range(problem.COLUMNS + 1) for z in (0, 1)]
    centre = [problem.number(0, v) + 1 + z * n for v in range(problem.ROWS + 1) for z in (0, 1)]
    for name, members in (("CORE", core), ("CENTRE", centre)):
        text += [f"*NSET, NSET={name}", *lines(members)]
    text += ["*SURFACE, NAME=SLAVE", *top_faces(), "*SURFACE, NAME=MASTER", f"{block}, S3"]
    text += ["*MATERIAL, NAME=RUBBER", "*HYPERELASTIC, NEO HOOKE", f"{problem.SHEAR / 2:.9g}, {2 / problem.BULK:.9g}",
             "*DENSITY", f"{problem.DENSITY}", "*SOLID SECTION, ELSET=LAYER, MATERIAL=RUBBER",
             "*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG:.9g}, 0.3", "*DENSITY", f"{0.5 * problem.MASS / volume:.9g}",
             "*SOLID SECTION, ELSET=IMPACTOR, MATERIAL=STEEL"]
    text += ["*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", f"{PENALTY:.9g}",
             "*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE", "SLAVE, MASTER"]
    text += ["*BOUNDARY", "ALL, 3, 3", "CENTRE, 1, 1", "CORE, 1, 2", "BRICK, 1, 1", "BRICK, 3, 3"]
    text += ["*INITIAL CONDITIONS, TYPE=VELOCITY", f"BRICK, 2, {-problem.SPEED:.9g}"]
    text += [f"*STEP, NLGEOM, INC={10 * round(problem.DURATION / DT)}",
             "*DYNAMIC, EXPLICIT", f"{DT:.9g}, {problem.DURATION:.9g}, {DT:.9g}, {DT:.9g}",
             "*DLOAD", f"IMPACTOR, GRAV, {problem.GRAVITY}, 0., -1., 0.",
             f"*NODE PRINT, NSET=CORE, TOTALS=ONLY, FREQUENCY={STRIDE}", "RF", "*END STEP"]
    return "\n".join(text) + "\n"


def main():
    version = re.search(r"Version (\S+)", subprocess.run(["ccx", "-v"], capture_output=True, text=True).stdout)[1]
    with tempfile.TemporaryDirectory() as folder:
        work = Path(folder)
        (work / "drop.inp").write_text(deck())
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        done = subprocess.run(["ccx", "drop"], cwd=work, capture_output=True, text=True,
                              env={"OMP_NUM_THREADS": "1", "PATH": "/usr/bin:/bin"})
        wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode != 0 or "Job finished" not in done.stdout:
            sys.exit(f"CalculiX failed:\n{done.stdout[-2000:]}{done.stderr}")
        printed = (work / "drop.dat").read_text()
    steps = round(problem.DURATION / float(re.search(r"SELECTED time increment:(\S+)", done.stdout)[1]))
    forces = [float(line.split()[1]) for line in printed.splitlines() if len(line.split()) == 3 and "." in line]
    computing = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    what = "wedges, penalty contact with a brick, force on the core; start included"
    return problem.row("CalculiX explicit", version, what, len(problem.triangles()), steps, wall, computing,
                       2 * max(map(abs, forces)))


if __name__ == "__main__":
    problem.write(sys.argv[1], main())
