//! Nominal stress of every law under uniaxial, planar and equibiaxial stretch, through the element.

use softanvil_kernel::material::{Elastic, Material};
use softanvil_kernel::scenario::Formulation;

use crate::element::Cell;
use crate::row::Check;
use crate::scenes::laws;

/// Stretches of the loaded direction.
pub const STRETCHES: [f64; 9] = [0.3, 0.4, 0.6, 0.8, 0.95, 1.05, 1.5, 2.0, 3.0];

/// Bulk modulus, Pa; the deformations are isochoric, so it does not matter.
pub const BULK: f64 = 1e9;

/// A homogeneous deformation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// One direction loaded.
    Uniaxial,
    /// One loaded, one free, one held: the free direction is across, the held one out of the section.
    Planar,
    /// Two loaded.
    Equibiaxial,
}

impl Mode {
    /// Every mode.
    pub const ALL: [Self; 3] = [Self::Uniaxial, Self::Planar, Self::Equibiaxial];
}

/// The stress difference sigma_loaded - sigma_free of `material` at stretch `l` by the element, and by the closed form, Pa.
pub fn difference(mode: Mode, material: &Material, l: f64) -> [f64; 2] {
    let cell = |formulation| Cell::new(*material, formulation, 1e-6);
    let reference = |stretches: [f64; 3]| {
        let stress = Elastic::new(material).principal_stress(stretches);
        stress[0] - stress[1]
    };
    match mode {
        Mode::Uniaxial => {
            let side = l.powf(-0.5);
            let p = cell(Formulation::Axisymmetric).deform([[side, 0.0], [0.0, l]]);
            [l * p[1][1] - side * 0.5 * p[0][0], reference([l, side, side])]
        }
        Mode::Planar => {
            let p = cell(Formulation::PlaneStrain).deform([[1.0 / l, 0.0], [0.0, l]]);
            [l * p[1][1] - p[0][0] / l, reference([l, 1.0 / l, 1.0])]
        }
        Mode::Equibiaxial => {
            let through = l.powi(-2);
            let p = cell(Formulation::Axisymmetric).deform([[l, 0.0], [0.0, through]]);
            [l * 0.5 * p[0][0] - through * p[1][1], reference([l, through, l])]
        }
    }
}

/// Lines of the table: the largest error over the stretches.
pub fn checks() -> Vec<Check> {
    let mut checks = Vec::new();
    for (name, material) in laws(BULK) {
        let errors = Mode::ALL.into_iter().flat_map(|mode| {
            STRETCHES.map(|l| {
                let [measured, reference] = difference(mode, &material, l);
                (measured / reference - 1.0).abs()
            })
        });
        checks.push(Check {
            problem: "closed_forms",
            quantity: format!("{name}: uniaxial, planar, equibiaxial stress at stretches 0.3 to 3"),
            reference: "incompressible closed forms",
            error: errors.fold(0.0, f64::max),
        });
    }
    checks
}
