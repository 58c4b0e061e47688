"""Isochoric Mooney-Rivlin with U = K/2 (J - 1)^2 in plane strain, displacement and pressure apart, for scikit-fem."""

import numpy as np
import scipy.sparse.linalg
from scipy.sparse import bmat
from skfem import Basis, BilinearForm, ElementQuad1, ElementQuad2, ElementVector, LinearForm
from skfem.helpers import ddot, grad

STEP = 1e-7  # of the central difference that gives the tangent


def kinematics(gradient):
    jacobian = gradient[0, 0] * gradient[1, 1] - gradient[0, 1] * gradient[1, 0]
    cofactor = np.array([[gradient[1, 1], -gradient[1, 0]], [-gradient[0, 1], gradient[0, 0]]])
    return jacobian, cofactor


class Solid:
    """A mesh of biquadratic quadrilaterals of one material (c10, c01, bulk)."""

    def __init__(self, mesh, c10, c01, bulk):
        self.c10, self.c01, self.bulk = c10, c01, bulk
        self.element = ElementVector(ElementQuad2())
        self.u_basis = Basis(mesh, self.element, intorder=6)
        self.p_basis = self.u_basis.with_element(ElementQuad1())
        self.u, self.p = self.u_basis.zeros(), self.p_basis.zeros()
        self.forms()

    def stress(self, gradient, pressure):
        """First Piola-Kirchhoff stress; C33 = 1."""
        jacobian, cofactor = kinematics(gradient)
        inverse = cofactor / jacobian
        right = np.einsum("ki...,kj...->ij...", gradient, gradient)
        trace = right[0, 0] + right[1, 1]
        i1, i2 = trace + 1, jacobian**2 + trace
        first = 2 * self.c10 * jacobian ** (-2 / 3) * (gradient - i1 / 3 * inverse)
        product = np.einsum("ij...,jk...->ik...", gradient, right)
        second = 2 * self.c01 * jacobian ** (-4 / 3) * (i1 * gradient - product - 2 / 3 * i2 * inverse)
        return first + second + pressure * cofactor

    def forms(self):
        def gradient(w):
            return w["u"].grad + np.eye(2)[:, :, None, None]

        @LinearForm
        def force(v, w):
            return ddot(self.stress(gradient(w), w["p"].value), grad(v))

        @LinearForm
        def volume(q, w):
            return (kinematics(gradient(w))[0] - 1 - w["p"].value / self.bulk) * q

        @BilinearForm
        def stiffness(u, v, w):
            change = grad(u)
            step = STEP / (1e-30 + np.abs(change).max())
            ends = [self.stress(gradient(w) + s * step * change, w["p"].value) for s in (1, -1)]
            return ddot((ends[0] - ends[1]) / (2 * step), grad(v))

        @BilinearForm
        def coupling(u, q, w):
            return ddot(kinematics(gradient(w))[1], grad(u)) * q

        @BilinearForm
        def compliance(p, q, w):
            return -p * q / self.bulk

        self.all = force, volume, stiffness, coupling, compliance

    def balance(self, held, outside, scale):
        """Newton's method; `outside()` gives the force from outside and its derivative by the displacement."""
        free = np.setdiff1d(np.arange(self.u_basis.N + self.p_basis.N), held)
        force, volume, stiffness, coupling, compliance = self.all
        for iteration in range(40):
            fields = {"u": self.u_basis.interpolate(self.u), "p": self.p_basis.interpolate(self.p)}
            load, derivative = outside()
            residual = np.concatenate(
                [force.assemble(self.u_basis, **fields) - load, volume.assemble(self.p_basis, **fields)])
            if iteration and np.abs(residual[free]).max() < 1e-9 * scale(load):
                return iteration
            upper = stiffness.assemble(self.u_basis, **fields)
            upper = upper if derivative is None else upper - derivative
            side = coupling.assemble(self.u_basis, self.p_basis, **fields)
            matrix = bmat([[upper, side.T], [side, compliance.assemble(self.p_basis, **fields)]]).tocsr()
            change = np.zeros(len(residual))
            change[free] = scipy.sparse.linalg.spsolve(matrix[free][:, free].tocsc(), -residual[free])
            self.u += change[: self.u_basis.N]
            self.p += change[self.u_basis.N:]
        raise RuntimeError("no balance")
