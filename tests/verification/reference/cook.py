"""Cook's membrane at finite strain, plane strain, neo-Hookean: python cook.py ELEMENTS_PER_SIDE."""

import sys

import numpy as np
from skfem import FacetBasis, LinearForm, MeshQuad

from mixed import Solid

YOUNG, NU, TRACTION = 240.565, 0.4999, 6.25
INCREMENTS = 5

n = int(sys.argv[1])
mesh = MeshQuad.init_tensor(np.linspace(0, 1, n + 1), np.linspace(0, 1, n + 1))
xi, eta = mesh.p
mesh = MeshQuad(np.array([48 * xi, 44 * xi + eta * (44 - 28 * xi)]), mesh.t)
mesh = mesh.with_boundaries({"left": lambda x: x[0] < 1e-9, "right": lambda x: x[0] > 48 - 1e-9})
solid = Solid(mesh, YOUNG / (4 * (1 + NU)), 0.0, YOUNG / (3 * (1 - 2 * NU)))
side = FacetBasis(mesh, solid.element, facets=mesh.boundaries["right"], intorder=6)
load = LinearForm(lambda v, w: TRACTION * v[1]).assemble(side)
held = solid.u_basis.get_dofs("left").all()
for k in range(1, INCREMENTS + 1):
    solid.balance(held, lambda: (k / INCREMENTS * load, None), lambda load: np.abs(load).max())
for x, y in [(48, 60), (48, 52)]:
    node = np.argmin(np.hypot(mesh.p[0] - x, mesh.p[1] - y))
    print(f"({x}, {y}): {solid.u[solid.u_basis.nodal_dofs[1, node]]:.4f}")
