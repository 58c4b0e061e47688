"""Frictionless rigid plane on a layer bonded to a rigid cylinder: python layer.py ELEMENTS_THROUGH_THE_LAYER.

Deflection in mm and force in N on a length of 50 mm, both halves. Mooney-Rivlin, c10 = 0.1 MPa, c01 = 0.06 MPa, K = 8 MPa.
The plane acts at quadrature points, by a penalty that lets it pass by a tenth of a micrometre.
"""

import sys

import numpy as np
from skfem import BilinearForm, FacetBasis, LinearForm, MeshQuad, MeshQuad2

from mixed import Solid

INNER, OUTER, LENGTH, DEPTH = 37.5e-3, 52.5e-3, 50e-3, 5e-3
PENALTY = 1e13
INCREMENTS = 20

n = int(sys.argv[1])
around = round(n * 0.5 * (INNER + OUTER) * np.pi / 2 / (OUTER - INNER))
mesh = MeshQuad.init_tensor(np.linspace(0, 1, n + 1), np.linspace(0, 1, around + 1))
r, angle = INNER + (OUTER - INNER) * mesh.p[0], np.pi / 2 * (1 - mesh.p[1])
mesh = MeshQuad(np.array([r * np.cos(angle), r * np.sin(angle)]), mesh.t)
mesh = mesh.with_boundaries({
    "core": lambda x: np.hypot(x[0], x[1]) < INNER + 1e-6,
    "top": lambda x: np.hypot(x[0], x[1]) > OUTER * np.cos(np.pi / 4 / around) - 1e-6,
    "centre": lambda x: x[0] < 1e-9,
})
# Nodes amid the edges go onto the arcs.
curved = MeshQuad2.from_mesh(mesh)
r, angle = np.hypot(*curved.doflocs), np.arctan2(curved.doflocs[1], curved.doflocs[0])
row = (OUTER - INNER) / (2 * n)
r = INNER + np.round((r - INNER) / row + 1e-9) * row
curved.doflocs[:] = np.array([r * np.cos(angle), r * np.sin(angle)])

solid = Solid(curved, 0.1e6, 0.06e6, 8e6)
top = FacetBasis(curved, solid.element, facets=mesh.boundaries["top"], intorder=9)
held = np.unique(np.concatenate([
    solid.u_basis.get_dofs(mesh.boundaries["core"]).all(),
    solid.u_basis.get_dofs(mesh.boundaries["centre"]).all(["u^1"]),
]))


def gap(w):
    return w.x[1] + w["u"].value[1] - w["height"]


push = LinearForm(lambda v, w: -PENALTY * np.maximum(gap(w), 0) * v[1])
slope = BilinearForm(lambda u, v, w: -PENALTY * (gap(w) > 0) * u[1] * v[1])


def plane():
    fields = {"u": top.interpolate(solid.u), "height": OUTER - depth}
    return push.assemble(top, **fields), slope.assemble(top, **fields)


for k in range(1, INCREMENTS + 1):
    depth = DEPTH * k / INCREMENTS
    solid.balance(held, plane, lambda load: max(-load.sum(), 1e-3))
    if k % 4 == 0:
        print(f"{1e3 * depth:.0f} {-2 * LENGTH * plane()[0].sum():.2f}")
