//! Nominal stress of every law under uniaxial, planar and equibiaxial stretch, through the element.

use softanvil_kernel::material::{ElasticLaw, Material};
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
    match mode {
        Mode::Uniaxial => {
            let side = l.powf(-0.5);
            let p = cell(Formulation::Axisymmetric).deform([[side, 0.0], [0.0, l]]);
            [l * p[1][1] - side * 0.5 * p[0][0], reference(material, [l, side, side], l, side, 1.0 / l)]
        }
        Mode::Planar => {
            let p = cell(Formulation::PlaneStrain).deform([[1.0 / l, 0.0], [0.0, l]]);
            [l * p[1][1] - p[0][0] / l, reference(material, [l, 1.0 / l, 1.0], l, 1.0 / l, 1.0)]
        }
        Mode::Equibiaxial => {
            let through = l.powi(-2);
            let p = cell(Formulation::Axisymmetric).deform([[l, 0.0], [0.0, through]]);
            [l * 0.5 * p[0][0] - through * p[1][1], reference(material, [l, l, through], l, through, l * l)]
        }
    }
}

/// l P of the loaded direction, whose stretch is `loaded`, for a free direction of stretch `free`, given l P / (2 (W1 + f
/// W2)) = l^2 - free^2 and f.
fn reference(m: &Material, stretches: [f64; 3], loaded: f64, free: f64, factor: f64) -> f64 {
    let i1: f64 = stretches.iter().map(|l| l * l).sum();
    let i2: f64 = stretches.iter().map(|l| 1.0 / (l * l)).sum();
    let (a, b) = (i1 - 3.0, i2 - 3.0);
    let (w1, w2) = match m.law {
        ElasticLaw::NeoHookean => (m.c10, 0.0),
        ElasticLaw::MooneyRivlin => (m.c10 + 2.0 * m.c20 * a + m.c11 * b, m.c01 + 2.0 * m.c02 * b + m.c11 * a),
        ElasticLaw::Yeoh => (m.c10 + 2.0 * m.c20 * a + 3.0 * m.c30 * a * a, 0.0),
        ElasticLaw::Ogden => {
            let powers = m.ogden_mu.iter().zip(m.ogden_alpha).map(|(mu, k)| mu * (loaded.powf(k) - free.powf(k)));
            return powers.sum();
        }
    };
    2.0 * (loaded * loaded - free * free) * (w1 + factor * w2)
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
