//! A short bonded anvil with free ends under a face that covers it, without friction, quasi-static, as a solid.
//!
//! Reference: felupe 11.3 with trilinear hexahedra of mean dilatation, `tests/verification/reference/solid_press.py`.

use softanvil_kernel::scenario::Formulation;

use crate::memo::Memo;
use crate::problems::reduction;
use crate::row::Row;

/// Depths, m.
const DEPTHS: [f64; 3] = [1e-3, 2e-3, 3e-3];
/// Bulk modulus, Pa: a Poisson's ratio of 0.48.
const BULK_MODULUS: f64 = 7.4e6;
/// Sides of the elements, m.
pub const SIZES: [f64; 2] = [3.75e-3, 2.5e-3];

/// Forces of the reference with its nodes at the same places, N.
pub const SAME_MESH: [[f64; 3]; 2] = [[57.39, 168.09, 326.64], [57.92, 169.97, 328.78]];

/// Forces on the anvil in elements of `SIZES[mesh]`, N.
pub fn forces(mesh: usize) -> Vec<f64> {
    static KNOWN: Memo<usize, Vec<f64>> = Memo::new();
    KNOWN.get(mesh, || {
        let mut scenario = reduction::scenario(Formulation::Solid, BULK_MODULUS, SIZES[mesh]);
        (scenario.geometry.length, scenario.impactor.face_diameter) = (45e-3, 0.5);
        reduction::pressed(&scenario, &DEPTHS)
    })
}

/// Largest error of the forces over those of `reference`, with its sign.
pub fn error(mesh: usize, reference: [f64; 3]) -> f64 {
    let errors = forces(mesh).into_iter().zip(reference).map(|(force, reference)| force / reference - 1.0);
    errors.fold(0.0, |largest: f64, error| if error.abs() > largest.abs() { error } else { largest })
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    vec![Row {
        problem: "solid_press",
        quantity: "force to 1, 2 and 3 mm, free ends, nu = 0.48: the largest error".into(),
        reference: "felupe, same nodes, hexahedra".into(),
        meshes: SIZES.map(|size| format!("{} mm", 1e3 * size)).into(),
        errors: (0..SIZES.len()).map(|mesh| error(mesh, SAME_MESH[mesh])).collect(),
        order: None,
    }]
}
