"""Kratos Multiphysics: total Lagrangian triangles or tetrahedra, central differences, its own neo-Hookean law.

Its structural mechanics have no contact in explicit dynamics; a penalty on the surface nodes, with the impactor's motion,
is added here between the steps and left out of the time per element and step.
"""
import time

import KratosMultiphysics as K
import KratosMultiphysics.ConstitutiveLawsApplication as Laws
import KratosMultiphysics.StructuralMechanicsApplication as Structural

import problem

DT = {"section": 2e-6, "solid": 4e-6}
ELEMENTS = {"section": "TotalLagrangianElement2D3N", "solid": "TotalLagrangianElement3D4N"}
LOADS = {"section": "PointLoadCondition2D1N", "solid": "PointLoadCondition3D1N"}
LAWS = {"section": Laws.HyperElasticPlaneStrain2DLaw, "solid": Laws.HyperElastic3DLaw}
DISPLACEMENTS = [K.DISPLACEMENT_X, K.DISPLACEMENT_Y, K.DISPLACEMENT_Z]
REACTIONS = [K.REACTION_X, K.REACTION_Y, K.REACTION_Z]


def properties(part, of):
    material = part.CreateNewProperties(1)
    material[K.YOUNG_MODULUS] = problem.YOUNG
    material[K.POISSON_RATIO] = problem.POISSON
    material[K.DENSITY] = problem.DENSITY
    if not of.slices:
        material[K.THICKNESS] = of.length
    material[K.CONSTITUTIVE_LAW] = LAWS[of.name]()
    return material


def build(model, of):
    part = model.CreateModelPart("layer", 2)
    part.ProcessInfo[K.DOMAIN_SIZE] = of.axes
    part.ProcessInfo[K.COMPUTE_LUMPED_MASS_MATRIX] = True
    part.ProcessInfo[Structural.RAYLEIGH_ALPHA] = 0.0
    part.ProcessInfo[Structural.RAYLEIGH_BETA] = 0.0
    for variable in (K.DISPLACEMENT, K.VELOCITY, K.ACCELERATION, K.REACTION, K.VOLUME_ACCELERATION, K.NODAL_MASS,
                     K.FORCE_RESIDUAL, K.RESIDUAL_VECTOR, Structural.MIDDLE_VELOCITY, Structural.POINT_LOAD):
        part.AddNodalSolutionStepVariable(variable)
    for index, (x, y, *z) in enumerate(of.nodes, 1):
        part.CreateNewNode(index, x, y, *(z or [0.0]))
    for displacement, reaction in zip(DISPLACEMENTS, REACTIONS):
        K.VariableUtils().AddDof(displacement, reaction, part)
    material = properties(part, of)
    for index, corners in enumerate(of.elements, 1):
        part.CreateNewElement(ELEMENTS[of.name], index, [corner + 1 for corner in corners], material)
    for index, corner in enumerate(of.surface, 1):
        part.CreateNewCondition(LOADS[of.name], index, [corner + 1], material)
    for axis in range(of.axes):
        for node in of.held(axis):
            part.Nodes[node + 1].Fix(DISPLACEMENTS[axis])
    part.SetBufferSize(2)
    return part


def strategy_of(part, step):
    scheme = Structural.ExplicitCentralDifferencesScheme(1.0, 0.9, 0.0)
    strategy = Structural.MechanicalExplicitStrategy(part, scheme, False, False, True)
    strategy.SetRebuildLevel(0)
    strategy.SetEchoLevel(0)
    part.ProcessInfo[K.DELTA_TIME] = step
    strategy.Initialize()
    strategy.Check()
    return strategy


def peer(of):
    K.ParallelUtilities.SetNumThreads(1)
    K.Logger.GetDefaultOutput().SetSeverity(K.Logger.Severity.WARNING)
    model, step = K.Model(), DT[of.name]
    part = build(model, of)
    strategy = strategy_of(part, step)
    surface = [part.Nodes[corner + 1] for corner in of.surface]
    impactor = problem.Impactor(of, step)
    steps, computing = round(of.duration / step), 0.0
    start = time.perf_counter()
    for index in range(1, steps + 1):
        for node, force in zip(surface, impactor.push([node.Y for node in surface])):
            node.SetSolutionStepValue(Structural.POINT_LOAD_Y, -force)
        part.CloneTimeStep(index * step)
        part.ProcessInfo[K.STEP] = index
        before = time.process_time()
        strategy.InitializeSolutionStep()
        strategy.SolveSolutionStep()
        strategy.FinalizeSolutionStep()
        computing += time.process_time() - before
    wall = time.perf_counter() - start
    version = K.Kernel.Version().split("-")[0].replace('"', "")
    what = "penalty contact added between the steps"
    return problem.row(of, "Kratos Multiphysics", version, what, steps, computing, wall, impactor.peak)


if __name__ == "__main__":
    problem.main(peer)
