//! One explicit step of a solid: as that of a section ([`crate::step::step`]), with a third direction, and the monitor beside the
//! contact.

use crate::contact::{solid_core, solid_face, solid_interface, surface};
use crate::element::ElementEnergy;
use crate::error::StepError;
use crate::impactor::StepInput;
use crate::model::Model;
use crate::number::instruction_set::InstructionSet;
use crate::number::pack::LANES;
use crate::number::real::Real;
use crate::number::vector::{Simd, Work};
use crate::state::{SolidState, State, StateNodes, StepWork};
use crate::step::motion::{Moving, measure};
use crate::step::solid_forces::internal_forces;
#[cfg(feature = "threads")]
use crate::step::solid_threads;
use crate::step::{both, monitor, solid_stable_step};

/// One step of a solid.
pub(super) fn advance(
    set: InstructionSet,
    model: &Model,
    state: &mut State,
    input: &StepInput,
) -> Result<(), StepError> {
    let (constants, mut energy) = (model.constants, ElementEnergy::ZERO);
    internal_forces(set, model, state, &mut energy)?;
    let step_index = state.scalars.step_index;
    let prediction = state.scalars.impactor.predict(model, input, step_index);
    let before = state.scalars.impactor.velocity_half;
    let (mut nodes, history) = state.nodes.without_history(constants);
    // The monitor looks at the histories, which contact leaves as they are. Where it ends the step, no more has changed
    // than forces.
    let ((core, interfaces, push), exceeded) = both(
        &constants.grid,
        || {
            let core = solid_core::react(model, &mut nodes);
            let interfaces = solid_interface::press(model, &mut nodes);
            (core, interfaces, solid_face::press(model, &mut nodes, &prediction))
        },
        || solid_stable_step::is_exceeded(set, model, history, step_index),
    );
    if exceeded {
        return Err(monitor::failure(model, state));
    }
    let face = solid_face::complete(model, &mut nodes, &mut state.scalars.impactor, &prediction, &push);
    state.scalars.contact_half_width = surface::contact_half_width(model, &state.as_view());
    let layer_kinetic = move_solid(set, model, state);
    monitor::guard(model, state, constants.symmetry_factor * layer_kinetic[0])?;
    let work = StepWork {
        element: &energy,
        face: &face,
        core: &core,
        interfaces: &interfaces,
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

/// Nodes that are moved at a time along one direction: enough for a core to be asked, and few enough for many cores. The kinetic
/// energies are added up by these parts, however many cores there are.
const NODES_OF_A_PART: usize = 128 * LANES;

/// Moves the nodes in all three directions; as [`crate::step::motion::move_nodes`].
fn move_solid(set: InstructionSet, model: &Model, state: &mut State) -> [Real; 2] {
    let (constants, fixed) = (model.constants, &model.nodes);
    let grid = &constants.grid;
    let StateNodes { displacement: [ux, uy], velocity: [vx, vy], force: [fx, fy], solid, .. } = &mut state.nodes;
    let along_z = SolidState::of(grid, constants.solid_history_packs, solid);
    let along = |inverse_mass, force, velocity, displacement| {
        Moving { mass: fixed.nodal_mass, inverse_mass, force, velocity, displacement }.parts(NODES_OF_A_PART)
    };
    let parts = along(fixed.inverse_mass_x, &**fx, &mut **vx, &mut **ux)
        .chain(along(fixed.inverse_mass_y, fy, vy, uy))
        .chain(along(model.solid().inverse_mass_z, along_z.force, along_z.velocity, along_z.displacement));
    let advance = |nodes| set.run(Motion { nodes, dt: constants.dt });
    let total = |sum: [Real; 2], part: [Real; 2]| [sum[0] + part[0], sum[1] + part[1]];
    #[cfg(feature = "threads")]
    if solid_threads::pays(grid) {
        return solid_threads::each(parts, advance).into_iter().fold([0.0; 2], total);
    }
    parts.map(advance).fold([0.0; 2], total)
}

/// The motion of nodes as work for an instruction set.
struct Motion<'s> {
    nodes: Moving<'s>,
    dt: Real,
}

impl Work for Motion<'_> {
    type Output = [Real; 2];

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) -> [Real; 2] {
        self.nodes.advance(simd, self.dt)
    }
}
