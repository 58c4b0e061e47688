//! The cells of a solid: six linear tetrahedra each, total Lagrangian, with the pressure of their mean dilatation.
//!
//! Each tetrahedron goes along three edges of its cell ([`crate::mesh::PATHS`]), so that F = 1 + sum D_k (x) G_k with the differences
//! of displacement D_k along them and gradients G_k that do not change. As in the section ([`crate::element::internal_force`]) the
//! tetrahedra of a cell share the pressure U'(J-bar) of their volume-weighted mean Jacobian, stresses live in the unrotated frame,
//! and P = F U^-1 T U^-1 with T = dev + p J 1. An edge is pulled with V P G_k at its end.

use core::hint::black_box;

use crate::element::ElementEnergy;
use crate::element::solid_cell::{INVERSE_VOLUME, SolidBlock, SolidCorners, TETRAHEDRON_PACKS, VOLUME, path_corners};
use crate::element::solid_history::SolidHistory;
use crate::element::solid_response::respond;
use crate::mesh::{PATHS, TETRAHEDRA};
use crate::number::pack::Pack;
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd, Vector};
use crate::tensor::solid_kinematics::{Gradient, Roots, SolidKinematics, determinant};
use crate::tensor::symmetric::Symmetric;

/// Deformation gradients of the tetrahedra of each cell; or what pulls at the ends of their edges, a row for each, N.
pub(crate) type SolidGradients<V> = [Gradient<V>; TETRAHEDRA];

/// Internal forces on the corners of neighbouring cells, N, from their displacements; advances the `history` of their tetrahedra,
/// one behind the other. That of an inverted tetrahedron is not to be used.
///
/// The corners of a path are known where the code is written six times; what the material does is written once.
#[inline(always)]
pub(crate) fn solid_force<S: Simd>(
    simd: S,
    chunk: usize,
    block: &SolidBlock,
    corners: &mut SolidCorners<S::Vector>,
    history: &mut [Pack],
    energy: &mut ElementEnergy,
) {
    let (mut gradients, mut roots) = (unit_gradients(simd), [Roots::none(simd); TETRAHEDRA]);
    fill_gradients(simd, chunk, block, corners, &mut gradients);
    for t in 0..TETRAHEDRA {
        roots[t] = Roots::new(&gradients[t]);
    }
    mark_inverted(simd, chunk, &roots, energy);
    let pressure = pressure(simd, chunk, block, &roots, energy);
    let share = (history.len() / TETRAHEDRA).max(1);
    let tetrahedra = block.constants.as_chunks::<TETRAHEDRON_PACKS>().0;
    let each = tetrahedra.iter().zip(history.chunks_exact_mut(share)).zip(&mut gradients).zip(&roots);
    for (((packs, history), gradient), roots) in each {
        let (packs, history) = (black_box(packs), black_box(history));
        let Some(mut history) = SolidHistory::of(block.laws, history) else { continue };
        let kinematics = SolidKinematics::new(simd, roots);
        let volume = simd.load(&packs[VOLUME], chunk);
        let response = respond(simd, chunk, block.laws, &kinematics, &mut history);
        response.density.add_to(simd, chunk, volume, block.laws, energy);
        let mut mean = pressure * kinematics.jacobian;
        if !block.laws.is_plain() {
            simd.add(volume * response.softening_increment, &mut energy.softening_increment, chunk);
            if block.laws.elastic.is_compressible() {
                mean = response.mean;
            }
        }
        let stress = kinematics.inverse_stretch.around(&response.deviator.with_mean(mean).scaled(volume));
        *gradient = edge_forces(simd, chunk, packs, gradient, &stress);
    }
    add_up(simd, &gradients, corners);
}

/// No deformation.
#[inline(always)]
fn unit_gradients<S: Simd>(simd: S) -> SolidGradients<S::Vector> {
    let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
    [[[one, zero, zero], [zero, one, zero], [zero, zero, one]]; TETRAHEDRA]
}

/// Deformation gradient of tetrahedron `t` of one cell, and its Jacobian, from the displacements of its corners.
pub(crate) fn tetrahedron_gradient(
    block: &SolidBlock,
    l: usize,
    t: usize,
    corners: &SolidCorners<Real>,
) -> (Gradient<Real>, Real) {
    let mut gradients = unit_gradients(Scalar);
    fill_gradients(Scalar, l, block, corners, &mut gradients);
    let gradient = gradients[t % TETRAHEDRA];
    (gradient, determinant(&gradient))
}

/// Adds the differences of displacement along the edges, times their gradients, to the unit tensors.
#[inline(always)]
fn fill_gradients<S: Simd>(
    simd: S,
    chunk: usize,
    block: &SolidBlock,
    displacement: &SolidCorners<S::Vector>,
    gradients: &mut SolidGradients<S::Vector>,
) {
    fill_gradient::<S, 0>(simd, chunk, block, displacement, gradients);
    fill_gradient::<S, 1>(simd, chunk, block, displacement, gradients);
    fill_gradient::<S, 2>(simd, chunk, block, displacement, gradients);
    fill_gradient::<S, 3>(simd, chunk, block, displacement, gradients);
    fill_gradient::<S, 4>(simd, chunk, block, displacement, gradients);
    fill_gradient::<S, 5>(simd, chunk, block, displacement, gradients);
}

