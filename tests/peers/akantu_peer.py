"""Akantu: total Lagrangian triangles or tetrahedra, central differences with lumped masses, Saint Venant-Kirchhoff's law.

Its neo-Hookean law has no stress in plane strain and is not implemented in three dimensions. Its contact is left out: a
penalty on the surface nodes, with the impactor's motion, is added here between the steps and left out of the time per element
and step.
"""
import tempfile
import time
from importlib.metadata import version
from pathlib import Path

import akantu
import numpy

import problem

DT = {"section": 2e-6, "solid": 4e-6}
SHAPES = {"section": akantu._triangle_3, "solid": akantu._tetrahedron_4}


def material():
    return (f"material elastic [\n name = layer\n rho = {problem.DENSITY}\n E = {problem.YOUNG!r}\n nu = {problem.POISSON!r}\n"
            " finite_deformation = true\n]\n")


def mesh(of):
    made = akantu.Mesh(of.axes)
    access = akantu.MeshAccessor(made)
    shape = SHAPES[of.name]
    access.resizeNodes(len(of.nodes))
    made.getNodes()[:] = numpy.array(of.nodes)
    made.addConnectivityType(shape)
    access.resizeConnectivity(len(of.elements), shape)
    made.getConnectivity(shape)[:] = numpy.array(of.elements)
    access.makeReady()
    return made


def build(of):
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "material.dat"
        file.write_text(material())
        akantu.parseInput(str(file))
    layer = mesh(of)
    model = akantu.SolidMechanicsModel(layer)
    model.initFull(_analysis_method=akantu._explicit_lumped_mass)
    for axis in range(of.axes):
        model.getBlockedDOFs()[of.held(axis), axis] = True
    model.setTimeStep(DT[of.name])
    return layer, model


def peer(of):
    layer, model = build(of)
    displacement, velocity, acceleration = model.getDisplacement(), model.getVelocity(), model.getAcceleration()
    load = model.getExternalForce()
    rest = numpy.array([of.nodes[node][1] for node in of.surface])
    # Triangles are one metre thick.
    thickness = 1.0 if of.slices else of.length
    step = DT[of.name]
    impactor = problem.Impactor(of, step)
    steps, computing = round(problem.UNTIL_COLLAPSE / step), 0.0
    for _ in range(steps):
        # Its step moves the nodes before it takes the forces: a load of where they were would feed the contact with energy.
        moved = (state[of.surface, 1] for state in (displacement, step * velocity, 0.5 * step**2 * acceleration))
        load[of.surface, 1] = -numpy.array(impactor.push((rest + sum(moved)).tolist())) / thickness
        before = time.process_time()
        model.solveStep()
        computing += time.process_time() - before
    what = f"St. Venant-Kirchhoff, penalty contact added between the steps; {problem.FIRST}"
    return problem.row(of, "Akantu", version("akantu"), what, steps, computing)


if __name__ == "__main__":
    problem.main(peer)
