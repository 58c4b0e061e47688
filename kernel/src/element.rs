//! The cells of the section: two linear triangles each, total Lagrangian, with the pressure of their mean dilatation.
//!
//! For each triangle F = I + sum (u_a - u_0) (x) dN_a/dX, and the polar decomposition F = R U of the section is closed:
//! R is the rotation by the angle of (F11 + F22, F21 - F12). All deviatoric stresses live in the unrotated frame. The
//! two triangles of a cell share p = U'(J-bar) with J-bar their volume-weighted mean Jacobian (a mean-dilatation patch,
//! Nagtegaal, Parks and Rice 1974), which removes volumetric locking and derives from an energy. The first
//! Piola-Kirchhoff stress is P = R T R^T F^-T with T = dev + p J I, and the nodal force V P dN/dX.

use crate::kinematics::Kinematics;
use crate::lanes::{Deviator, LANES, Lane, SQRT_THIRD, ZERO};
use crate::material::Laws;
use crate::mesh::out_of_plane;
use crate::real::Real;
use crate::response::deviatoric_stress;
use crate::scenario::Scenario;
use crate::vector::{Instructions, Vector};

/// Constants of the triangles of a block of cells; all zero in padding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellConstants {
    /// 1 where the diagonal runs from corner 0 to corner 2, 0 where it runs from corner 1 to corner 3.
    pub rising: Lane,
    /// First and second triangle of each cell: the first has the bottom edge, the second the top edge.
    pub triangle: [TriangleConstants; 2],
}

/// Constants of one triangle of each cell of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleConstants {
    /// dN/dX_j for the two edges that the triangle shares with its cell, shape (2 x 2), 1/m: the one along the row, then
    /// the one across. F = I + sum (difference of u along the edge, as x and y grow) (x) gradient.
    pub shape_gradient: [[Lane; 2]; 2],
    /// V0, m3.
    pub reference_volume: Lane,
    /// Part of the cell's volume.
    pub patch_weight: Lane,
    /// 1/(2 A0), 1/m2.
    pub inverse_double_area: Lane,
}

/// Derivative of the hoop stretch with respect to the radial displacement of each corner, shape (2 x 4), 1/m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoopConstants {
    /// 1/(3 R) for the corners of each triangle, R its centroid's radius.
    pub weight: [[Lane; 4]; 2],
}

/// What the triangles of a block of cells remember.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellHistory {
    /// First and second triangle of each cell.
    pub triangle: [TriangleHistory; 2],
}

/// What one triangle of each cell of a block remembers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHistory {
    /// Right stretch of the last step: mean, half difference, shear, hoop (see [`Kinematics`]).
    pub stretch_prev: [Lane; 4],
    /// Long-term isochoric stress of the last step, Pa, before any tear.
    pub elastic_prev: Deviator,
    /// Stress of the damping spring, Pa, before any tear.
    pub slider_stress: Deviator,
    /// Largest principal stretch so far, where the material can tear; 1 otherwise.
    pub largest_stretch: Lane,
    /// Isochoric and spring energy of the last step before any tear, J/m3, where the material can tear; 0 otherwise.
    pub stored_prev: Lane,
}

impl CellConstants {
    /// Padding: no volume.
    pub const ZERO: Self = Self {
        rising: ZERO,
        triangle: [TriangleConstants {
            shape_gradient: [[ZERO; 2]; 2],
            reference_volume: ZERO,
            patch_weight: ZERO,
            inverse_double_area: ZERO,
        }; 2],
    };
}

impl HoopConstants {
    /// Padding.
    pub const ZERO: Self = Self { weight: [[ZERO; 4]; 2] };
}

impl CellHistory {
    /// At rest: unit stretch, no stress.
    pub const REST: Self = Self {
        triangle: [TriangleHistory {
            stretch_prev: [ONE, ZERO, ZERO, ONE],
            elastic_prev: Deviator::ZERO,
            slider_stress: Deviator::ZERO,
            largest_stretch: ONE,
            stored_prev: ZERO,
        }; 2],
    };
}

const ONE: Lane = [1.0; LANES];

/// Differences of displacement along two edges of a triangle, shape (2 x 2), m: along the row, then across. Or the forces
/// that pull at their ends, N.
pub(crate) type Edges<V> = [[V; 2]; 2];

