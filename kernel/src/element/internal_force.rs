//! The cells of the section: two linear triangles each, total Lagrangian, with the pressure of their mean dilatation.
//!
//! For each triangle F = I + sum (u_a - u_0) (x) dN_a/dX, and the polar decomposition F = R U of the section is closed:
//! R is the rotation by the angle of (F11 + F22, F21 - F12). All deviatoric stresses live in the unrotated frame. The
//! two triangles of a cell share p = U'(J-bar) with J-bar their volume-weighted mean Jacobian (a mean-dilatation patch,
//! Nagtegaal, Parks and Rice 1974), which removes volumetric locking and derives from an energy. The first
//! Piola-Kirchhoff stress is P = R T R^T F^-T with T = dev + p J I, and the nodal force V P dN/dX. A compressible law gives
//! each triangle a mean stress of its own in the place of p J.

use crate::element::response::{EnergyDensity, deviatoric_stress};
use crate::element::whole_response::whole_stress;
use crate::element::{Block, CellHistory, Corners, Edges, ElementEnergy, HoopConstants, TriangleConstants};
use crate::number::pack::Pack;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::deviator::{Deviator, SQRT_THIRD};
use crate::tensor::kinematics::Kinematics;

/// Internal forces on the corners of neighbouring cells, N, from their displacements; advances the history of their
/// triangles.
///
/// `viscous` holds the overstress of the first triangle's terms, then of the second's, and behind them what both remember of
/// softening and of a compressible law. The history of an inverted triangle ([`ElementEnergy::inverted`]) is not to be used.
#[inline(always)]
pub fn internal_force<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    displacement: &Corners<S::Vector>,
    history: &mut CellHistory,
    viscous: &mut [Deviator],
    energy: &mut ElementEnergy,
) -> Corners<S::Vector> {
    if block.laws.is_plain() {
        plain_force(simd, chunk, block, displacement, history, viscous, energy)
    } else if block.laws.elastic.is_compressible() {
        whole_force::<S, true>(simd, chunk, block, displacement, history, viscous, energy)
    } else {
        whole_force::<S, false>(simd, chunk, block, displacement, history, viscous, energy)
    }
}

/// [`internal_force`] of an isochoric law that does not soften; apart, so that it carries nothing of the others.
#[inline(always)]
pub(crate) fn plain_force<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    displacement: &Corners<S::Vector>,
    history: &mut CellHistory,
    viscous: &mut [Deviator],
    energy: &mut ElementEnergy,
) -> Corners<S::Vector> {
    let edges = triangle_edges(simd, simd.load(&block.constants.diagonal, chunk), displacement);
    let kinematics = kinematics(simd, chunk, block, displacement, &edges);
    mark_inverted(simd, chunk, &kinematics, energy);
    let pressure = mean_stress(simd, chunk, block, &kinematics, energy);
    let [(a, first), (b, second)] = deviatoric_stress(simd, chunk, block, &kinematics, history, viscous);
    add_energies(simd, chunk, block, [first, second], energy);
    let means = [pressure * kinematics[0].jacobian, pressure * kinematics[1].jacobian];
    let inverse = inverse_jacobians(&kinematics);
    nodal_forces(simd, chunk, block, &edges, &kinematics, inverse, [(a, means[0]), (b, means[1])])
}

/// 1/J as the cube of J^(-1/3), which isochoric laws need as well.
#[inline(always)]
fn inverse_jacobians<V: Vector>([k, l]: &[Kinematics<V>; 2]) -> [V; 2] {
    let [k, l] = [k.inverse_cbrt_j, l.inverse_cbrt_j];
    [k * k * k, l * l * l]
}

/// [`internal_force`] of a law that is `COMPRESSIBLE`, or softens; a copy for each, so that one carries nothing of the other.
#[inline(always)]
pub(crate) fn whole_force<S: Simd, const COMPRESSIBLE: bool>(
    simd: S,
    chunk: usize,
    block: &Block,
    displacement: &Corners<S::Vector>,
    history: &mut CellHistory,
    viscous: &mut [Deviator],
    energy: &mut ElementEnergy,
) -> Corners<S::Vector> {
    let edges = triangle_edges(simd, simd.load(&block.constants.diagonal, chunk), displacement);
    let kinematics = kinematics(simd, chunk, block, displacement, &edges);
    mark_inverted(simd, chunk, &kinematics, energy);
    let [first, second] = whole_stress::<S, COMPRESSIBLE>(simd, chunk, block, &kinematics, history, viscous);
    let (one, mut means, inverse) = (simd.splat(1.0), [first.mean, second.mean], inverse_jacobians(&kinematics));
    if !COMPRESSIBLE {
        let pressure = mean_stress(simd, chunk, block, &kinematics, energy);
        means = [pressure * kinematics[0].jacobian, pressure * kinematics[1].jacobian];
    }
    if block.laws.softening.active() {
        for (triangle, lost) in
            block.constants.triangle.iter().zip([first.softening_increment, second.softening_increment])
        {
            let volume = simd.load(&triangle.reference_volume, chunk);
            simd.add(volume * lost, &mut energy.softening_increment, chunk);
        }
    }
    add_energies(simd, chunk, block, [first.density, second.density], energy);
    let inverse = if COMPRESSIBLE { [one / kinematics[0].jacobian, one / kinematics[1].jacobian] } else { inverse };
    let stresses = [(first.deviator, means[0]), (second.deviator, means[1])];
    nodal_forces(simd, chunk, block, &edges, &kinematics, inverse, stresses)
}

