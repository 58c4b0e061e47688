"""A cylinder of foam between bonded plates, axisymmetric, by felupe 11.3 (pip install felupe tensortrax): python foam.py ELEMENTS.

Nominal stress in Pa over nominal strain. Storakers' law with two terms, 40 mm wide and 20 mm high, linear quadrilaterals.
"""

import sys

import felupe as fem
import numpy as np
from felupe.constitution.tensortrax.models.hyperelastic import storakers

MU, ALPHA, NU = [120e3, 50e3], [8.0, -2.0], [0.05, 0.2]
RADIUS, HEIGHT, STRAIN, INCREMENTS = 20e-3, 20e-3, 0.4, 16

n = int(sys.argv[1])
mesh = fem.Rectangle(b=(HEIGHT, RADIUS), n=(n + 1, n + 1))
field = fem.FieldContainer([fem.FieldAxisymmetric(fem.RegionQuad(mesh), dim=2)])
beta = [nu / (1 - 2 * nu) for nu in NU]
solid = fem.SolidBody(fem.constitution.tensortrax.Hyperelastic(storakers, mu=MU, alpha=ALPHA, beta=beta), field)
for k in range(1, INCREMENTS + 1):
    strain = STRAIN * k / INCREMENTS
    bounds = {
        "axis": fem.Boundary(field[0], fy=0, skip=(1, 0)),
        "bottom": fem.Boundary(field[0], fx=0, skip=(0, 0)),
        "side": fem.Boundary(field[0], fx=HEIGHT, skip=(1, 0)),
        "top": fem.Boundary(field[0], fx=HEIGHT, skip=(0, 1), value=-strain * HEIGHT),
    }
    dof0, dof1 = fem.dof.partition(field, bounds)
    ext0 = fem.dof.apply(field, bounds, dof0)
    field = fem.newtonraphson(items=[solid], x0=field, dof0=dof0, dof1=dof1, ext0=ext0, verbose=0).x
    force = solid.assemble.vector(field).toarray().reshape(-1, 2)
    top = np.isclose(mesh.points[:, 0], HEIGHT)
    print(f"{strain:.3f}: {-force[top, 0].sum() / (np.pi * RADIUS**2):.1f}")
