"""Akantu: total Lagrangian triangles, central differences with lumped masses, Saint Venant-Kirchhoff's law.

Its neo-Hookean law gives no stress in plane strain. Its contact is left out: a penalty on the surface nodes, with the
impactor's motion, is added here between the steps and left out of the time per element and step.
"""
import sys
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

import akantu
import numpy

import problem

# Penalty of a surface node on half a section, N/m: indents by some hundredths of a millimetre.
PENALTY = 2e6
DT = 2e-6


def material():
    young = 9 * problem.BULK * problem.SHEAR / (3 * problem.BULK + problem.SHEAR)
    poisson = young / (2 * problem.SHEAR) - 1
    return (f"material elastic [\n name = layer\n rho = {problem.DENSITY}\n E = {young!r}\n nu = {poisson!r}\n"
            " finite_deformation = true\n]\n")


def mesh():
    made = akantu.Mesh(2)
    access = akantu.MeshAccessor(made)
    points, corners = numpy.array(problem.nodes()), numpy.array(problem.triangles())
    access.resizeNodes(len(points))
    made.getNodes()[:] = points
    made.addConnectivityType(akantu._triangle_3)
    access.resizeConnectivity(len(corners), akantu._triangle_3)
    made.getConnectivity(akantu._triangle_3)[:] = corners
    access.makeReady()
    return made


def build():
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "material.dat"
        file.write_text(material())
        akantu.parseInput(str(file))
    layer = mesh()
    model = akantu.SolidMechanicsModel(layer)
    model.initFull(_analysis_method=akantu._explicit_lumped_mass)
    blocked = model.getBlockedDOFs()
    blocked[: problem.COLUMNS + 1] = True
    blocked[:: problem.COLUMNS + 1, 0] = True
    model.setTimeStep(DT)
    return layer, model


def main():
    layer, model = build()
    surface = problem.surface()
    displacement, push = model.getDisplacement(), model.getExternalForce()
    rest = numpy.array([problem.nodes()[node][1] for node in surface])
    height, velocity = problem.CORE_RADIUS + problem.LAYER + problem.GAP, -problem.SPEED
    steps, computing, peak = round(problem.DURATION / DT), 0.0, 0.0
    start = time.perf_counter()
    for _ in range(steps):
        forces = PENALTY * numpy.maximum(0.0, rest + displacement[surface, 1] - height)
        # The triangles are one metre thick.
        push[surface, 1] = -forces / problem.LENGTH
        force = 2 * forces.sum()
        velocity += DT * (force / problem.MASS - problem.GRAVITY)
        height += DT * velocity
        peak = max(peak, force)
        before = time.process_time()
        model.solveStep()
        computing += time.process_time() - before
    wall = time.perf_counter() - start
    what = "St. Venant-Kirchhoff, penalty contact added between the steps"
    return problem.row("Akantu", version("akantu"), what, len(problem.triangles()), steps, wall, computing, peak)


if __name__ == "__main__":
    problem.write(sys.argv[1], main())
