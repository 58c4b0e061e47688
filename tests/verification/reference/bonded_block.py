"""Rubber block bonded between rigid plates, in the linear limit: python bonded_block.py ELEMENTS_THROUGH_HALF_THE_THICKNESS.

Prints the apparent modulus over three shear moduli for shape factors (half of a side, or the radius, over two thicknesses) and bulk
over shear moduli: squares as an eighth of triquadratic displacements and trilinear pressures, discs as a quarter of a section of
biquadratic displacements and bilinear pressures with four times as many elements; finer towards the edges of the bonds.
"""

import sys

import numpy as np
import scipy.sparse.linalg
from scipy.sparse import bmat
from skfem import (Basis, BilinearForm, ElementHex1, ElementHex2, ElementQuad1, ElementQuad2, ElementVector, MeshHex,
                   MeshQuad)
from skfem.helpers import ddot, div, sym_grad

SQUARES = [(0.5, 1e4), (1.0, 1e4), (2.0, 1e4), (2.0, 50.0)]
DISCS = [(1.0, 1e4)]


@BilinearForm
def shear(u, v, w):
    # Deviatoric: the pressure is that of the kernel's law, from the change of volume alone.
    return 2 * ddot(sym_grad(u), sym_grad(v)) - 2 / 3 * div(u) * div(v)


@BilinearForm
def coupling(u, q, w):
    return div(u) * q


@BilinearForm
def compliance(p, q, w):
    return -p * q / w["bulk"]


def growth(u, w):
    """Change of volume of a body of revolution about the second axis."""
    return div(u) + u[0] / w.x[0]


@BilinearForm
def shear_revolved(u, v, w):
    hoops = u[0] * v[0] / w.x[0] ** 2
    return w.x[0] * (2 * ddot(sym_grad(u), sym_grad(v)) + 2 * hoops - 2 / 3 * growth(u, w) * growth(v, w))


@BilinearForm
def coupling_revolved(u, q, w):
    return w.x[0] * growth(u, w) * q


@BilinearForm
def compliance_revolved(p, q, w):
    return -w.x[0] * p * q / w["bulk"]


def graded(n, power):
    """Places from 0 to 1, closer towards 1."""
    return 1 - (1 - np.linspace(0, 1, n + 1)) ** power


def force(mesh, elements, forms, bulk):
    """Of the plate, the last direction's upper end, moved by 1 towards the planes of symmetry."""
    u_basis = Basis(mesh, ElementVector(elements[0]), intorder=5)
    p_basis = u_basis.with_element(elements[1])
    stiffness, side = forms[0].assemble(u_basis), forms[1].assemble(u_basis, p_basis)
    matrix = bmat([[stiffness, side.T], [side, forms[2].assemble(p_basis, bulk=bulk)]]).tocsr()
    dimensions = mesh.p.shape[0]
    planes = [u_basis.get_dofs(lambda x, i=i: x[i] < 1e-9).all([f"u^{i + 1}"]) for i in range(dimensions)]
    plate = u_basis.get_dofs(lambda x: x[-1] > 1 - 1e-9)
    down = plate.all([f"u^{dimensions}"])
    held = np.unique(np.concatenate([*planes, plate.all()]))
    x = np.zeros(matrix.shape[0])
    x[down] = -1.0
    free = np.setdiff1d(np.arange(len(x)), held)
    x[free] = scipy.sparse.linalg.spsolve(matrix[free][:, free].tocsc(), -(matrix @ x)[free])
    return -(matrix @ x)[down].sum()


def square(half, bulk, n):
    along = half * graded(max(n, round(n * np.sqrt(half))), 2)
    mesh = MeshHex.init_tensor(along, along, graded(n, 2))
    return force(mesh, (ElementHex2(), ElementHex1()), (shear, coupling, compliance), bulk) / half**2


def disc(radius, bulk, n):
    mesh = MeshQuad.init_tensor(radius * graded(round(n * np.sqrt(radius)), 2), graded(n, 2))
    forms = shear_revolved, coupling_revolved, compliance_revolved
    return 2 * force(mesh, (ElementQuad2(), ElementQuad1()), forms, bulk) / radius**2


n = int(sys.argv[1])
for shape_factor, bulk in DISCS:
    print(f"disc, S = {shape_factor}, K = {bulk:g} G: {disc(4 * shape_factor, bulk, 4 * n) / 3:.4f}", flush=True)
for shape_factor, bulk in SQUARES:
    print(f"square, S = {shape_factor}, K = {bulk:g} G: {square(4 * shape_factor, bulk, n) / 3:.4f}", flush=True)