/// Sums over the triangles of each lane: energies of the section, J.
#[derive(Clone, Copy, Debug)]
pub struct ElementEnergy {
    /// Long-term elastic energy, isochoric and volumetric.
    pub elastic: Lane,
    /// Energy stored in the damping springs.
    pub slider_stored: Lane,
    /// Work done on the viscous overstress in this step.
    pub viscous_increment: Lane,
    /// Energy dissipated by the sliders in this step.
    pub slider_increment: Lane,
    /// Energy dissipated by tearing in this step.
    pub tear_increment: Lane,
    /// Not an energy: 1 in lanes with a triangle whose Jacobian is not positive, or not a number; 0 in others.
    pub inverted: Lane,
}

impl ElementEnergy {
    /// Nothing yet.
    pub const ZERO: Self = Self {
        elastic: ZERO,
        slider_stored: ZERO,
        viscous_increment: ZERO,
        slider_increment: ZERO,
        tear_increment: ZERO,
        inverted: ZERO,
    };
}

/// Displacements of the four corners of neighbouring cells, shape (4 x 2), m, or the forces on them, N.
pub type Corners<V> = [[V; 2]; 4];

/// Internal forces on the corners of neighbouring cells, N, from their displacements; advances the history of their
/// triangles.
///
/// `viscous` holds the overstress of the first triangle's terms, then of the second's. The history of an inverted
/// triangle ([`ElementEnergy::inverted`]) is not to be used.
#[inline(always)]
pub fn internal_force<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    displacement: &Corners<S::Vector>,
    history: &mut CellHistory,
    viscous: &mut [Deviator],
    energy: &mut ElementEnergy,
) -> Corners<S::Vector> {
    let edges = triangle_edges(set, set.load(&block.constants.rising, chunk), displacement);
    let kinematics = kinematics(set, chunk, block, displacement, &edges);
    let pressure = patch_pressure(set, chunk, block, &kinematics, energy);
    let [(a, first), (b, second)] = deviatoric_stress(set, chunk, block, &kinematics, history, viscous);
    for (triangle, density) in block.constants.triangle.iter().zip([first, second]) {
        let volume = set.load(&triangle.reference_volume, chunk);
        density.add_to(set, chunk, volume, block.laws, energy);
    }
    let [k, l] = &kinematics;
    let stress =
        [spatial_stress(set, chunk, block, 0, k, pressure, &a), spatial_stress(set, chunk, block, 1, l, pressure, &b)];
    let [of_first, of_second] = &block.constants.triangle;
    let edges = [
        edge_forces(set, chunk, of_first, &edges[0], &stress[0]),
        edge_forces(set, chunk, of_second, &edges[1], &stress[1]),
    ];
    let mut force = corner_forces(set, set.load(&block.constants.rising, chunk), &edges);
    if let Some(hoop) = block.hoop {
        for (t, deviator) in [&a, &b].into_iter().enumerate() {
            let volume = set.load(&block.constants.triangle[t].reference_volume, chunk);
            let kirchhoff = pressure * kinematics[t].jacobian - deviator.mean.times(2.0 * SQRT_THIRD);
            let nominal = volume * kirchhoff / kinematics[t].hoop;
            add_hoop_force(set, chunk, nominal, &hoop.weight[t], &mut force);
        }
    }
    force
}

/// What does not change in a block of cells.
#[derive(Clone, Copy)]
pub struct Block<'m> {
    /// Laws of its layer.
    pub laws: &'m Laws,
    /// Its triangles at rest.
    pub constants: &'m CellConstants,
    /// Hoop constants, in rings.
    pub hoop: Option<&'m HoopConstants>,
}

/// Deformation of the two triangles of each cell.
#[inline(always)]
pub(crate) fn cell_kinematics<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    displacement: &Corners<S::Vector>,
) -> [Kinematics<S::Vector>; 2] {
    let edges = triangle_edges(set, set.load(&block.constants.rising, chunk), displacement);
    kinematics(set, chunk, block, displacement, &edges)
}

