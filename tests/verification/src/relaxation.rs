//! Quasi-static loading through the kernel's own steps: a slow face, and damping of all velocities in proportion to
//! themselves (dynamic relaxation).

use softanvil_kernel::{Model, Simulation, State, StepInput, step};

/// Kinetic over elastic energy at which the layer counts as at rest: the force is then off by its square root.
const AT_REST: f64 = 1e-12;

/// Presses the face `depth` m into the anvil within `travel` s, then holds it until all motion is gone; velocities decay
/// with the time constant `decay` s. Returns the contact force, N.
///
/// # Panics
/// If a step fails, or the motion does not end within a hundred times the travel.
pub fn press_slowly(simulation: &mut Simulation, depth: f64, travel: f64, decay: f64) -> f64 {
    let stage = Stage { from: 0.0, to: depth, travel, decay, at_rest: AT_REST };
    simulation.with(|model, state| press_on(model, state, &stage)).expect("memory of the right size")
}

/// A part of a slow press.
pub struct Stage {
    /// Depth of the face at its start, m.
    pub from: f64,
    /// Depth at its end, m.
    pub to: f64,
    /// Time from one to the other, s.
    pub travel: f64,
    /// Time constant with which velocities decay, s.
    pub decay: f64,
    /// Kinetic over elastic energy at which it ends.
    pub at_rest: f64,
}

/// Presses the face on through a stage and holds it until all motion is gone. Returns the contact force, N.
///
/// # Panics
/// If a step fails, or the motion does not end within a hundred times the travel.
pub fn press_on(model: &Model, state: &mut State, stage: &Stage) -> f64 {
    let (dt, mut time) = (model.constants.dt, 0.0);
    while time < stage.travel || state.scalars.energy.layer_kinetic > stage.at_rest * state.scalars.energy.elastic {
        assert!(time < 100.0 * stage.travel, "the layer does not come to rest");
        time += dt;
        let part = (time / stage.travel).min(1.0);
        // No jump of velocity at either end.
        let position = -(stage.from + (stage.to - stage.from) * part * part * (3.0 - 2.0 * part));
        damp(model, state, 1.0 - dt / stage.decay);
        step(model, state, &StepInput { driven_position: Some(position), ..StepInput::default() }).expect("a step");
    }
    state.scalars.force.contact
}

/// Scales all velocities.
pub fn damp(model: &Model, state: &mut State, factor: f64) {
    for velocity in state.velocity_mut().into_iter().flatten() {
        *velocity *= factor;
    }
    let [_, along_z] = state.along_z_mut(model);
    along_z.iter_mut().for_each(|velocity| *velocity *= factor);
}

/// Adds an acceleration field to all nodes for one step, m/s2.
pub fn accelerate(model: &Model, state: &mut State, acceleration: [f64; 2]) {
    let grid = model.constants.grid;
    for (velocity, acceleration) in state.velocity_mut().into_iter().zip(acceleration) {
        for row in velocity.chunks_mut(grid.stride()) {
            row.iter_mut().take(grid.n_u + 1).for_each(|value| *value += model.constants.dt * acceleration);
        }
    }
}
