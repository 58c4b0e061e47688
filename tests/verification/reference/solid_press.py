"""A bonded round layer pressed by a rigid face without friction, in three dimensions, by felupe 11.3 (pip install felupe pypardiso).

    python solid_press.py anvil CELLS   # a short anvil with free ends under a face that covers it
    python solid_press.py face K CELLS  # the study's anvil under a round face, on which stays what lies under it at rest

K is the bulk modulus in MPa, CELLS are those of the layer's thickness, or of the 18 mm along z inside the edge of the face.

Quarter model of trilinear hexahedra with a mean dilatation each. The face presses at points of the facets of the surface, by a
penalty that lets in some micrometres. Prints depths in mm and forces in N; of `face` also those of the section, a slice between
held ends as thick as the chord of the face, and the ratio of both.
"""

import sys

import felupe as fem
import numpy as np
import scipy.sparse as sparse
from pypardiso import spsolve

CORE, LAYER, FACE = 37.5e-3, 15e-3, 65e-3
MU = 0.3e6
PENALTY = 2e11


class Anvil:
    """Nodes in columns, rows and slices; slices at `along` times the distance of the face's edge from z = 0, or at `along` m."""

    def __init__(self, columns, rows, along, follow_edge):
        angle, part, place = np.meshgrid(columns, np.linspace(0, 1, rows + 1), along, indexing="ij")
        radius = CORE + LAYER * part
        x, y, z = radius * np.sin(angle), radius * np.cos(angle), place
        if follow_edge:
            edge = np.sqrt(FACE**2 - ((CORE + LAYER) * np.sin(np.minimum(angle, 0.45))) ** 2)
            z = np.where(place <= 1, place * edge, edge + (75e-3 - edge) * (place - 1))
        self.node = np.arange(x.size).reshape(x.shape)
        near = self.node[:-1, :-1], self.node[1:, :-1], self.node[1:, 1:], self.node[:-1, 1:]
        cells = np.stack([n[..., :-1] for n in near] + [n[..., 1:] for n in near], -1).reshape(-1, 8)
        self.mesh = fem.Mesh(np.stack([x.ravel(), y.ravel(), z.ravel()], 1), cells, "hexahedron")
        top = self.node[:, -1]
        self.facets = np.stack([top[:-1, :-1], top[1:, :-1], top[1:, 1:], top[:-1, 1:]], -1).reshape(-1, 4)

    def free(self, held_ends):
        fixed = np.zeros((self.node.size, 3), bool)
        fixed[self.node[:, 0].ravel()] = True
        fixed[self.node[0].ravel(), 0] = True
        fixed[self.node[:, :, 0].ravel(), 2] = True
        if held_ends:
            fixed[self.node[:, :, -1].ravel(), 2] = True
        return np.flatnonzero(~fixed.ravel())


class Face:
    """Contact at 4 x 4 points of each facet."""

    def __init__(self, anvil, radius):
        points, weights = np.polynomial.legendre.leggauss(4)
        a, b = (grid.ravel() for grid in np.meshgrid(points, points, indexing="ij"))
        corners = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        one, two = (1 + np.outer(a, corners[:, 0])), (1 + np.outer(b, corners[:, 1]))
        self.shape, self.facets = one * two / 4, anvil.facets
        rest = self.rest = anvil.mesh.points[self.facets]
        along = [np.einsum("qa,fai->fqi", d, rest) for d in (corners[:, 0] * two / 4, corners[:, 1] * one / 4)]
        self.area = np.linalg.norm(np.cross(*along), axis=2) * np.outer(weights, weights).ravel()
        points = np.einsum("qa,fai->fqi", self.shape, rest)
        self.under = np.hypot(points[..., 0], points[..., 2]) <= radius

    def weigh(self, weight):
        """Makes the surface that much larger at a distance x from the middle, of positions at rest."""
        self.area = self.area * weight(np.einsum("qa,fa->fq", self.shape, self.rest[..., 0]))

    def press(self, positions, height):
        depth = np.einsum("qa,fa->fq", self.shape, positions[self.facets][..., 1]) - height
        stiffness = np.where((depth > 0) & self.under, PENALTY, 0) * self.area
        place, n = 3 * self.facets + 1, positions.size
        force = np.bincount(place.ravel(), np.einsum("fq,qa->fa", stiffness * depth, self.shape).ravel(), n)
        values = np.einsum("fq,qa,qb->fab", stiffness, self.shape, self.shape).ravel()
        rows, columns = np.repeat(place, 4, axis=1).ravel(), np.tile(place, (1, 4)).ravel()
        return force, sparse.csr_matrix((values, (rows, columns)), shape=(n, n)), (stiffness * depth).sum()


