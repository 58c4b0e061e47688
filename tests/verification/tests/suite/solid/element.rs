//! Tetrahedra: homogeneous deformations, rotations, laws.

use softanvil_kernel::material::{Elastic, Material};
use softanvil_kernel::scenario::Symmetry;
use softanvil_verification::deformation::Samples;
use softanvil_verification::scenes::{elastic, laws};
use softanvil_verification::solid::{CELL, Solid, SolidGradient, cube, nodes};
use softanvil_verification::tolerance::{PATCH, SOLID_CLOSED_FORM};

const DT: f64 = 1e-7;

/// The product a b.
fn product(a: SolidGradient, b: SolidGradient) -> SolidGradient {
    core::array::from_fn(|i| core::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// A rotation by the unit quaternion along (1, a, b, c).
fn rotation([a, b, c]: [f64; 3]) -> SolidGradient {
    let norm = (1.0 + a * a + b * b + c * c).sqrt();
    let [w, x, y, z] = [1.0, a, b, c].map(|number| number / norm);
    [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ]
}

fn random_rotation(samples: &mut Samples) -> SolidGradient {
    rotation(core::array::from_fn(|_| 3.0 * samples.number()))
}

fn transposed(a: SolidGradient) -> SolidGradient {
    core::array::from_fn(|i| core::array::from_fn(|j| a[j][i]))
}

fn diagonal(values: [f64; 3]) -> SolidGradient {
    core::array::from_fn(|i| core::array::from_fn(|j| if i == j { values[i] } else { 0.0 }))
}

/// Nodes that lie elsewhere than on a grid.
fn distorted([u, v, w]: [usize; 3]) -> [f64; 3] {
    let wave = |a: usize, b: usize| 0.15 * ((1.3 * a as f64 + 2.1 * b as f64).sin());
    [u as f64 + wave(v, w), v as f64 + wave(w + 3, u), w as f64 + wave(u + 7, v)].map(|place| CELL * place)
}

/// A homogeneous deformation of distorted cells leaves no force inside, on both sides of the planes of symmetry.
#[test]
fn a_homogeneous_deformation_leaves_no_force_inside() {
    let gradient = [[1.1, 0.2, -0.1], [0.05, 0.9, 0.15], [-0.2, 0.1, 1.05]];
    for symmetry in [Symmetry::Quarter, Symmetry::Half, Symmetry::Full] {
        let mut scenario = cube(3, elastic(0.1e6, 0.05e6, 5e6), DT);
        scenario.geometry.symmetry = symmetry;
        let mut solid = Solid::with_positions(&scenario, &distorted);
        let forces = solid.deform(gradient);
        let (largest, inside) = solid.with(|model, _| {
            let grid = model.constants.grid;
            let ends = [grid.n_u, grid.n_v, grid.n_w];
            let mut largest = [0.0_f64; 2];
            for (node, force) in nodes(model).zip(&forces) {
                let inside = (0..3).all(|i| node[i] > 0 && node[i] < ends[i]);
                let size = force.iter().fold(0.0_f64, |size, force| size.max(force.abs()));
                largest[usize::from(inside)] = largest[usize::from(inside)].max(size);
            }
            (largest[0], largest[1])
        });
        assert!(largest > 0.0 && inside < PATCH * largest, "{symmetry:?}: {inside} N of {largest} N");
    }
}

/// R Q diag(values) Q' for a rotation R and principal directions Q.
fn along(turn: SolidGradient, directions: SolidGradient, values: [f64; 3]) -> SolidGradient {
    product(turn, product(product(directions, diagonal(values)), transposed(directions)))
}

/// Principal nominal stresses tau / l, Pa.
fn nominal(material: &Material, stretches: [f64; 3]) -> [f64; 3] {
    let elastic = Elastic::new(material);
    let jacobian: f64 = stretches.iter().product();
    if elastic.is_compressible() {
        let stress = elastic.principal_stress(stretches);
        return core::array::from_fn(|i| stress[i] / stretches[i]);
    }
    let stress = elastic.principal_stress(stretches.map(|stretch| stretch / jacobian.cbrt()));
    let mean = (stress[0] + stress[1] + stress[2]) / 3.0;
    let pressure = material.bulk_modulus * (jacobian - 1.0) * jacobian;
    core::array::from_fn(|i| (stress[i] - mean + pressure) / stretches[i])
}

/// Source: the closed forms of the laws, which are written apart from their response, and p = K (J - 1).
#[test]
fn stresses_are_those_of_the_closed_forms() {
    let mut samples = Samples::new(77);
    let none = diagonal([1.0; 3]);
    for (label, material) in laws(2e6) {
        for stretches in [[1.0; 3], [0.7, 1.2, 1.1], [0.6, 1.3, 1.3], [1.4, 0.8, 0.9], [1.0005, 1.0, 0.9993]] {
            for (turn, directions) in [(none, none), (random_rotation(&mut samples), random_rotation(&mut samples))] {
                let mut solid = Solid::new(&cube(1, material, DT));
                let found = solid.first_piola(along(turn, directions, stretches));
                let expected = along(turn, directions, nominal(&material, stretches));
                for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
                    let error = (found - expected).abs() / material.shear_modulus_inf();
                    assert!(error < SOLID_CLOSED_FORM, "{label} at {stretches:?}: {found} Pa, not {expected} Pa");
                }
            }
        }
    }
}

/// A material with all mechanisms.
fn everything() -> Material {
    let mut material = elastic(0.1e6, 0.05e6, 2e6);
    (material.prony_g[0], material.prony_tau[0]) = (0.5, 1e-3);
    (material.maxwell_g[0], material.maxwell_beta[0]) = (5e4, 1e3);
    (material.slider_stiffness, material.slider_yield_stress) = (2e5, 1e4);
    (material.softening_r, material.softening_m) = (1.5, 1e4);
    (material.tear_stretch, material.tear_width) = (1.2, 0.5);
    material
}

/// A body that turns while it deforms bears the turned forces of one that does not, with all of its memory.
#[test]
fn a_rotation_only_turns_the_forces() {
    let mut samples = Samples::new(5);
    let turns: Vec<SolidGradient> = (0..6).map(|_| random_rotation(&mut samples)).collect();
    let way: Vec<SolidGradient> = (1..=6)
        .map(|i| {
            let a = 0.07 * i as f64;
            [[1.0 + a, 0.5 * a, 0.0], [0.0, 1.0 - 0.6 * a, a], [-0.3 * a, 0.0, 1.0 + 0.2 * a]]
        })
        .collect();
    let scenario = cube(2, everything(), DT);
    let (mut still, mut turning) = (Solid::new(&scenario), Solid::new(&scenario));
    for (gradient, turn) in way.into_iter().zip(turns) {
        let (forces, turned) = (still.deform(gradient), turning.deform(product(turn, gradient)));
        let largest = forces.iter().flatten().fold(0.0_f64, |largest, force| largest.max(force.abs()));
        for (force, turned) in forces.iter().zip(&turned) {
            for i in 0..3 {
                let expected: f64 = (0..3).map(|j| turn[i][j] * force[j]).sum();
                assert!((turned[i] - expected).abs() < 1e-11 * largest, "{} N, not {expected} N", turned[i]);
            }
        }
    }
}

/// Plane strain of a solid is that of a section: the same stress in it, from the same history.
#[test]
fn in_plane_strain_a_solid_bears_the_stress_of_a_section() {
    use softanvil_kernel::scenario::Formulation;
    use softanvil_verification::element::Cell;
    let mut section = Cell::new(everything(), Formulation::PlaneStrain, DT);
    let mut solid = Solid::new(&cube(1, everything(), DT));
    for i in 1..=8 {
        let a = 0.05 * (i as f64) * if i > 5 { 0.3 } else { 1.0 };
        let flat = [[1.0 + a, 0.4 * a], [-0.2 * a, 1.0 - 0.8 * a]];
        let expected = section.deform(flat);
        let found = solid.first_piola([[flat[0][0], flat[0][1], 0.0], [flat[1][0], flat[1][1], 0.0], [0.0, 0.0, 1.0]]);
        for j in 0..2 {
            for k in 0..2 {
                let error = (found[j][k] - expected[j][k]).abs();
                assert!(error < 1e-10 * 3e5, "step {i}: {} Pa, not {} Pa", found[j][k], expected[j][k]);
            }
        }
    }
}