/// [`cell_kinematics`] with the differences of displacement along the edges.
#[inline(always)]
fn kinematics<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    displacement: &Corners<S::Vector>,
    edges: &[Edges<S::Vector>; 2],
) -> [Kinematics<S::Vector>; 2] {
    let hoop = match block.hoop {
        Some(HoopConstants { weight: [a, b] }) => {
            [Some(hoop_stretch(set, chunk, a, displacement)), Some(hoop_stretch(set, chunk, b, displacement))]
        }
        None => [None; 2],
    };
    let [a, b] = &block.constants.triangle;
    [Kinematics::new(set, chunk, a, &edges[0], hoop[0]), Kinematics::new(set, chunk, b, &edges[1], hoop[1])]
}

/// Hoop stretch of a triangle, from the radial displacements of its corners.
#[inline(always)]
fn hoop_stretch<S: Instructions>(set: S, chunk: usize, weight: &[Lane; 4], corners: &Corners<S::Vector>) -> S::Vector {
    let mut stretch = set.splat(1.0);
    for a in 0..4 {
        stretch = stretch + set.load(&weight[a], chunk) * corners[a][0];
    }
    stretch
}

/// Differences of displacement along the edges of the two triangles of each cell.
#[inline(always)]
fn triangle_edges<S: Instructions>(
    set: S,
    rising: S::Vector,
    [c0, c1, c2, c3]: &Corners<S::Vector>,
) -> [Edges<S::Vector>; 2] {
    let zero = set.splat(0.0);
    let mut edges = [[[zero; 2]; 2]; 2];
    for i in 0..2 {
        let (left, right) = (c3[i] - c0[i], c2[i] - c1[i]);
        edges[0][0][i] = c1[i] - c0[i];
        edges[1][0][i] = c2[i] - c3[i];
        // The first triangle has the right edge where the diagonal rises.
        edges[0][1][i] = rising.if_greater(zero, right, left);
        edges[1][1][i] = rising.if_greater(zero, left, right);
    }
    edges
}

/// Forces on the corners from those on the edges of the two triangles, which pull an edge's end and push its start.
#[inline(always)]
fn corner_forces<S: Instructions>(
    set: S,
    rising: S::Vector,
    [first, second]: &[Edges<S::Vector>; 2],
) -> Corners<S::Vector> {
    let zero = set.splat(0.0);
    let mut force = [[zero; 2]; 4];
    for i in 0..2 {
        let (bottom, top) = (first[0][i], second[0][i]);
        let right = rising.if_greater(zero, first[1][i], second[1][i]);
        let left = rising.if_greater(zero, second[1][i], first[1][i]);
        force[0][i] = zero - (bottom + left);
        force[1][i] = bottom - right;
        force[2][i] = top + right;
        force[3][i] = left - top;
    }
    force
}

/// Pressure of each cell from the volume-weighted mean Jacobian of its two triangles, and which lanes are inverted.
#[inline(always)]
fn patch_pressure<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    kinematics: &[Kinematics<S::Vector>; 2],
    energy: &mut ElementEnergy,
) -> S::Vector {
    let [a, b] = &block.constants.triangle;
    let [j, k] = [kinematics[0].jacobian, kinematics[1].jacobian];
    // What is next to nothing counts as inverted: roots want a normal number.
    let (least, one) = (set.splat(Real::MIN_POSITIVE), set.splat(1.0));
    let inverted = set.load(&energy.inverted, chunk);
    let inverted = j.if_greater(least, k.if_greater(least, inverted, one), one);
    set.store(inverted, &mut energy.inverted, chunk);
    let mean = (set.load(&a.patch_weight, chunk) * (j - one) + set.load(&b.patch_weight, chunk) * (k - one)).plus(1.0);
    let density = block.laws.volumetric.strain_energy_density(set, mean);
    let volume = set.load(&a.reference_volume, chunk) + set.load(&b.reference_volume, chunk);
    set.add(volume * density, &mut energy.elastic, chunk);
    block.laws.volumetric.stress(mean)
}

/// Components 11, 22 and 12 of V/J tau in the section of triangle `t` of each cell, J, with tau = R T R^T; in rings with
/// the J of the section.
#[inline(always)]
fn spatial_stress<S: Instructions>(
    set: S,
    chunk: usize,
    block: &Block,
    t: usize,
    k: &Kinematics<S::Vector>,
    pressure: S::Vector,
    deviator: &Deviator<S::Vector>,
) -> [S::Vector; 3] {
    let volume = set.load(&block.constants.triangle[t].reference_volume, chunk);
    // 1/J is the cube of J^(-1/3).
    let cube = volume * (k.inverse_cbrt_j * k.inverse_cbrt_j * k.inverse_cbrt_j);
    let scale = if block.hoop.is_some() { k.hoop * cube } else { cube };
    let section = scale * (deviator.mean.times(SQRT_THIRD) + pressure * k.jacobian);
    let (difference, shear) = (scale * deviator.difference, scale * deviator.shear);
    let [cos, sin] = k.double_turn;
    let (difference, shear) = (cos * difference - sin * shear, cos * shear + sin * difference);
    [section + difference, section - difference, shear]
}