/// Adds the energies of both triangles of each cell.
#[inline(always)]
fn add_energies<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    densities: [EnergyDensity<S::Vector>; 2],
    energy: &mut ElementEnergy,
) {
    for (triangle, density) in block.constants.triangle.iter().zip(densities) {
        let volume = simd.load(&triangle.reference_volume, chunk);
        density.add_to(simd, chunk, volume, block.laws, energy);
    }
}

/// Forces on the corners, N, from deviator and mean of the Kirchhoff stress of both triangles of each cell, Pa.
#[inline(always)]
fn nodal_forces<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    edges: &[Edges<S::Vector>; 2],
    kinematics: &[Kinematics<S::Vector>; 2],
    inverse_jacobian: [S::Vector; 2],
    stresses: [(Deviator<S::Vector>, S::Vector); 2],
) -> Corners<S::Vector> {
    let [k, l] = kinematics;
    let [a, b] = &block.constants.triangle;
    let scale = [
        simd.load(&a.reference_volume, chunk) * inverse_jacobian[0],
        simd.load(&b.reference_volume, chunk) * inverse_jacobian[1],
    ];
    let stress = [spatial_stress(block, scale[0], k, &stresses[0]), spatial_stress(block, scale[1], l, &stresses[1])];
    let [of_first, of_second] = &block.constants.triangle;
    let edges = [
        edge_forces(simd, chunk, of_first, &edges[0], &stress[0]),
        edge_forces(simd, chunk, of_second, &edges[1], &stress[1]),
    ];
    let mut force = corner_forces(simd, simd.load(&block.constants.diagonal, chunk), &edges);
    if let Some(hoop) = block.hoop {
        for (t, (deviator, mean)) in stresses.iter().enumerate() {
            let volume = simd.load(&block.constants.triangle[t].reference_volume, chunk);
            let kirchhoff = *mean - deviator.mean.mul_scalar(2.0 * SQRT_THIRD);
            let nominal = volume * kirchhoff / kinematics[t].hoop;
            add_hoop_force(simd, chunk, nominal, &hoop.weight[t], &mut force);
        }
    }
    force
}

/// Deformation of the two triangles of each cell.
#[inline(always)]
pub(crate) fn cell_kinematics<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    displacement: &Corners<S::Vector>,
) -> [Kinematics<S::Vector>; 2] {
    let edges = triangle_edges(simd, simd.load(&block.constants.diagonal, chunk), displacement);
    kinematics(simd, chunk, block, displacement, &edges)
}

/// [`cell_kinematics`] with the differences of displacement along the edges.
#[inline(always)]
fn kinematics<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    displacement: &Corners<S::Vector>,
    edges: &[Edges<S::Vector>; 2],
) -> [Kinematics<S::Vector>; 2] {
    let hoop = match block.hoop {
        Some(HoopConstants { weight: [a, b] }) => {
            [Some(hoop_stretch(simd, chunk, a, displacement)), Some(hoop_stretch(simd, chunk, b, displacement))]
        }
        None => [None; 2],
    };
    let [a, b] = &block.constants.triangle;
    [
        Kinematics::new(simd, gradients(simd, chunk, a), edges[0], hoop[0]),
        Kinematics::new(simd, gradients(simd, chunk, b), edges[1], hoop[1]),
    ]
}

/// dN/dX of the two edges of a triangle of each cell.
#[inline(always)]
fn gradients<S: Simd>(simd: S, chunk: usize, constants: &TriangleConstants) -> [[S::Vector; 2]; 2] {
    let [g, h] = &constants.shape_gradient;
    [simd.load_pair(g, chunk), simd.load_pair(h, chunk)]
}

/// Hoop stretch of a triangle, from the radial displacements of its corners.
#[inline(always)]
fn hoop_stretch<S: Simd>(simd: S, chunk: usize, weight: &[Pack; 4], corners: &Corners<S::Vector>) -> S::Vector {
    let mut stretch = simd.splat(1.0);
    for a in 0..4 {
        stretch = stretch + simd.load(&weight[a], chunk) * corners[a][0];
    }
    stretch
}

/// Differences of displacement along the edges of the two triangles of each cell.
#[inline(always)]
fn triangle_edges<S: Simd>(
    simd: S,
    diagonal: S::Vector,
    [c0, c1, c2, c3]: &Corners<S::Vector>,
) -> [Edges<S::Vector>; 2] {
    let zero = simd.splat(0.0);
    let mut edges = [[[zero; 2]; 2]; 2];
    for i in 0..2 {
        let (left, right) = (c3[i] - c0[i], c2[i] - c1[i]);
        edges[0][0][i] = c1[i] - c0[i];
        edges[1][0][i] = c2[i] - c3[i];
        // The first triangle has the right edge where the diagonal rises.
        edges[0][1][i] = diagonal.select_greater(zero, right, left);
        edges[1][1][i] = diagonal.select_greater(zero, left, right);
    }
    edges
}