def balance(solid, field, face, free, height):
    """Newton's method; returns the force on the face."""
    rest, u = field.region.mesh.points, field[0].values
    for _ in range(40):
        inner = solid.assemble.vector(field).toarray().ravel()
        force, contact, total = face.press(rest + u, height)
        residual = (inner + force)[free]
        if np.linalg.norm(residual) < 1e-6 * np.linalg.norm(force):
            return total
        stiffness = (solid.assemble.matrix(field) + contact).tocsr()[free][:, free]
        move = spsolve(stiffness, -residual)
        u.ravel()[free] += move * min(1, 1.5e-3 / np.abs(move).max())
    raise RuntimeError(f"no equilibrium at {height} m")


def press(anvil, bulk, depths, radius=np.inf, chord=None):
    """Forces of the quarter at the depths under a face of this radius; with a `chord`, a function of x in m, those of a slice
    that is so many times as thick, between held ends."""
    region, face, held_ends = fem.RegionHexahedron(anvil.mesh), Face(anvil, radius), chord is not None
    if held_ends:
        region.dV = region.dV * chord(anvil.mesh.points[anvil.mesh.cells, 0].mean(axis=1))
        face.weigh(chord)
    field = fem.FieldContainer([fem.Field(region, dim=3)])
    solid = fem.SolidBodyNearlyIncompressible(fem.NeoHooke(mu=MU), field, bulk=bulk)
    free, forces, last = anvil.free(held_ends), [], 0.0
    for depth in depths:
        for part in (0.5, 1.0):
            height = CORE + LAYER - (last + (depth - last) * part)
            force = balance(solid, field, face, free, height)
        forces.append(force)
        last = depth
    return np.array(forces)


def spaced(*pieces):
    """Places from 0 on: (end, cells) of each piece."""
    places = [0.0]
    for end, cells in pieces:
        places += list(np.linspace(places[-1], end, cells + 1)[1:])
    return np.array(places)


def short_anvil(rows):
    """45 mm long, in the kernel's cells of 15 mm / rows, K = 7.4 MPa."""
    size, depths = LAYER / rows, [1e-3, 2e-3, 3e-3]
    columns = np.linspace(0, np.pi / 2, round(np.pi / 2 * (CORE + LAYER / 2) / size) + 1)
    anvil = Anvil(columns, rows, np.linspace(0, 22.5e-3, round(22.5e-3 / size) + 1), False)
    for depth, force in zip(depths, 4 * press(anvil, 7.4e6, depths)):
        print(f"{1e3 * depth:.1f}: {force:.2f}")


def round_face(bulk, belt):
    """150 mm long under a face of 130 mm; cells of 3 mm in the section, so many along z in the 18 mm inside its edge."""
    columns, depths = spaced((0.62, 9), (np.pi / 2, 8)), [1e-3, 2e-3, 3e-3, 4e-3, 5e-3]
    whole = Anvil(columns, 5, spaced((0.72, 12), (1.0, belt), (1.35, max(2, belt // 4)), (2.0, 2)), True)
    thickness = 3e-3
    section = Anvil(columns, 5, np.array([0, thickness]), False)
    sections = 2 * press(section, bulk, depths, chord=lambda x: 2 * np.sqrt(FACE**2 - x**2) / thickness)
    forces = 4 * press(whole, bulk, depths, radius=FACE)
    for depth, force, of_section in zip(depths, forces, sections):
        print(f"{1e3 * depth:.1f}: {force:.1f}, {of_section:.1f}, {force / of_section:.4f}", flush=True)


if sys.argv[1] == "anvil":
    short_anvil(int(sys.argv[2]))
else:
    round_face(1e6 * float(sys.argv[2]), int(sys.argv[3]))
