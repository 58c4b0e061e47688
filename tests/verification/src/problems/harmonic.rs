//! Storage and loss modulus from a sinusoidal shear test over three decades of frequency, through the element.

use softanvil_kernel::material::Material;
use softanvil_kernel::scenario::Formulation;

use crate::element::Cell;
use crate::row::Check;
use crate::scenes::elastic;

const TAU: [f64; 2] = [0.4e-3, 20e-3];
const STEPS: u32 = 400;
const AMPLITUDE: f64 = 1e-4;

/// (material, G_inf, G_k).
fn prony() -> (Material, f64, [f64; 2]) {
    let mut material = elastic(0.1e6, 0.05e6, 1e6);
    material.prony_g[..2].copy_from_slice(&[0.5, 0.3]);
    material.prony_tau[..2].copy_from_slice(&TAU);
    (material, 0.3e6, [0.3e6 * 0.5 / 0.2, 0.3e6 * 0.3 / 0.2])
}

fn maxwell() -> (Material, f64, [f64; 2]) {
    let mut material = elastic(0.1e6, 0.05e6, 1e6);
    material.maxwell_g[..2].copy_from_slice(&[0.7e6, 0.2e6]);
    material.maxwell_beta[..2].copy_from_slice(&TAU.map(|tau| 1.0 / tau));
    (material, 0.3e6, [0.7e6, 0.2e6])
}

/// One cycle at the end of a test long enough to forget its start.
struct Cycle {
    storage: f64,
    loss: f64,
    /// Viscous work, J/m3.
    work: f64,
}

fn measure(material: Material, omega: f64) -> Cycle {
    let dt = 2.0 * std::f64::consts::PI / omega / f64::from(STEPS);
    let mut cell = Cell::new(material, Formulation::PlaneStrain, dt);
    let cycles = (12.0 * TAU[1] * omega / (2.0 * std::f64::consts::PI)).ceil() as u32 + 1;
    let (mut storage, mut loss, mut before) = (0.0, 0.0, 0.0);
    for n in 1..=cycles * STEPS {
        let (sine, cosine) = (omega * f64::from(n) * dt).sin_cos();
        let stress = cell.deform([[1.0, AMPLITUDE * sine], [0.0, 1.0]])[0][1];
        if n > (cycles - 1) * STEPS {
            storage += 2.0 / f64::from(STEPS) * stress * sine / AMPLITUDE;
            loss += 2.0 / f64::from(STEPS) * stress * cosine / AMPLITUDE;
        } else {
            before = cell.viscous_work;
        }
    }
    Cycle { storage, loss, work: cell.viscous_work - before }
}

/// A quantity of the test: what, at which frequency, 1/s, its value and its closed form.
pub struct Measured {
    /// What it is.
    pub what: &'static str,
    /// Angular frequency, 1/s.
    pub omega: f64,
    /// By the element.
    pub value: f64,
    /// By the closed form.
    pub reference: f64,
}

/// The two series, by name.
pub const SERIES: [&str; 2] = ["Prony", "Maxwell"];

/// Storage and loss modulus and work per cycle of a series at 13 frequencies.
pub fn measured(series: &str) -> Vec<Measured> {
    let (material, long_term, moduli) = if series == "Prony" { prony() } else { maxwell() };
    let mut list = Vec::new();
    for k in 0..=12 {
        let omega = 10.0 * 10.0_f64.powf(f64::from(k) / 4.0);
        let cycle = measure(material, omega);
        let (mut storage, mut loss) = (long_term, 0.0);
        for (modulus, tau) in moduli.into_iter().zip(TAU) {
            let product = omega * tau;
            storage += modulus * product * product / (1.0 + product * product);
            loss += modulus * product / (1.0 + product * product);
        }
        let dissipated = std::f64::consts::PI * loss * AMPLITUDE * AMPLITUDE;
        for (what, value, reference) in
            [("G'", cycle.storage, storage), ("G''", cycle.loss, loss), ("work per cycle", cycle.work, dissipated)]
        {
            list.push(Measured { what, omega, value, reference });
        }
    }
    list
}

/// Lines of the table: the largest error over the frequencies.
pub fn checks() -> Vec<Check> {
    let check = |series: &&str| Check {
        problem: "harmonic",
        quantity: format!("{series}: G', G'', work per cycle, 10 to 10000 1/s"),
        reference: "closed form",
        error: measured(series).iter().fold(0.0, |a: f64, m| a.max((m.value / m.reference - 1.0).abs())),
    };
    SERIES.iter().map(check).collect()
}