/// Forces on the corners from those on the edges of the two triangles, which pull an edge's end and push its start.
#[inline(always)]
fn corner_forces<S: Simd>(simd: S, diagonal: S::Vector, [first, second]: &[Edges<S::Vector>; 2]) -> Corners<S::Vector> {
    let zero = simd.splat(0.0);
    let mut force = [[zero; 2]; 4];
    for i in 0..2 {
        let (bottom, top) = (first[0][i], second[0][i]);
        let right = diagonal.select_greater(zero, first[1][i], second[1][i]);
        let left = diagonal.select_greater(zero, second[1][i], first[1][i]);
        force[0][i] = zero - (bottom + left);
        force[1][i] = bottom - right;
        force[2][i] = top + right;
        force[3][i] = left - top;
    }
    force
}

/// Marks the lanes with an inverted triangle.
#[inline(always)]
fn mark_inverted<S: Simd>(simd: S, chunk: usize, [k, l]: &[Kinematics<S::Vector>; 2], energy: &mut ElementEnergy) {
    let (j, k) = (k.jacobian, l.jacobian);
    // What is next to nothing counts as inverted: roots want a normal number.
    let (least, one) = (simd.splat(Real::MIN_POSITIVE), simd.splat(1.0));
    let inverted = simd.load(&energy.inverted, chunk);
    let inverted = j.select_greater(least, k.select_greater(least, inverted, one), one);
    simd.store(inverted, &mut energy.inverted, chunk);
}

/// Pressure of each cell from the volume-weighted mean Jacobian of its two triangles.
#[inline(always)]
fn mean_stress<S: Simd>(
    simd: S,
    chunk: usize,
    block: &Block,
    kinematics: &[Kinematics<S::Vector>; 2],
    energy: &mut ElementEnergy,
) -> S::Vector {
    let [a, b] = &block.constants.triangle;
    let ([j, k], one) = ([kinematics[0].jacobian, kinematics[1].jacobian], simd.splat(1.0));
    let mean = (simd.load(&a.volume_fraction, chunk) * (j - one) + simd.load(&b.volume_fraction, chunk) * (k - one))
        .add_scalar(1.0);
    let density = block.laws.volumetric.strain_energy_density(simd, mean);
    let volume = simd.load(&a.reference_volume, chunk) + simd.load(&b.reference_volume, chunk);
    simd.add(volume * density, &mut energy.elastic, chunk);
    block.laws.volumetric.stress(mean)
}

/// Components 11, 22 and 12 of V/J tau in the section of a triangle of each cell, J, from V/J, with tau = R T R^T; in rings with
/// the J of the section.
#[inline(always)]
fn spatial_stress<V: Vector>(
    block: &Block,
    scale: V,
    k: &Kinematics<V>,
    (deviator, mean): &(Deviator<V>, V),
) -> [V; 3] {
    let scale = if block.hoop.is_some() { k.hoop * scale } else { scale };
    let section = scale * (deviator.mean.mul_scalar(SQRT_THIRD) + *mean);
    let (difference, shear) = (scale * deviator.difference, scale * deviator.shear);
    let [cos, sin] = k.rotation_2theta;
    let (difference, shear) = (cos * difference - sin * shear, cos * shear + sin * difference);
    [section + difference, section - difference, shear]
}

/// V P dN/dX of a triangle of each cell for its two edges, N, from V/J tau.
///
/// P is tau F^-T, and J F^-T times the gradient of an edge is the other edge as it is now, a quarter turn on, over twice the
/// area at rest: that gradient, and a part from the displacement.
#[inline(always)]
fn edge_forces<S: Simd>(
    simd: S,
    chunk: usize,
    constants: &TriangleConstants,
    edges: &Edges<S::Vector>,
    [t11, t22, t12]: &[S::Vector; 3],
) -> Edges<S::Vector> {
    let [g, h] = gradients(simd, chunk, constants);
    let scale = simd.load(&constants.inverse_double_area, chunk);
    let [[ax, ay], [bx, by]] = *edges;
    let (along, across) = ([g[0] + scale * by, g[1] - scale * bx], [h[0] - scale * ay, h[1] + scale * ax]);
    [
        [*t11 * along[0] + *t12 * along[1], *t12 * along[0] + *t22 * along[1]],
        [*t11 * across[0] + *t12 * across[1], *t12 * across[0] + *t22 * across[1]],
    ]
}

/// Adds the radial forces of the nominal hoop stress times the volume to the corners.
#[inline(always)]
fn add_hoop_force<S: Simd>(
    simd: S,
    chunk: usize,
    hoop_stress: S::Vector,
    weight: &[Pack; 4],
    force: &mut Corners<S::Vector>,
) {
    for corner in 0..4 {
        force[corner][0] = force[corner][0] + hoop_stress * simd.load(&weight[corner], chunk);
    }
}
