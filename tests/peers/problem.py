"""The problem that every code solves: a layer of 15 mm on a rigid core, under a flat impactor of 5 kg with 14.7 J.

Half a section in plane strain, with the mesh of Softanvil at 3 mm: 24 x 5 cells, alternately split into 240 triangles. The
layer is neo-Hookean without damping, bonded to the core; the face is frictionless. The thickness of the section is below
every chord of the face, and so is constant. SI units.
"""
import csv
import math
import os

CORE_RADIUS, LAYER, LENGTH = 37.5e-3, 15e-3, 75e-3
MASS, ENERGY, GAP, GRAVITY = 5.0, 14.7, 2e-3, 9.81
DENSITY, SHEAR, BULK = 1072.0, 1.0e6, 4.0e6
COLUMNS, ROWS = 24, 5
# Simulated time: until the impactor has left.
DURATION = 9e-3

# Speed of the impactor at the start, when the gap is still open.
SPEED = math.sqrt(2 * ENERGY / MASS)


def node(u, v):
    """Position of the node in column u and row v, and its number from 0."""
    angle = math.pi / 2 * u / COLUMNS
    radius = CORE_RADIUS + LAYER * v / ROWS
    return radius * math.sin(angle), radius * math.cos(angle)


def number(u, v):
    return v * (COLUMNS + 1) + u


def nodes():
    return [node(u, v) for v in range(ROWS + 1) for u in range(COLUMNS + 1)]


def triangles():
    """Corners of the triangles, counter-clockwise."""
    found = []
    for v in range(ROWS):
        for u in range(COLUMNS):
            a, b, c, d = number(u, v), number(u + 1, v), number(u + 1, v + 1), number(u, v + 1)
            found += [(a, b, c), (a, c, d)] if (u + v) % 2 == 0 else [(a, b, d), (b, c, d)]
    return found


def surface():
    return [number(u, ROWS) for u in range(COLUMNS + 1)]


COLUMNS_OF_RESULTS = ["code", "version", "what runs", "elements", "steps", "wall time of the event s",
                      "ns per element and step", "element steps per second and core", "peak force N"]


def row(code, version, problem, elements, steps, wall, computing, peak):
    """Results of a code: `wall` for the whole event, `computing` of one core for its steps, s; `peak` in N, if any."""
    figures = [f"{wall:.3g}", f"{1e9 * computing / elements / steps:.3g}", f"{elements * steps / computing:.2e}",
               f"{peak:.0f}" if peak else ""]
    return [code, version, problem, elements, steps, *figures]


def write(path, results):
    """Adds a line to the file of results, which says what processor they are from."""
    with open("/proc/cpuinfo") as lines:
        processor = next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), "")
    new = not os.path.exists(path)
    with open(path, "a", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        if new:
            writer.writerow([*COLUMNS_OF_RESULTS, "processor"])
        writer.writerow([*results, processor])
    print(*results, sep=", ")
