"""Stretches over which laws are Drucker-stable, by felupe: stability.py, in the environment of peers.txt, rewrites
stability.csv beside this file, which tools/identify/tests/suite/drucker.rs compares with Softanvil's.

felupe's energies are differentiated twice by tensortrax (automatic differentiation), with respect to the deformation
gradient. In logarithmic strains e_i along the principal axes that is H_ij = l_i l_j A_iijj + delta_ij l_i P_ii, of which
the part without change of volume must be positive definite. The end of each range is found by bisection.
"""

import csv
from pathlib import Path

import felupe
import numpy as np
from felupe.constitution.tensortrax.models import hyperelastic as models
from tensortrax.math import trace
from tensortrax.math.linalg import det

SCAN = (0.1, 10.0)
STEPS = 2000
ISOCHORIC = np.array([[1.0, 0.0], [0.0, 1.0], [-1.0, -1.0]])
MODES = {
    "uniaxial": lambda l: np.array([l, l**-0.5, l**-0.5]),
    "planar": lambda l: np.array([l, 1.0 / l, 1.0]),
    "equibiaxial": lambda l: np.array([l, l**-2.0, l]),
}


def mooney_rivlin(C, c10, c01, c11, c20, c02):
    scale = det(C) ** (-1 / 3)
    i1 = scale * trace(C) - 3
    i2 = (scale**2 * (trace(C) ** 2 - trace(C @ C))) / 2 - 3
    return c10 * i1 + c01 * i2 + c11 * i1 * i2 + c20 * i1**2 + c02 * i2**2


def material(law, values):
    if law.startswith("ogden"):
        mu, alpha = values[::2], values[1::2]
        return felupe.Hyperelastic(models.ogden, mu=[m * a / 2 for m, a in zip(mu, alpha)], alpha=list(alpha))
    if law.startswith("yeoh"):
        return felupe.Hyperelastic(models.yeoh, **dict(zip(["C10", "C20", "C30"], [*values, 0.0, 0.0][:3])))
    if law == "mooney_rivlin_2":
        return felupe.Hyperelastic(models.mooney_rivlin, C10=values[0], C01=values[1])
    names = ["c10", "c01", "c11", "c20", "c02"]
    return felupe.Hyperelastic(mooney_rivlin, **dict(zip(names, [*values, 0.0, 0.0][:5])))


def lowest(umat, stretches):
    """Least eigenvalue of the tangent over its largest, at each of many principal stretches (3, n)."""
    F = np.zeros((3, 3, 1, stretches.shape[1]))
    for i in range(3):
        F[i, i, 0] = stretches[i]
    P, A = umat.gradient([F, None])[0][:, :, 0], umat.hessian([F, None])[0][:, :, :, :, 0]
    H = np.zeros((stretches.shape[1], 3, 3))
    for i in range(3):
        for j in range(3):
            H[:, i, j] = stretches[i] * stretches[j] * np.broadcast_to(A[i, i, j, j], stretches.shape[1])
        H[:, i, i] += stretches[i] * P[i, i]
    values = np.linalg.eigvalsh(ISOCHORIC.T @ H @ ISOCHORIC)
    return values[:, 0] / np.abs(values).max(axis=1)


def reach(umat, mode, end):
    path = np.linspace(1.0, end, STEPS)
    stable = lowest(umat, np.stack([MODES[mode](l) for l in path], axis=1)) > 0
    if stable.all():
        return end
    first = int(np.argmin(stable))
    if first == 0:
        return 1.0
    good, bad = path[first - 1], path[first]
    for _ in range(40):
        middle = 0.5 * (good + bad)
        if lowest(umat, MODES[mode](middle)[:, None])[0] > 0:
            good = middle
        else:
            bad = middle
    return good


# Coefficients in MPa: softening laws, laws of mixed signs, and some that are stable everywhere.
LAWS = [
    ("mooney_rivlin_2", [0.2, 0.1]),
    ("mooney_rivlin_2", [0.3, -0.02]),
    ("mooney_rivlin_2", [0.25, -0.1]),
    ("mooney_rivlin_2", [-0.02, 0.2]),
    ("mooney_rivlin_3", [0.1, 0.05, -0.005]),
    ("mooney_rivlin_3", [0.25, -0.02, 0.002]),
    ("mooney_rivlin_5", [0.1, 0.02, 0.003, -0.001, -0.0005]),
    ("mooney_rivlin_5", [0.066, 0.0635, -0.0032, 0.00317, 0.000159]),
    ("yeoh_2", [1.0, -0.05]),
    ("yeoh_3", [0.2, -0.02, 0.0006]),
    ("yeoh_3", [0.1, 0.01, -0.0001]),
    ("ogden_1", [0.2, 2.6]),
    ("ogden_2", [0.5, 2.0, -0.02, 4.0]),
    ("ogden_2", [-0.3, -2.0, 0.02, -5.0]),
    ("ogden_3", [0.63, 1.3, 0.0012, 5.0, -0.01, -2.0]),
    ("ogden_3", [0.63, 1.3, -0.0012, 5.0, 0.001, -3.0]),
]

with open(Path(__file__).resolve().parent / "stability.csv", "w", newline="") as file:
    table = csv.writer(file, lineterminator="\n")
    table.writerow(["law", "coefficients [MPa]", "mode", "stable from", "stable to", "felupe"])
    for law, values in LAWS:
        umat = material(law, values)
        for mode in MODES:
            ends = [f"{reach(umat, mode, end):.6f}" for end in SCAN]
            table.writerow([law, " ".join(map(str, values)), mode, *ends, felupe.__version__])
