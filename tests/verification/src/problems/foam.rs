//! The foam's stress through the element, in the deformations whose closed forms the literature has.
//!
//! Source: Storakers, Journal of the Mechanics and Physics of Solids 34 (1986): with one Poisson's ratio nu for all terms the
//! sides of a bar stretched to l go to l^-nu; beta = nu / (1 - 2 nu).

use softanvil_kernel::material::{Hyperfoam, Material};
use softanvil_kernel::scenario::Formulation;

use crate::deformation::{Gradient, product, rotation};
use crate::element::Cell;
use crate::row::Check;
use crate::scenes::elastic;

/// Moduli, Pa, and exponents.
const MU: [f64; 3] = [0.12e6, 0.05e6, 0.01e6];
const ALPHA: [f64; 3] = [8.0, -2.0, 3.5];
/// Poisson's ratios: none at all, next to none, that of a soft foam, and the largest.
pub const RATIOS: [f64; 5] = [0.0, 1e-14, 1e-6, 0.2, 0.45];
/// Stretches of the loaded direction, to a compression of 90 %.
pub const STRETCHES: [f64; 8] = [0.1, 0.15, 0.3, 0.6, 0.9, 0.999, 1.1, 1.6];

/// The foam with one Poisson's ratio for all terms.
pub fn material(nu: f64) -> Material {
    elastic(0.0, 0.0, 1e6).with(Hyperfoam::new(MU, ALPHA, [nu; 3]))
}

/// sum 2 mu / alpha (l^alpha - v^-alpha) / length, Pa.
fn nominal(l: f64, v: f64, length: f64) -> f64 {
    MU.iter().zip(ALPHA).map(|(mu, alpha)| 2.0 * mu / alpha * (l.powf(alpha) - v.powf(-alpha))).sum::<f64>() / length
}

/// A deformation with what it should give.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// A bar with free sides.
    Uniaxial,
    /// No strain across.
    Confined,
    /// The same stretch everywhere.
    Hydrostatic,
    /// Simple shear.
    Shear,
}

/// Every mode, with its name for people.
pub const MODES: [(Mode, &str); 4] = [
    (Mode::Uniaxial, "free sides"),
    (Mode::Confined, "confined"),
    (Mode::Hydrostatic, "hydrostatic"),
    (Mode::Shear, "simple shear"),
];

/// Largest error of the nominal stress over its size, over the stretches.
pub fn error(mode: Mode, nu: f64) -> f64 {
    STRETCHES.iter().map(|l| error_at(mode, nu, *l)).fold(0.0, f64::max)
}

fn error_at(mode: Mode, nu: f64, l: f64) -> f64 {
    let cell = |formulation| Cell::new(material(nu), formulation, 1e-6);
    let beta = nu / (1.0 - 2.0 * nu);
    let scale = MU[0] + MU[1] + MU[2];
    match mode {
        Mode::Uniaxial => {
            let side = l.powf(-nu);
            let p = cell(Formulation::Axisymmetric).deform([[side, 0.0], [0.0, l]]);
            // The powers of J go by l^(alpha nu).
            let expected = nominal(l, l.powf(nu), l);
            let size = expected.abs() + scale;
            (p[1][1] - expected).abs().max(p[0][0].abs()) / size
        }
        Mode::Confined => {
            let p = cell(Formulation::PlaneStrain).deform([[1.0, 0.0], [0.0, l]]);
            let expected = [nominal(1.0, l.powf(beta), 1.0), nominal(l, l.powf(beta), l)];
            (p[0][0] - expected[0]).abs().max((p[1][1] - expected[1]).abs()) / (expected[1].abs() + scale)
        }
        Mode::Hydrostatic => {
            let p = cell(Formulation::Axisymmetric).deform([[l, 0.0], [0.0, l]]);
            let expected = nominal(l, l.powf(3.0 * beta), l);
            (p[1][1] - expected).abs().max((0.5 * p[0][0] - expected).abs()) / (expected.abs() + scale)
        }
        Mode::Shear => {
            let gradient = [[1.0, l - 1.0 / l], [0.0, 1.0]];
            let p = cell(Formulation::PlaneStrain).deform(gradient);
            let expected = (nominal(l, 1.0, 1.0) - nominal(1.0 / l, 1.0, 1.0)) / (l + 1.0 / l);
            (p[0][1] - expected).abs() / (expected.abs() + scale)
        }
    }
}

/// Largest difference of the stress under a turn from the turned stress, over its size.
pub fn error_of_turns() -> f64 {
    let still: [Gradient; 3] = [[[1.0, 0.0], [0.0, 0.2]], [[0.8, 0.0], [0.0, 0.8]], [[1.0, 0.7], [0.0, 0.6]]];
    let mut error = 0.0_f64;
    for (gradient, angle) in still.into_iter().flat_map(|gradient| [0.3, 1.4, 2.9].map(|angle| (gradient, angle))) {
        let cell = || Cell::new(material(0.2), Formulation::PlaneStrain, 1e-6);
        let turn = rotation(angle);
        let expected = product(turn, cell().deform(gradient));
        let found = cell().deform(product(turn, gradient));
        for (a, b) in found.iter().flatten().zip(expected.iter().flatten()) {
            error = error.max((a - b).abs() / expected.iter().flatten().fold(0.0_f64, |size, p| size.max(p.abs())));
        }
    }
    error
}

/// Largest error of the relaxation of the whole stress after a confined step, over the stress in the end: 1 + o e^(-t/tau), with
/// the overstress o after the step itself.
pub fn error_of_relaxation() -> f64 {
    let (dt, tau, g) = (1e-4, 2e-3, 0.6);
    let mut relaxing = material(0.2);
    (relaxing.prony_g[0], relaxing.prony_tau[0]) = (g, tau);
    let gradient = [[1.0, 0.0], [0.0, 0.5]];
    let elastic = Cell::new(material(0.2), Formulation::PlaneStrain, dt).deform(gradient);
    let mut cell = Cell::new(relaxing, Formulation::PlaneStrain, dt);
    cell.deform([[1.0, 0.0], [0.0, 1.0]]);
    let overstress = g / (1.0 - g) * (1.0 - (-dt / tau).exp()) / (dt / tau);
    let mut error = 0.0_f64;
    for n in 0..100 {
        let stress = cell.deform(gradient);
        let expected = 1.0 + overstress * (-f64::from(n) * dt / tau).exp();
        for i in 0..2 {
            error = error.max((stress[i][i] / elastic[i][i] - expected).abs());
        }
    }
    error
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    let check = |quantity: String, reference, error| Check { problem: "foam", quantity, reference, error };
    let of_mode = |(mode, name): (Mode, &str)| {
        let largest = RATIOS.iter().map(|nu| error(mode, *nu)).fold(0.0, f64::max);
        check(format!("{name}: stress at stretches 0.1 to 1.6, Poisson's ratios 0 to 0.45"), "closed form", largest)
    };
    let mut checks: Vec<Check> = MODES.into_iter().map(of_mode).collect();
    checks.push(check("stress under a turn".into(), "the stress, turned", error_of_turns()));
    checks.push(check("Prony: relaxation of the whole stress, confined".into(), "closed form", error_of_relaxation()));
    checks
}
