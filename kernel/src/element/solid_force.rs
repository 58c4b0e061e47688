//! The cells of a solid: six linear tetrahedra each, total Lagrangian, with the pressure of their mean dilatation.
//!
//! Each tetrahedron goes along three edges of its cell ([`crate::mesh::PATHS`]), so that F = 1 + sum D_k (x) G_k with the differences
//! of displacement D_k along them and gradients G_k that do not change. As in the section ([`crate::element::internal_force`]) the
//! tetrahedra of a cell share the pressure U'(J-bar) of their volume-weighted mean Jacobian, stresses live in the unrotated frame,
//! and P = F U^-1 T U^-1 with T = dev + p J 1. An edge is pulled with V P G_k at its end.

use crate::element::ElementEnergy;
use crate::element::solid_cell::{INVERSE_VOLUME, SolidBlock, SolidCorners, TETRAHEDRON_PACKS, VOLUME, path_corners};
use crate::element::solid_history::SolidHistory;
use crate::element::solid_response::respond;
use crate::mesh::{PATHS, TETRAHEDRA};
use crate::number::pack::Pack;
use crate::number::real::Real;
use crate::number::vector::{Simd, Vector};
use crate::tensor::solid_kinematics::{Gradient, SolidKinematics, determinant};
use crate::tensor::symmetric::Symmetric;

/// Deformation gradients and Jacobians of the tetrahedra of each cell.
pub(crate) struct SolidGradients<V> {
    pub gradient: [Gradient<V>; TETRAHEDRA],
    pub jacobian: [V; TETRAHEDRA],
}

/// Internal forces on the corners of neighbouring cells, N, from their displacements; advances the `history` of their tetrahedra,
/// one behind the other. That of an inverted tetrahedron is not to be used.
#[inline(always)]
pub(crate) fn solid_force<S: Simd>(
    simd: S,
    chunk: usize,
    block: &SolidBlock,
    displacement: &SolidCorners<S::Vector>,
    history: &mut [Pack],
    energy: &mut ElementEnergy,
) -> SolidCorners<S::Vector> {
    let SolidGradients { gradient, jacobian } = gradients(simd, chunk, block, displacement);
    mark_inverted(simd, chunk, &jacobian, energy);
    let pressure = pressure(simd, chunk, block, &jacobian, energy);
    let mut force = [[simd.splat(0.0); 3]; 8];
    let share = (history.len() / TETRAHEDRA).max(1);
    let tetrahedra = block.constants.as_chunks::<TETRAHEDRON_PACKS>().0;
    for (t, ((packs, path), history)) in tetrahedra.iter().zip(PATHS).zip(history.chunks_exact_mut(share)).enumerate() {
        let Some(mut history) = SolidHistory::of(block.laws, history) else { continue };
        let f = &gradient[t % TETRAHEDRA];
        let kinematics = SolidKinematics::new(simd, f, jacobian[t % TETRAHEDRA]);
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
        let stress = response.deviator.with_mean(mean).scaled(volume);
        let nominal = second_piola(&kinematics, &stress);
        add_edge_forces(simd, chunk, packs, path, f, &nominal, &mut force);
    }
    force
}

/// Deformation of the tetrahedra of each cell.
#[inline(always)]
pub(crate) fn gradients<S: Simd>(
    simd: S,
    chunk: usize,
    block: &SolidBlock,
    displacement: &SolidCorners<S::Vector>,
) -> SolidGradients<S::Vector> {
    let (zero, one) = (simd.splat(0.0), simd.splat(1.0));
    let unit = [[one, zero, zero], [zero, one, zero], [zero, zero, one]];
    let mut found = SolidGradients { gradient: [unit; TETRAHEDRA], jacobian: [one; TETRAHEDRA] };
    let tetrahedra = block.constants.as_chunks::<TETRAHEDRON_PACKS>().0;
    for (t, (packs, path)) in tetrahedra.iter().zip(PATHS).enumerate() {
        let gradient = &mut found.gradient[t % TETRAHEDRA];
        let corners = path_corners(path);
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
        found.jacobian[t % TETRAHEDRA] = determinant(gradient);
    }
    found
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
fn mark_inverted<S: Simd>(simd: S, chunk: usize, jacobian: &[S::Vector; TETRAHEDRA], energy: &mut ElementEnergy) {
    // What is next to nothing counts as inverted: roots want a normal number.
    let (least, one) = (simd.splat(Real::MIN_POSITIVE), simd.splat(1.0));
    let mut inverted = simd.load(&energy.inverted, chunk);
    for jacobian in jacobian {
        inverted = jacobian.select_greater(least, inverted, one);
    }
    simd.store(inverted, &mut energy.inverted, chunk);
}

/// Pressure of each cell from its mean Jacobian; none of a compressible law.
#[inline(always)]
fn pressure<S: Simd>(
    simd: S,
    chunk: usize,
    block: &SolidBlock,
    jacobian: &[S::Vector; TETRAHEDRA],
    energy: &mut ElementEnergy,
) -> S::Vector {
    if block.laws.elastic.is_compressible() {
        return simd.splat(0.0);
    }
    let one = simd.splat(1.0);
    let (mut growth, mut volume) = (simd.splat(0.0), simd.splat(0.0));
    for (packs, jacobian) in block.constants.as_chunks::<TETRAHEDRON_PACKS>().0.iter().zip(jacobian) {
        let own = simd.load(&packs[VOLUME], chunk);
        growth = growth + own * (*jacobian - one);
        volume = volume + own;
    }
    let mean = (growth * simd.load(&block.constants[INVERSE_VOLUME], chunk)).add_scalar(1.0);
    let density = block.laws.volumetric.strain_energy_density(simd, mean);
    simd.add(volume * density, &mut energy.elastic, chunk);
    block.laws.volumetric.stress(mean)
}

/// U^-1 T U^-1.
#[inline(always)]
fn second_piola<V: Vector>(kinematics: &SolidKinematics<V>, stress: &Symmetric<V>) -> Symmetric<V> {
    kinematics.inverse_stretch.around(stress)
}

/// Adds F S G_k for the three edges of a tetrahedron to the forces on their ends.
#[inline(always)]
fn add_edge_forces<S: Simd>(
    simd: S,
    chunk: usize,
    packs: &[Pack; TETRAHEDRON_PACKS],
    path: [usize; 3],
    f: &Gradient<S::Vector>,
    stress: &Symmetric<S::Vector>,
    force: &mut SolidCorners<S::Vector>,
) {
    let nominal = [stress.times(f[0]), stress.times(f[1]), stress.times(f[2])];
    let corners = path_corners(path);
    for edge in 0..3 {
        let along = edge_gradient(simd, chunk, packs, edge);
        for i in 0..3 {
            let pull = nominal[i][0] * along[0] + nominal[i][1] * along[1] + nominal[i][2] * along[2];
            let (start, end) = (corners[edge] % 8, corners[edge + 1] % 8);
            force[end][i] = force[end][i] + pull;
            force[start][i] = force[start][i] - pull;
        }
    }
}
