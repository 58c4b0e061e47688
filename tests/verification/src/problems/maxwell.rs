//! Additive Maxwell terms through the element: ramp at a constant true strain rate, and relaxation.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::Formulation;

use crate::element::Cell;
use crate::problems::viscoelastic::after_ramp;
use crate::row::Check;
use crate::scenes::elastic;
use crate::tolerance::relative_error;

/// Time step of the element, s.
pub const DT: f64 = 1e-5;
const RATE: f64 = 100.0;
const TERMS: [(f64, f64); 2] = [(0.4e6, 2000.0), (0.1e6, 50.0)];

/// Two terms beside neo-Hooke.
pub fn material() -> Material {
    let mut material = elastic(0.1e6, 0.0, 1e6);
    for (i, (g, beta)) in TERMS.into_iter().enumerate() {
        material.maxwell_g[2 * i] = g;
        material.maxwell_beta[2 * i] = beta;
    }
    material
}

fn cells() -> [Cell; 2] {
    [material(), elastic(0.1e6, 0.0, 1e6)].map(|material| Cell::new(material, Formulation::PlaneStrain, DT))
}

/// Difference of the Kirchhoff stresses along and across, with and without the terms.
fn overstress([with, without]: &mut [Cell; 2], l: f64) -> f64 {
    let gradient = [[1.0 / l, 0.0], [0.0, l]];
    let difference = |p: [[f64; 2]; 2]| l * p[1][1] - p[0][0] / l;
    difference(with.deform(gradient)) - difference(without.deform(gradient))
}

/// A ramp and the relaxation after it.
pub struct Ramp {
    /// Largest error of the overstress, over its peak.
    pub error: f64,
    /// Error of the viscous work, relative.
    pub work_error: f64,
}

/// Ramp to a stretch of 2, and relaxation for twice as long.
pub fn ramp() -> Ramp {
    let mut cells = cells();
    let steps = 700;
    let end = f64::from(steps) * DT;
    let closed_form = |t: f64| -> f64 {
        let term = |(g, beta): &(f64, f64)| {
            4.0 * g / beta * RATE * (1.0 - (-beta * t.min(end)).exp()) * (-beta * (t - end).max(0.0)).exp()
        };
        TERMS.iter().map(term).sum()
    };
    let error = |n: u32| {
        let t = f64::from(n) * DT;
        overstress(&mut cells, (RATE * t.min(end)).exp()) - closed_form(t)
    };
    let largest = (1..=3 * steps).map(error).fold(0.0, |largest: f64, error| largest.max(error.abs()));
    // Stress difference times rate over the ramp; the relaxation takes none.
    let work = |(g, beta): &(f64, f64)| 4.0 * g / beta * RATE * RATE * (end - (1.0 - (-beta * end).exp()) / beta);
    let work: f64 = TERMS.iter().map(work).sum();
    let [with, _] = cells;
    Ramp { error: largest / closed_form(end), work_error: relative_error(with.viscous_work, work) }
}

/// Largest error of the overstress after a strain step within one time step, relative to the peak.
pub fn step_error() -> f64 {
    let l = 1.2_f64;
    let mut cells = cells();
    // The increment at the mean of the stretches before and after.
    let (along, across) = (2.0 * (l - 1.0) / (l + 1.0), 2.0 * (1.0 / l - 1.0) / (1.0 / l + 1.0));
    let closed_form = |n: u32| -> f64 {
        let term = |(g, beta): &(f64, f64)| 2.0 * g * (along - across) * after_ramp(f64::from(n) * DT, DT, 1.0 / beta);
        TERMS.iter().map(term).sum()
    };
    let error = |n| overstress(&mut cells, l) - closed_form(n);
    (0..2000).map(error).fold(0.0, |largest: f64, error| largest.max(error.abs())) / closed_form(0)
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    let check = |quantity: &str, error| Check {
        problem: "maxwell",
        quantity: quantity.into(),
        reference: "closed form",
        error,
    };
    vec![
        check("Maxwell: ramp to a stretch of 2 at 100 1/s and relaxation, over the peak", ramp().error),
        check("Maxwell: work of that ramp", ramp().work_error),
        check("Maxwell: relaxation after a step to a stretch of 1.2, over the peak", step_error()),
    ]
}
