"""Kratos Multiphysics: total Lagrangian triangles, central differences, its own neo-Hookean law.

Its structural mechanics have no contact in explicit dynamics; a penalty on the surface nodes, with the impactor's motion,
is added here between the steps and left out of the time per element and step.
"""
import sys
import time

import KratosMultiphysics as K
import KratosMultiphysics.ConstitutiveLawsApplication as Laws
import KratosMultiphysics.StructuralMechanicsApplication as Structural

import problem

# Penalty of a surface node on half a section, N/m: indents by some hundredths of a millimetre.
PENALTY = 2e6
DT = 2e-6


def properties(part):
    young = 9 * problem.BULK * problem.SHEAR / (3 * problem.BULK + problem.SHEAR)
    material = part.CreateNewProperties(1)
    material[K.YOUNG_MODULUS] = young
    material[K.POISSON_RATIO] = young / (2 * problem.SHEAR) - 1
    material[K.DENSITY] = problem.DENSITY
    material[K.THICKNESS] = problem.LENGTH
    material[K.CONSTITUTIVE_LAW] = Laws.HyperElasticPlaneStrain2DLaw()
    return material


def build(model):
    part = model.CreateModelPart("layer", 2)
    part.ProcessInfo[K.DOMAIN_SIZE] = 2
    part.ProcessInfo[K.COMPUTE_LUMPED_MASS_MATRIX] = True
    part.ProcessInfo[Structural.RAYLEIGH_ALPHA] = 0.0
    part.ProcessInfo[Structural.RAYLEIGH_BETA] = 0.0
    for variable in (K.DISPLACEMENT, K.VELOCITY, K.ACCELERATION, K.REACTION, K.VOLUME_ACCELERATION, K.NODAL_MASS,
                     K.FORCE_RESIDUAL, K.RESIDUAL_VECTOR, Structural.MIDDLE_VELOCITY, Structural.POINT_LOAD):
        part.AddNodalSolutionStepVariable(variable)
    for index, (x, y) in enumerate(problem.nodes()):
        part.CreateNewNode(index + 1, x, y, 0.0)
    for dof, reaction in ((K.DISPLACEMENT_X, K.REACTION_X), (K.DISPLACEMENT_Y, K.REACTION_Y), (K.DISPLACEMENT_Z, K.REACTION_Z)):
        K.VariableUtils().AddDof(dof, reaction, part)
    material = properties(part)
    for index, corners in enumerate(problem.triangles()):
        part.CreateNewElement("TotalLagrangianElement2D3N", index + 1, [corner + 1 for corner in corners], material)
    for index, corner in enumerate(problem.surface()):
        part.CreateNewCondition("PointLoadCondition2D1N", index + 1, [corner + 1], material)
    for node in part.Nodes:
        u, v = (node.Id - 1) % (problem.COLUMNS + 1), (node.Id - 1) // (problem.COLUMNS + 1)
        if u == 0 or v == 0:
            node.Fix(K.DISPLACEMENT_X)
        if v == 0:
            node.Fix(K.DISPLACEMENT_Y)
    part.SetBufferSize(2)
    return part


def main():
    K.ParallelUtilities.SetNumThreads(1)
    K.Logger.GetDefaultOutput().SetSeverity(K.Logger.Severity.WARNING)
    part = build(K.Model())
    scheme = Structural.ExplicitCentralDifferencesScheme(1.0, 0.9, 0.0)
    strategy = Structural.MechanicalExplicitStrategy(part, scheme, False, False, True)
    strategy.SetRebuildLevel(0)
    strategy.SetEchoLevel(0)
    part.ProcessInfo[K.DELTA_TIME] = DT
    strategy.Initialize()
    strategy.Check()
    surface = [part.Nodes[corner + 1] for corner in problem.surface()]
    top = problem.CORE_RADIUS + problem.LAYER
    height, velocity = top + problem.GAP, -problem.SPEED
    steps, computing, peak = round(problem.DURATION / DT), 0.0, 0.0
    start = time.perf_counter()
    for step in range(1, steps + 1):
        force = 0.0
        for node in surface:
            depth = node.Y - height
            push = PENALTY * depth if depth > 0.0 else 0.0
            node.SetSolutionStepValue(Structural.POINT_LOAD_Y, -push)
            force += push
        velocity += DT * (2 * force / problem.MASS - problem.GRAVITY)
        height += DT * velocity
        peak = max(peak, 2 * force)
        part.CloneTimeStep(step * DT)
        part.ProcessInfo[K.STEP] = step
        before = time.process_time()
        strategy.InitializeSolutionStep()
        strategy.SolveSolutionStep()
        strategy.FinalizeSolutionStep()
        computing += time.process_time() - before
    wall = time.perf_counter() - start
    version = K.Kernel.Version()
    what = "penalty contact added between the steps"
    return problem.row("Kratos Multiphysics", version.split("-")[0].replace('"', ""), what, len(problem.triangles()), steps, wall,
                       computing, peak)


if __name__ == "__main__":
    problem.write(sys.argv[1], main())
