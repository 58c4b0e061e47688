//! Prony series through the element: relaxation after a step and response to a ramp.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::Formulation;

use crate::element::Cell;
use crate::row::Check;
use crate::scenes::elastic;

/// Time step of the element, s.
pub const DT: f64 = 2e-6;

/// As many terms as there can be on Mooney-Rivlin.
pub fn material() -> Material {
    Material {
        prony_g: [0.3, 0.2, 0.1, 0.1, 0.1],
        prony_tau: [0.1e-3, 0.4e-3, 2e-3, 8e-3, 20e-3],
        ..elastic(0.1e6, 0.05e6, 1e9)
    }
}

/// (g_k / g_inf, tau_k) of the terms.
fn terms() -> [(f64, f64); 5] {
    let m = material();
    let g_inf = 1.0 - m.prony_g.iter().sum::<f64>();
    std::array::from_fn(|k| (m.prony_g[k] / g_inf, m.prony_tau[k]))
}

/// What is left at the time `t`, s, of a branch that relaxes in `tau` s after a ramp to 1 that began `ramp` s before the time 0
/// and ended there: the mean of e^(-(t + s)/tau) over the ramp, by Simpson's rule over a hundred parts.
pub fn after_ramp(t: f64, ramp: f64, tau: f64) -> f64 {
    let left = |part: f64| (-(t + ramp * part) / tau).exp();
    let parts = 100;
    let simpson = |n: u32| {
        let (a, h) = (f64::from(n) / f64::from(parts), 1.0 / f64::from(parts));
        h / 6.0 * (left(a) + 4.0 * left(a + 0.5 * h) + left(a + h))
    };
    (0..parts).map(simpson).sum()
}

/// Largest relative error of the stress after a finite step, which is the elastic one times the relaxation function; the
/// step itself is a ramp over dt.
pub fn step_error() -> f64 {
    let gradient = [[1.0 / 1.6, 0.0], [0.0, 1.6]];
    let elastic_stress = Cell::new(elastic(0.1e6, 0.05e6, 1e9), Formulation::PlaneStrain, DT).deform(gradient)[1][1];
    let mut cell = Cell::new(material(), Formulation::PlaneStrain, DT);
    let error = |n: u32| {
        let overstress: f64 = terms().iter().map(|(ratio, tau)| ratio * after_ramp(f64::from(n) * DT, DT, *tau)).sum();
        cell.deform(gradient)[1][1] / (elastic_stress * (1.0 + overstress)) - 1.0
    };
    (0..5000).map(error).fold(0.0, |largest: f64, error| largest.max(error.abs()))
}

/// Largest error of the stress in a ramp of simple shear, over its largest value.
pub fn ramp_error() -> f64 {
    let rate = 0.01;
    let shear_modulus = material().shear_modulus_inf();
    let mut cell = Cell::new(material(), Formulation::PlaneStrain, DT);
    let mut largest: (f64, f64) = (0.0, 0.0);
    for n in 1..=5000 {
        let t = f64::from(n) * DT;
        let stress = cell.deform([[1.0, rate * t], [0.0, 1.0]])[0][1];
        let viscous: f64 = terms().iter().map(|(ratio, tau)| ratio * tau * (1.0 - (-t / tau).exp())).sum();
        let reference = shear_modulus * rate * (t + viscous);
        largest = (largest.0.max((stress - reference).abs()), largest.1.max(reference));
    }
    largest.0 / largest.1
}

/// Lines of the table.
pub fn checks() -> Vec<Check> {
    let check = |quantity: &str, error| Check {
        problem: "viscoelastic",
        quantity: quantity.into(),
        reference: "closed form",
        error,
    };
    vec![
        check("Prony: relaxation after a step to a stretch of 1.6", step_error()),
        check("Prony: ramp in simple shear, over the largest stress", ramp_error()),
    ]
}
