//! One explicit step of the whole system, stage by stage.

use crate::core_contact;
use crate::element::{self, ElementEnergy};
use crate::energy::StepWork;
use crate::error::StepError;
use crate::face::{self, Contact};
use crate::impactor::StepInput;
use crate::instruction_set::{InstructionSet, Work};
use crate::lanes::{LANES, ZERO, load, store, subtract_at, sum};
use crate::model::Model;
use crate::real::Real;
use crate::state::{Forces, State, corner_indices};
use crate::surface;
use crate::time_step;

/// Advances `state` by one step of `model.constants.dt`: central difference, from the positions at n and the velocities
/// at n - 1/2 to the positions at n + 1 and the velocities at n + 1/2.
///
/// The work is the same in every step: no iteration depends on the data.
///
/// # Errors
/// An inverted triangle, a step above the current stability limit, or an input that is not finite. The same error comes
/// back until the state is reset or restored.
pub fn step(model: &Model, state: &mut State, input: &StepInput) -> Result<(), StepError> {
    step_with(InstructionSet::best(), model, state, input)
}

/// [`step`] with a given instruction set, which changes the speed and no bit.
///
/// # Errors
/// As [`step`].
pub fn step_with(set: InstructionSet, model: &Model, state: &mut State, input: &StepInput) -> Result<(), StepError> {
    if let Some(failure) = state.scalars.failure {
        return Err(failure);
    }
    input.check(state.time(model))?;
    match set.run(Advance { model, state, input }) {
        Ok(()) => Ok(()),
        Err(failure) => {
            state.scalars.failure = Some(failure);
            Err(failure)
        }
    }
}

/// One step as work for an instruction set.
struct Advance<'s, 'm, 'a> {
    model: &'s Model<'m>,
    state: &'s mut State<'a>,
    input: &'s StepInput,
}

impl Work for Advance<'_, '_, '_> {
    type Output = Result<(), StepError>;

    #[inline(always)]
    fn run(self) -> Result<(), StepError> {
        advance(self.model, self.state, self.input)
    }
}

#[inline(always)]
fn advance(model: &Model, state: &mut State, input: &StepInput) -> Result<(), StepError> {
    time_step::monitor(model, state)?;
    let energy = internal_forces(model, state)?;
    let core = core_contact::react(model, state);
    let prediction = state.scalars.impactor.predict(model, input, state.scalars.step_index);
    let before = state.scalars.impactor.velocity_half;
    let face = face::contact(model, state, &prediction);
    state.scalars.contact_half_width = surface::contact_half_width(model, &state.as_view());
    let layer_kinetic = move_nodes(model, state);
    let work = StepWork {
        element: &energy,
        face: &face,
        core: &core,
        layer_kinetic,
        impactor_velocity: [before, state.scalars.impactor.velocity_half],
        prediction: &prediction,
        input,
    };
    state.scalars.energy.book(model, &work);
    measure(model, state, &face, &core, before);
    state.scalars.step_index += 1;
    Ok(())
}

/// Fills the nodal forces with minus the internal forces, block by block in index order.
#[inline(always)]
fn internal_forces(model: &Model, state: &mut State) -> Result<ElementEnergy, StepError> {
    let grid = &model.constants.grid;
    let terms = (2 * model.constants.n_term()).max(1);
    let mut energy = ElementEnergy::ZERO;
    state.nodes.force_x.fill(0.0);
    state.nodes.force_y.fill(0.0);
    for (block, constants) in model.cells.iter().enumerate() {
        let corners = state.corners(grid, block);
        let viscous = state.viscous.chunks_exact_mut(terms).nth(block).unwrap_or_default();
        let Some(history) = state.cells.get_mut(block) else { break };
        let hoop = model.hoops.get(block);
        let laws = model.constants.laws_of(block);
        let force = element::internal_force(laws, constants, hoop, &corners, history, viscous, &mut energy).map_err(
            |(lane, t)| StepError::Inverted {
                element: grid.element_index(block, lane, t),
                time: model.constants.time(state.scalars.step_index),
            },
        )?;
        for (index, corner) in corner_indices(grid, block).into_iter().zip(&force) {
            subtract_at(state.nodes.force_x, index, &corner[0]);
            subtract_at(state.nodes.force_y, index, &corner[1]);
        }
    }
    Ok(energy)
}

/// Moves the nodes under their forces; returns the kinetic energy of the section.
#[inline(always)]
fn move_nodes(model: &Model, state: &mut State) -> Real {
    let dt = model.constants.dt;
    let (fixed, nodes) = (&model.nodes, &mut state.nodes);
    let along_x =
        move_along(dt, fixed.nodal_mass, fixed.inverse_mass_x, nodes.force_x, nodes.velocity_x, nodes.displacement_x);
    let along_y =
        move_along(dt, fixed.nodal_mass, fixed.inverse_mass_y, nodes.force_y, nodes.velocity_y, nodes.displacement_y);
    along_x + along_y
}

#[inline(always)]
fn move_along(
    dt: Real,
    mass: &[Real],
    inverse_mass: &[Real],
    force: &[Real],
    velocity: &mut [Real],
    displacement: &mut [Real],
) -> Real {
    let mut double_kinetic = ZERO;
    for index in (0..mass.len()).step_by(LANES) {
        let (mass, inverse_mass, force) = (load(mass, index), load(inverse_mass, index), load(force, index));
        let (mut rate, mut moved) = (load(velocity, index), load(displacement, index));
        for l in 0..LANES {
            let before = rate[l];
            rate[l] = before + dt * (inverse_mass[l] * force[l]);
            moved[l] += dt * rate[l];
            double_kinetic[l] += mass[l] * (before * rate[l]);
        }
        store(velocity, index, &rate);
        store(displacement, index, &moved);
    }
    0.5 * sum(&double_kinetic)
}

/// Records the forces of the step and what the laboratory would read.
#[inline(always)]
fn measure(model: &Model, state: &mut State, face: &Contact, core: &Contact, velocity_before: Real) {
    let constants = &model.constants;
    let scalars = &mut state.scalars;
    scalars.force = Forces {
        contact: constants.section_factor * face.normal_force,
        core_reaction: constants.section_factor * core.normal_force,
    };
    let velocity = [velocity_before, scalars.impactor.velocity_half];
    let depth = scalars.impactor.deformation();
    scalars.metrics.take_step(constants, scalars.step_index, scalars.force.contact, velocity, depth);
    if let Some(sample) = scalars.sampler.take(constants, &scalars.force, scalars.impactor.position) {
        scalars.metrics.take_sample(&sample, constants.scenario.measurement.force_threshold);
    }
}
