//! Pressure checkerboards and hourglass modes.

use nalgebra::SymmetricEigen;
use softanvil_kernel::scenario::Formulation;

use crate::body::{Body, Pressure};
use crate::memo::Memo;
use crate::order::over_cells;
use crate::problems::bonded_strip::{Compression, SHEAR_MODULUS, compression};
use crate::row::Row;
use crate::scenes::{grid, neo_hookean};
use crate::statics::dense_stiffness;

/// Poisson's ratios of the strip.
pub const POISSONS_RATIOS: [f64; 3] = [0.48, 0.499, 0.4999];

/// Cells through the thickness.
pub const CELLS: [usize; 4] = [8, 16, 32, 64];

const SHAPE_FACTOR: f64 = 2.0;

fn bulk_modulus(nu: f64) -> f64 {
    2.0 * SHEAR_MODULUS * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu))
}

/// Alternating part of the pressure in a strip compressed between bonded faces, `n` cells thick: root mean square of the
/// mode (+ - - +)/4 of every two by two cells over that of the pressure.
///
/// The half thickness next to the free side is left out, because the pressure of the solution is singular in the corners
/// of the bonds. In a smooth pressure the mode falls with the square of the element size; a checkerboard would stay.
pub fn alternating_part(nu: f64, n: usize) -> f64 {
    static KNOWN: Memo<(u64, usize), f64> = Memo::new();
    KNOWN.get((nu.to_bits(), n), || computed_part(nu, n))
}

fn computed_part(nu: f64, n: usize) -> f64 {
    let Compression { body, equilibrium } = compression(Formulation::PlaneStrain, SHAPE_FACTOR, bulk_modulus(nu), n);
    let pressure = body.cell_pressures(&equilibrium.displacement);
    let [n_u, n_v] = body.cells();
    let at = |u: usize, v: usize| pressure[v * n_u + u];
    let mut alternating = 0.0;
    for v in 0..n_v - 1 {
        for u in 0..n_u - n / 2 - 1 {
            alternating += (0.25 * (at(u, v) - at(u + 1, v) - at(u, v + 1) + at(u + 1, v + 1))).powi(2);
        }
    }
    let total: f64 = pressure.iter().map(|p| p * p).sum();
    (alternating / total).sqrt()
}

/// Eigenvalues of the stiffness of a free body of `n` by `n` cells, over the largest, in rising order.
///
/// The body is far from the axis, where only the vertical translation is rigid when axisymmetric.
pub fn eigenvalues(formulation: Formulation, n: usize) -> Vec<f64> {
    let mut scenario = grid(n, n, neo_hookean(SHEAR_MODULUS, bulk_modulus(0.49)));
    scenario.geometry.formulation = formulation;
    let position = |u: usize, v: usize| [10e-3 + 1e-3 * u as f64, 1e-3 * v as f64];
    let mut body = Body::new(&scenario, &position, Pressure::Patch);
    let mut values: Vec<f64> = SymmetricEigen::new(dense_stiffness(&mut body)).eigenvalues.iter().copied().collect();
    values.sort_by(f64::total_cmp);
    let largest = values[values.len() - 1];
    values.iter().map(|value| value / largest).collect()
}

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let row = |nu: f64| {
        let errors: Vec<f64> = CELLS.iter().map(|n| alternating_part(nu, *n)).collect();
        Row {
            problem: "checkerboard",
            quantity: format!("alternating part of the pressure, bonded strip, nu = {nu}"),
            reference: "none in the limit".into(),
            meshes: CELLS.iter().map(|n| format!("{n} cells")).collect(),
            order: Some(over_cells(&CELLS, &errors)),
            errors,
        }
    };
    POISSONS_RATIOS.map(row).into()
}