/// V P dN/dX of a triangle of each cell for its two edges, N, from V/J tau.
///
/// P is tau F^-T, and J F^-T times the gradient of an edge is the other edge as it is now, a quarter turn on, over twice the
/// area at rest: that gradient, and a part from the displacement.
#[inline(always)]
fn edge_forces<S: Instructions>(
    set: S,
    chunk: usize,
    constants: &TriangleConstants,
    edges: &Edges<S::Vector>,
    [t11, t22, t12]: &[S::Vector; 3],
) -> Edges<S::Vector> {
    let [g, h] = &constants.shape_gradient;
    let (g, h) = (set.load_pair(g, chunk), set.load_pair(h, chunk));
    let scale = set.load(&constants.inverse_double_area, chunk);
    let [[ax, ay], [bx, by]] = *edges;
    let (along, across) = ([g[0] + scale * by, g[1] - scale * bx], [h[0] - scale * ay, h[1] + scale * ax]);
    [
        [*t11 * along[0] + *t12 * along[1], *t12 * along[0] + *t22 * along[1]],
        [*t11 * across[0] + *t12 * across[1], *t12 * across[0] + *t22 * across[1]],
    ]
}

/// Adds the radial forces of the nominal hoop stress times the volume to the corners.
#[inline(always)]
fn add_hoop_force<S: Instructions>(
    set: S,
    chunk: usize,
    hoop_stress: S::Vector,
    weight: &[Lane; 4],
    force: &mut Corners<S::Vector>,
) {
    for corner in 0..4 {
        force[corner][0] = force[corner][0] + hoop_stress * set.load(&weight[corner], chunk);
    }
}

/// Constants of one triangle of one cell, before they are put into lanes.
pub(crate) struct Triangle {
    /// dN_a/dX of the four corners, 1/m.
    pub gradient: [[Real; 2]; 4],
    /// V0, m3.
    pub volume: Real,
    /// 1/(3 R) for the triangle's corners, 1/m.
    pub hoop: [Real; 4],
    /// 1/(2 A0), 1/m2.
    pub inverse_double_area: Real,
}

impl Triangle {
    /// The triangle of three of a cell's four `corners`, m.
    pub fn new(scenario: &Scenario, corners: &[[Real; 2]; 4], nodes: [usize; 3]) -> Self {
        // Corners are numbered 0 to 3; the remainder changes nothing and leaves no bound to check.
        let [a, b, c] = nodes.map(|node| corners[node % 4]);
        // The corners run counter-clockwise, so this is positive.
        let double_area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        let radius = (a[0] + b[0] + c[0]) / 3.0;
        let mut triangle = Self {
            gradient: [[0.0; 2]; 4],
            volume: 0.5 * double_area * out_of_plane(scenario, radius),
            hoop: [0.0; 4],
            inverse_double_area: 1.0 / double_area,
        };
        for (node, (p, q)) in nodes.into_iter().zip([(b, c), (c, a), (a, b)]) {
            triangle.gradient[node % 4] = [(p[1] - q[1]) / double_area, (q[0] - p[0]) / double_area];
            triangle.hoop[node % 4] = 1.0 / (3.0 * radius);
        }
        triangle
    }

    /// Writes the triangle into lane `l`.
    pub fn store(&self, l: usize, constants: &mut TriangleConstants, patch_volume: Real) {
        // Moving the end of an edge moves the corners beyond it, too: those on the right, those on top.
        for j in 0..2 {
            constants.shape_gradient[0][j][l] = self.gradient[1][j] + self.gradient[2][j];
            constants.shape_gradient[1][j][l] = self.gradient[2][j] + self.gradient[3][j];
        }
        constants.reference_volume[l] = self.volume;
        constants.inverse_double_area[l] = self.inverse_double_area;
        constants.patch_weight[l] = self.volume / patch_volume;
    }
}
