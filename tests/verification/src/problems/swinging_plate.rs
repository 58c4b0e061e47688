//! Swinging plate: a unit square on rollers that swings in a divergence-free mode, through the kernel's own steps.

use std::f64::consts::{FRAC_PI_2, PI, SQRT_2};

use softanvil_kernel::scenario::Interface;
use softanvil_kernel::{Simulation, StepInput};

use crate::memo::Memo;
use crate::order::over_cells;
use crate::row::Row;
use crate::scenes::{grid, neo_hookean};

/// Side of the square, m.
const SIDE: f64 = 0.1;
/// Amplitude over side: the linear solution is exact to this order.
const AMPLITUDE: f64 = 1e-6;
const YOUNGS_MODULUS: f64 = 17e6;
const DENSITY: f64 = 1100.0;

/// Cells per side.
pub const CELLS: [usize; 4] = [4, 8, 16, 32];

/// Displacement at (x, y), over the amplitude in time.
fn mode(x: f64, y: f64) -> [f64; 2] {
    let (a, b) = (FRAC_PI_2 * x / SIDE, FRAC_PI_2 * y / SIDE);
    [-a.sin() * b.cos(), a.cos() * b.sin()]
}

/// Root mean square error of the displacement over the amplitude, after `periods` periods with Poisson's ratio `nu` on `n` by `n` cells.
pub fn error(nu: f64, n: usize, periods: f64) -> f64 {
    static KNOWN: Memo<(u64, usize, u64), f64> = Memo::new();
    KNOWN.get((nu.to_bits(), n, periods.to_bits()), || computed_error(nu, n, periods))
}

fn computed_error(nu: f64, n: usize, periods: f64) -> f64 {
    let shear = YOUNGS_MODULUS / (2.0 * (1.0 + nu));
    let bulk = YOUNGS_MODULUS / (3.0 * (1.0 - 2.0 * nu));
    let mut scenario = grid(n, n, neo_hookean(shear, bulk));
    scenario.core.interface = Interface::Sliding;
    scenario.layers[0].material.density = DENSITY;
    let position = |u: usize, v: usize| [SIDE * u as f64 / n as f64, SIDE * v as f64 / n as f64];
    let mut simulation = Simulation::with_positions(&scenario, &position).expect("a legal mesh");
    let omega = PI / SQRT_2 / SIDE * (shear / DENSITY).sqrt();
    let dt = simulation.constants().dt;
    start(&mut simulation, omega);
    let steps = (periods * 2.0 * PI / omega / dt).round() as u64;
    simulation.step(steps, &StepInput { driven_position: Some(1.0), ..StepInput::default() }).expect("a stable run");
    let now = AMPLITUDE * SIDE * (omega * dt * steps as f64).cos();
    simulation
        .with(|model, state| {
            let (grid, [x, y], u) = (model.constants.grid, model.reference_position(), state.displacement());
            let (mut sum, mut count) = (0.0, 0.0);
            for v in 0..=grid.n_v {
                for node in v * grid.stride()..=v * grid.stride() + grid.n_u {
                    let mode = mode(x[node], y[node]);
                    sum += (u[0][node] - now * mode[0]).powi(2) + (u[1][node] - now * mode[1]).powi(2);
                    count += 1.0;
                }
            }
            (sum / count).sqrt() / (AMPLITUDE * SIDE)
        })
        .expect("memory of the right size")
}

/// The mode at its largest amplitude, with the velocity that the exact motion has on average over the step before.
fn start(simulation: &mut Simulation, omega: f64) {
    simulation
        .with(|model, state| {
            let dt = model.constants.dt;
            let rising = AMPLITUDE * SIDE * (1.0 - (omega * dt).cos()) / dt;
            let grid = model.constants.grid;
            let [x, y] = model.reference_position();
            for v in 0..=grid.n_v {
                for node in v * grid.stride()..=v * grid.stride() + grid.n_u {
                    let mode = mode(x[node], y[node]);
                    for (i, value) in mode.into_iter().enumerate() {
                        state.displacement_mut()[i][node] = AMPLITUDE * SIDE * value;
                        state.velocity_mut()[i][node] = rising * value;
                    }
                }
            }
        })
        .expect("memory of the right size");
}

/// Poisson's ratios of the study.
pub const POISSONS_RATIOS: [f64; 2] = [0.45, 0.4999];

/// Periods after which the error is taken: a quarter more than one, where an error of the frequency shows most.
pub const PERIODS: f64 = 1.25;

/// Rows of the table over `cells` per side.
pub fn rows(cells: &[usize]) -> Vec<Row> {
    let row = |nu: f64| {
        let errors: Vec<f64> = cells.iter().map(|n| error(nu, *n, PERIODS)).collect();
        Row {
            problem: "swinging_plate",
            quantity: format!("displacement, nu = {nu}"),
            reference: "closed form".into(),
            meshes: cells.iter().map(|n| format!("{n} x {n}")).collect(),
            order: Some(over_cells(cells, &errors)),
            errors,
        }
    };
    POISSONS_RATIOS.map(row).into()
}