#[inline(always)]
fn fill_gradient<S: Simd, const T: usize>(
    simd: S,
    chunk: usize,
    block: &SolidBlock,
    displacement: &SolidCorners<S::Vector>,
    gradients: &mut SolidGradients<S::Vector>,
) {
    let corners = const { path_corners(PATHS[T]) };
    let Some(packs) = block.constants.as_chunks::<TETRAHEDRON_PACKS>().0.get(T) else { return };
    let gradient = &mut gradients[T];
    for edge in 0..3 {
        let (start, end) = (&displacement[corners[edge] % 8], &displacement[corners[edge + 1] % 8]);
        let along = edge_gradient(simd, chunk, packs, edge);
        for i in 0..3 {
            let difference = end[i] - start[i];
            for j in 0..3 {
                gradient[i][j] = gradient[i][j] + difference * along[j];
            }
        }
    }
}

/// G of an edge.
#[inline(always)]
pub(crate) fn edge_gradient<S: Simd>(
    simd: S,
    chunk: usize,
    packs: &[Pack; TETRAHEDRON_PACKS],
    edge: usize,
) -> [S::Vector; 3] {
    let first = (3 * edge) % (TETRAHEDRON_PACKS - 3);
    [simd.load(&packs[first], chunk), simd.load(&packs[first + 1], chunk), simd.load(&packs[first + 2], chunk)]
}

/// Marks the lanes with an inverted tetrahedron.
#[inline(always)]
fn mark_inverted<S: Simd>(simd: S, chunk: usize, roots: &[Roots<S::Vector>; TETRAHEDRA], energy: &mut ElementEnergy) {
    // What is next to nothing counts as inverted: roots want a normal number.
    let (least, one) = (simd.splat(Real::MIN_POSITIVE), simd.splat(1.0));
    let mut inverted = simd.load(&energy.inverted, chunk);
    for roots in roots {
        inverted = roots.jacobian.select_greater(least, inverted, one);
    }
    simd.store(inverted, &mut energy.inverted, chunk);
}

/// Pressure of each cell from its mean Jacobian; none of a compressible law.
#[inline(always)]
fn pressure<S: Simd>(
    simd: S,
    chunk: usize,
    block: &SolidBlock,
    roots: &[Roots<S::Vector>; TETRAHEDRA],
    energy: &mut ElementEnergy,
) -> S::Vector {
    if block.laws.elastic.is_compressible() {
        return simd.splat(0.0);
    }
    let one = simd.splat(1.0);
    let (mut growth, mut volume) = (simd.splat(0.0), simd.splat(0.0));
    for (packs, roots) in block.constants.as_chunks::<TETRAHEDRON_PACKS>().0.iter().zip(roots) {
        let own = simd.load(&packs[VOLUME], chunk);
        growth = growth + own * (roots.jacobian - one);
        volume = volume + own;
    }
    let mean = (growth * simd.load(&block.constants[INVERSE_VOLUME], chunk)).add_scalar(1.0);
    let density = block.laws.volumetric.strain_energy_density(simd, mean);
    simd.add(volume * density, &mut energy.elastic, chunk);
    block.laws.volumetric.stress(mean)
}

/// F S G of the three edges of a tetrahedron, N: what pulls at their ends.
#[inline(always)]
fn edge_forces<S: Simd>(
    simd: S,
    chunk: usize,
    packs: &[Pack; TETRAHEDRON_PACKS],
    f: &Gradient<S::Vector>,
    stress: &Symmetric<S::Vector>,
) -> Gradient<S::Vector> {
    let nominal = [stress.times(f[0]), stress.times(f[1]), stress.times(f[2])];
    let mut pulls = nominal;
    for edge in 0..3 {
        let along = edge_gradient(simd, chunk, packs, edge);
        for i in 0..3 {
            pulls[edge][i] = nominal[i][0] * along[0] + nominal[i][1] * along[1] + nominal[i][2] * along[2];
        }
    }
    pulls
}

/// The forces on the corners from what pulls at the ends of all edges.
#[inline(always)]
fn add_up<S: Simd>(simd: S, pulls: &SolidGradients<S::Vector>, force: &mut SolidCorners<S::Vector>) {
    *force = [[simd.splat(0.0); 3]; 8];
    add_pulls::<S, 0>(pulls, force);
    add_pulls::<S, 1>(pulls, force);
    add_pulls::<S, 2>(pulls, force);
    add_pulls::<S, 3>(pulls, force);
    add_pulls::<S, 4>(pulls, force);
    add_pulls::<S, 5>(pulls, force);
}

#[inline(always)]
fn add_pulls<S: Simd, const T: usize>(pulls: &SolidGradients<S::Vector>, force: &mut SolidCorners<S::Vector>) {
    let corners = const { path_corners(PATHS[T]) };
    for edge in 0..3 {
        let (start, end) = (corners[edge] % 8, corners[edge + 1] % 8);
        for i in 0..3 {
            let pull = pulls[T][edge][i];
            force[end][i] = force[end][i] + pull;
            force[start][i] = force[start][i] - pull;
        }
    }
}
