//! A block that slides on the frictional core until friction stops it.

use softanvil_kernel::scenario::{Interface, Section};
use softanvil_kernel::{Model, Simulation, State, StepInput, step};

use crate::relaxation::{accelerate, damp};
use crate::row::Row;
use crate::scenes::{block, neo_hookean};

const GRAVITY: f64 = 20.0;
const SPEED: f64 = 0.2;
const HEIGHT: f64 = 10e-3;

/// Stopping distance of the centre of mass, m, and its reference v^2 / (2 mu g).
pub fn stopping_distance(friction: f64, element_size: f64) -> [f64; 2] {
    let mut scenario = block(2.0 * HEIGHT, HEIGHT, neo_hookean(4e6, 1e7));
    scenario.geometry.section = Section::Full;
    scenario.core.interface = Interface::Frictional;
    scenario.core.friction_coefficient = friction;
    scenario.impactor.gap = 1.0;
    scenario.mesh.element_size = element_size;
    let mut simulation = Simulation::new(&scenario).expect("a legal scenario");
    let dt = simulation.constants().dt;
    let distance = simulation.with(|model, state| {
        let input = StepInput { driven_position: Some(1.0), ..StepInput::default() };
        let advance = |state: &mut State| {
            accelerate(model, state, [0.0, -GRAVITY]);
            step(model, state, &input).expect("a step");
        };
        // Settle under gravity first.
        for _ in 0..(5e-3 / dt) as usize {
            damp(model, state, 1.0 - dt / 0.5e-3);
            advance(state);
        }
        let start = centre(model, state);
        state.velocity_mut()[0].iter_mut().for_each(|velocity| *velocity += SPEED);
        for _ in 0..(1.5 * SPEED / (friction * GRAVITY) / dt) as usize {
            advance(state);
        }
        centre(model, state) - start
    });
    [distance.expect("memory of the right size"), SPEED * SPEED / (2.0 * friction * GRAVITY)]
}

/// Mean displacement along x, by the trapezoidal rule, m.
fn centre(model: &Model, state: &State) -> f64 {
    let grid = model.constants.grid;
    let (mut sum, mut total) = (0.0, 0.0);
    for v in 0..=grid.n_v {
        for u in 0..=grid.n_u {
            let edge = |i: usize, n: usize| if i == 0 || i == n { 0.5 } else { 1.0 };
            let weight = edge(u, grid.n_u) * edge(v, grid.n_v);
            sum += weight * state.displacement()[0][v * grid.stride() + u];
            total += weight;
        }
    }
    sum / total
}

/// Coefficients of friction of the study.
pub const FRICTION: [f64; 2] = [0.1, 0.3];

/// Element size, m.
pub const ELEMENT_SIZE: f64 = 2e-3;

/// Rows of the table.
pub fn rows() -> Vec<Row> {
    let row = |friction: f64| {
        let [distance, reference] = stopping_distance(friction, ELEMENT_SIZE);
        Row {
            problem: "coulomb_block",
            quantity: format!("stopping distance, friction {friction}"),
            reference: "v^2 / (2 mu g), rigid".into(),
            meshes: vec![format!("{} mm", 1e3 * ELEMENT_SIZE)],
            errors: vec![distance / reference - 1.0],
            order: None,
        }
    };
    FRICTION.map(row).into()
}
