//! The volumetric laws: pressure of a dilatation, and gradient of the energy.

use softanvil_kernel::material::{Material, Volumetric, VolumetricLaw};
use softanvil_kernel::number::vector::Scalar;
use softanvil_kernel::scenario::Formulation;

use crate::element::Cell;
use crate::row::Check;
use crate::scenes::elastic;

/// Bulk modulus, Pa.
pub const BULK: f64 = 1e6;

/// The law of Simo with Mooney-Rivlin.
fn simo() -> Material {
    Material { volumetric_law: VolumetricLaw::Simo, ..elastic(0.1e6, 0.05e6, BULK) }
}

/// Largest error of the stress of pure dilatations, P = p l^2, relative to it or a thousandth of the bulk modulus: the
/// round-off of J is that of l^3, which the stress near rest is a difference from 1 of.
pub fn dilatation_error() -> f64 {
    let error = |l: f64| {
        let j = l.powi(3);
        let p = Cell::new(simo(), Formulation::Axisymmetric, 1e-6).deform([[l, 0.0], [0.0, l]])[1][1];
        (p - 0.5 * BULK * (j - 1.0 / j) * l * l).abs() / p.abs().max(1e-3 * BULK)
    };
    [0.1_f64, 0.3, 0.9, 0.999_999, 1.000_001, 1.1, 2.0].into_iter().map(error).fold(0.0, f64::max)
}

/// Error of the stress of a law at `j` against central differences of its energy, relative to it plus the bulk modulus.
pub fn gradient_error(law: VolumetricLaw, j: f64) -> f64 {
    let volumetric = Volumetric { law, bulk_modulus: BULK };
    let step = 1e-5 * j;
    let energy = |j: f64| volumetric.strain_energy_density(Scalar, j);
    let difference = (energy(j + step) - energy(j - step)) / (2.0 * step);
    let stress = volumetric.stress(j);
    (stress - difference).abs() / (stress.abs() + BULK)
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    vec![Check {
        problem: "volumetric",
        quantity: "Simo: stress of dilatations by 0.1 to 2".into(),
        reference: "K (J - 1 / J) / 2",
        error: dilatation_error(),
    }]
}
