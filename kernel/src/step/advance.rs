//! One explicit step of the whole system, stage by stage.

use core::hint::black_box;

use crate::contact::{face, interface, rigid_core, surface};
use crate::element::{self, Block, CellHistory, Corners, ElementEnergy};
use crate::error::StepError;
use crate::impactor::{DrivenPath, StepInput};
use crate::model::Model;
use crate::number::instruction_set::InstructionSet;
use crate::number::pack::{LANES, Pack, ZERO, sum};
use crate::number::real::Real;
use crate::number::vector::{Scalar, Simd, Work};
use crate::state::{Rows, State, StepWork, corners};
use crate::step::among_threads;
use crate::step::monitor;
use crate::step::motion::{measure, move_nodes};
use crate::step::solid_advance;
use crate::tensor::deviator::Deviator;

/// Advances `state` by one step of `model.constants.dt`: central difference, from the positions at n and the velocities
/// at n - 1/2 to the positions at n + 1 and the velocities at n + 1/2.
///
/// The work of a section is the same in every step: no iteration depends on the data. That of a solid has an upper bound.
///
/// # Errors
/// An inverted triangle, or a step above the current stability limit; the same error comes back until the state is reset
/// or restored. An input that is not legal, which changes nothing.
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
    input.check(model.constants, state.time(model))?;
    recorded(set, model, state, input)
}

/// A step on a path whose input has been checked.
///
/// # Errors
/// As [`step`].
pub fn step_along(model: &Model, state: &mut State, path: &DrivenPath, number: u64) -> Result<(), StepError> {
    if let Some(failure) = state.scalars.failure {
        return Err(failure);
    }
    recorded(InstructionSet::best(), model, state, &path.input(number))
}

/// `count` steps, at whose end a driven face is where `input` says, and moves as it says.
///
/// # Errors
/// As [`step`]; the steps before a failure stay done.
pub fn steps(model: &Model, state: &mut State, count: u64, input: &StepInput) -> Result<(), StepError> {
    input.check(model.constants, state.time(model))?;
    let path = DrivenPath::new(model.constants, &state.scalars.impactor, input, count as Real);
    among_threads(&model.constants.grid, || (1..=count).try_for_each(|number| step_along(model, state, &path, number)))
}

/// One step, whose failure every further one gives.
#[inline(always)]
fn recorded(set: InstructionSet, model: &Model, state: &mut State, input: &StepInput) -> Result<(), StepError> {
    match advance_once(set, model, state, input) {
        Ok(()) => Ok(()),
        Err(failure) => {
            state.scalars.failure = Some(failure);
            Err(failure)
        }
    }
}

/// One step without a look at the input or at an earlier failure, and without a record of its own. One copy of it all, for
/// drops and trials.
#[inline(never)]
pub(crate) fn advance_once(
    set: InstructionSet,
    model: &Model,
    state: &mut State,
    input: &StepInput,
) -> Result<(), StepError> {
    if model.constants.grid.is_solid() {
        return among_threads(&model.constants.grid, || solid_advance::advance(set, model, state, input));
    }
    set.run(Advance { model, state, input })
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
    fn run<S: Simd>(self, simd: S) -> Result<(), StepError> {
        advance(simd, self.model, self.state, self.input)
    }
}

