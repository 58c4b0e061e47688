//! One explicit step of a solid: as that of a section ([`crate::step::step`]), with a third direction.

use crate::contact::{solid_core, solid_face, surface};
use crate::element::ElementEnergy;
use crate::error::StepError;
use crate::impactor::StepInput;
use crate::model::Model;
use crate::number::instruction_set::InstructionSet;
use crate::number::real::Real;
use crate::number::vector::{Simd, Work};
use crate::state::{ContactWork, SolidState, State, StepWork};
use crate::step::motion::{measure, move_along, move_nodes};
use crate::step::solid_forces::internal_forces;
use crate::step::{monitor, solid_stable_step};

/// One step of a solid.
pub(super) fn advance(
    set: InstructionSet,
    model: &Model,
    state: &mut State,
    input: &StepInput,
) -> Result<(), StepError> {
    let mut energy = ElementEnergy::ZERO;
    internal_forces(set, model, state, &mut energy)?;
    if solid_stable_step::is_exceeded(set, model, state) {
        return Err(monitor::failure(model, state));
    }
    let core = solid_core::react(model, state);
    let prediction = state.scalars.impactor.predict(model, input, state.scalars.step_index);
    let before = state.scalars.impactor.velocity_half;
    let face = solid_face::contact(model, state, &prediction);
    state.scalars.contact_half_width = surface::contact_half_width(model, &state.as_view());
    let layer_kinetic = set.run(Motion { model, state });
    monitor::guard(model, state, model.constants.symmetry_factor * layer_kinetic[0])?;
    let work = StepWork {
        element: &energy,
        face: &face,
        core: &core,
        interfaces: &ContactWork::default(),
        layer_kinetic,
        impactor_velocity: [before, state.scalars.impactor.velocity_half],
        impactor: &state.scalars.impactor,
        prediction: &prediction,
        input,
    };
    state.scalars.energy.update(model, &work);
    measure(model, state, &face, &core, before);
    state.scalars.step_index += 1;
    Ok(())
}

/// The motion of the nodes in all three directions, as work for an instruction set; gives what [`move_nodes`] gives.
struct Motion<'s, 'm, 'a> {
    model: &'s Model<'m>,
    state: &'s mut State<'a>,
}

impl Work for Motion<'_, '_, '_> {
    type Output = [Real; 2];

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [Real; 2] {
        move_solid(simd, self.model, self.state)
    }
}

/// Moves the nodes in all three directions; as [`move_nodes`].
#[inline(always)]
fn move_solid<S: Simd>(simd: S, model: &Model, state: &mut State) -> [Real; 2] {
    let section = move_nodes(simd, model, state);
    let constants = model.constants;
    let SolidState { displacement, velocity, force, .. } =
        SolidState::of(&constants.grid, constants.solid_history_packs, state.nodes.solid);
    let fixed = [model.nodes.nodal_mass, model.solid().inverse_mass_z];
    let along_z = move_along(simd, constants.dt, fixed, force, velocity, displacement);
    [section[0] + along_z[0], section[1] + along_z[1]]
}