#[inline(always)]
fn advance<S: Simd>(simd: S, model: &Model, state: &mut State, input: &StepInput) -> Result<(), StepError> {
    let mut energy = ElementEnergy::ZERO;
    internal_forces(simd, model, state, &mut energy)?;
    monitor::check(simd, model, state)?;
    let core = rigid_core::react(simd, model, state);
    let interfaces = interface::press(simd, model, state);
    let prediction = state.scalars.impactor.predict(model, input, state.scalars.step_index);
    let before = state.scalars.impactor.velocity_half;
    let face = face::contact(simd, model, state, &prediction);
    state.scalars.contact_half_width = surface::contact_half_width(model, &state.as_view());
    let layer_kinetic = move_nodes(simd, model, state);
    monitor::guard(model, state, model.constants.symmetry_factor * layer_kinetic[0])?;
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

/// Fills the nodal forces with minus the internal forces, block by block in index order, and adds up the energies.
#[inline(always)]
fn internal_forces<S: Simd>(
    simd: S,
    model: &Model,
    state: &mut State,
    energy: &mut ElementEnergy,
) -> Result<(), StepError> {
    let grid = &model.constants.grid;
    let entries = (2 * model.constants.n_history_entry()).max(1);
    for force in &mut state.nodes.force {
        force.fill(0.0);
    }
    let viscous = state.viscous.chunks_exact_mut(entries).map(Some).chain(core::iter::repeat_with(|| None));
    let blocks = model.cells.iter().zip(state.cells.iter_mut()).zip(viscous).enumerate();
    // Written over by every block, so that none has to fill it first.
    let mut force = [[ZERO; 2]; 4];
    let (per_row, mut row, mut place, mut nodes) = (grid.blocks_per_row(), 0, 0, grid.first_nodes([0, 0]));
    for (index, ((constants, history), viscous)) in blocks {
        let block = Block { laws: model.constants.laws_of(index), constants, hoop: model.hoops.get(index) };
        let viscous = viscous.unwrap_or_default();
        let rows = state.nodes.rows(nodes);
        if !block.laws.is_plain() {
            simd.apart(WholeForce { block, rows, history, viscous, energy, force: &mut force });
        } else if S::WIDTH > 1 && block.hoop.is_none() {
            // Written twice, so that a copy knows that it is not axisymmetric and need not ask all over the element; processors
            // without vectors have less room for it.
            let block = Block { hoop: None, ..block };
            block_force::<S, PLAIN>(simd, &block, &rows, history, viscous, energy, &mut force);
        } else {
            block_force::<S, PLAIN>(simd, &block, &rows, history, viscous, energy, &mut force);
        }
        state.nodes.subtract_force(simd, nodes, &force);
        // The next block follows in the row, or begins the next one.
        place += 1;
        nodes = [nodes[0] + LANES, nodes[1] + LANES];
        if place == per_row {
            (row, place) = (row + 1, 0);
            nodes = grid.first_nodes([row, 0]);
        }
    }
    if sum(&energy.inverted) > 0.0 { Err(first_inverted(model, state)) } else { Ok(()) }
}

/// Forces of a block whose law is not isochoric or softens, as work of its own.
struct WholeForce<'b> {
    block: Block<'b>,
    rows: Rows<'b>,
    history: &'b mut CellHistory,
    viscous: &'b mut [Deviator],
    energy: &'b mut ElementEnergy,
    force: &'b mut Corners<Pack>,
}

impl Work for WholeForce<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd>(self, simd: S) {
        let Self { block, rows, history, viscous, energy, force } = self;
        if !block.laws.elastic.is_compressible() {
            block_force::<S, SOFTENING>(simd, &block, &rows, history, viscous, energy, force);
        } else if S::WIDTH > 1 && block.hoop.is_none() {
            let block = Block { hoop: None, ..block };
            block_force::<S, COMPRESSIBLE>(simd, &block, &rows, history, viscous, energy, force);
        } else {
            block_force::<S, COMPRESSIBLE>(simd, &block, &rows, history, viscous, energy, force);
        }
    }
}

/// A law that is isochoric and does not soften.
const PLAIN: u8 = 0;
/// One that is isochoric and softens.
const SOFTENING: u8 = 1;
/// One that is not isochoric.
const COMPRESSIBLE: u8 = 2;

/// Writes the internal forces on the corners of the cells of a block, N, by the forces of one of these kinds of law.
#[inline(always)]
fn block_force<S: Simd, const KIND: u8>(
    simd: S,
    block: &Block,
    rows: &Rows,
    history: &mut CellHistory,
    viscous: &mut [Deviator],
    energy: &mut ElementEnergy,
    force: &mut Corners<Pack>,
) {
    for chunk in 0..LANES / S::WIDTH {
        // The compiler would work out the addresses of all lanes ahead, which are more than there are registers, and keep
        // them in memory; of what it cannot see through it adds up an address where it is needed, at no cost.
        let (rows, history) = (black_box(rows), black_box(&mut *history));
        let block = &Block { constants: black_box(block.constants), ..*block };
        let displacement = corners(simd, chunk, rows);
        let of_chunk = match KIND {
            PLAIN => element::plain_force(simd, chunk, block, &displacement, history, viscous, energy),
            COMPRESSIBLE => {
                element::whole_force::<S, true>(simd, chunk, block, &displacement, history, viscous, energy)
            }
            _ => element::whole_force::<S, false>(simd, chunk, block, &displacement, history, viscous, energy),
        };
        for corner in 0..4 {
            for i in 0..2 {
                simd.store(of_chunk[corner][i], &mut force[corner][i], chunk);
            }
        }
    }
}

/// The first inverted triangle, as the error that it is.
#[cold]
fn first_inverted(model: &Model, state: &State) -> StepError {
    let grid = &model.constants.grid;
    let found = model.cells.iter().enumerate().find_map(|(block, constants)| {
        let block_of = Block { laws: model.constants.laws_of(block), constants, hoop: model.hoops.get(block) };
        // The first triangles of the block, then the second ones.
        (0..2 * LANES).find_map(|i| {
            let (t, l) = (i / LANES, i % LANES);
            let corners = state.corners(Scalar, l, grid, block);
            let jacobian = element::cell_kinematics(Scalar, l, &block_of, &corners)[t].jacobian;
            if jacobian > Real::MIN_POSITIVE { None } else { Some(grid.element_index(block, l, t)) }
        })
    });
    StepError::Inverted { element: found.unwrap_or_default(), time: model.constants.time(state.scalars.step_index) }
}
