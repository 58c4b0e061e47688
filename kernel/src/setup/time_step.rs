//! The fixed time step: chosen once, from a trial of this very scenario.
//!
//! A cell that is pressed bears a smaller step than at rest, by how much depends on the law and on how far the scenario
//! presses it, which no formula says beforehand. A trial (`trial.rs`) on a coarse mesh with a step that follows its
//! limit tells the ratio of the smallest limit to that at rest; times the limit at rest of the mesh itself and
//! the safety factor it gives the step. Where the ratio is small, a coarse mesh says too little of the cells that are
//! pressed most, and the trial is repeated on the mesh itself. So it is at once where a layer says its rows. A drop on a foam that lies
//! loose is made once beforehand, with the step itself.

use crate::error::ModelError;
use crate::features::PADS;
use crate::mesh::{Grid, reference_position, solid_position};
use crate::model::{Constants, ModelArrays};
use crate::number::math;
use crate::number::real::{self, Real};
use crate::sampling::{MAX_STEPS_PER_SAMPLE, SAMPLING_INTERVAL, SMALLEST_STEP};
use crate::scenario::{LayerInterface, Motion, Outline, Scenario, StepBy};
use crate::setup::assembly::{assemble, fingerprint};
use crate::setup::numbers::Positions;
use crate::setup::trial::{self, Forecast};
use crate::state::StateMemory;

/// Rows of cells of the coarse mesh: the fewest that show a maximum of compression between core and face.
const COARSE_ROWS: Real = 3.0;

/// The trial is repeated on the mesh itself where the limit falls below this part of that at rest.
const REPEAT_BELOW: Real = 0.6;

/// The same of a foam, whose limit falls further where its cells meet an edge.
const REPEAT_FOAM_BELOW: Real = 0.9;

/// What a drop may leave of the limit that its trial has found: meshes and steps differ, and a layer may fold on the way up.
const MARGIN: Real = 0.9;

/// The same again where layers meet that are not bonded: which nodes touch, and when, differs with every step.
const OPEN_MARGIN: Real = 0.8;

/// Times that a drop is made beforehand, at most, to find a step that is not refused.
const REHEARSALS: usize = 5;

/// The same again for every factor of e that the limit has fallen by: of a layer pressed flat a trial says less.
const MARGIN_POWER: Real = 0.03;

/// Fills `arrays` with the model of `scenario`, whose nodes rest at `position([u, v, w])`, m, and `place` with its constants with the
/// step chosen. A trial runs in the memory of a `state`.
///
/// # Errors
/// As [`assemble`]; a stable step that is too small to offer, or a given step above the limit at rest.
pub(crate) fn with_chosen_step<'c>(
    scenario: &Scenario,
    position: Positions,
    arrays: &mut ModelArrays,
    state: &mut StateMemory,
    place: &'c mut Option<Constants>,
) -> Result<&'c Constants, ModelError> {
    let grid = Grid::new(scenario)?;
    let forecast = match scenario.time.step_by {
        StepBy::SafetyFactor => Some(foresee(scenario, &grid, position, arrays, state, place)?),
        StepBy::Given => None,
    };
    let constants = assemble(scenario, grid, position, arrays, place)?;
    let at_rest = trial::limit_at_rest(constants, arrays);
    let step = match forecast {
        Some(forecast) => {
            let open = if grid.layer_open.contains(&true) { OPEN_MARGIN } else { 1.0 };
            scenario.time.safety_factor * (margin(forecast.ratio) * open) * forecast.ratio * at_rest
        }
        None if scenario.time.step > at_rest => {
            return Err(ModelError::StepTooLarge { step: scenario.time.step, limit: at_rest });
        }
        None => scenario.time.step,
    };
    let stretch = forecast.map_or(1.0, |forecast| forecast.stretch);
    let count = steps_per_sample(step, stretch)?;
    constants.set_step(SAMPLING_INTERVAL / count as Real, count);
    if forecast.is_some() && is_rehearsed(constants) {
        rehearse(constants, arrays, state, stretch)?;
    }
    constants.fingerprint = fingerprint(scenario, &grid, arrays.nodes);
    constants.design_stretch = stretch;
    Ok(constants)
}

/// Whether the drop is made once beforehand: a foam that lies loose, or on which a layer does, flaps when the mass has left, and which cell
/// folds differs with every step, so that no trial tells what the chosen one will meet.
fn is_rehearsed(constants: &Constants) -> bool {
    let scenario = &constants.scenario;
    let loose = || scenario.layers.iter().skip(1).any(|layer| layer.interface == LayerInterface::Separating);
    let drops = scenario.impactor.motion == Motion::Drop && !constants.grid.is_solid();
    PADS && drops && constants.has_foam() && loose()
}

/// Makes the drop with the step that is chosen, and takes a smaller one as often as it is refused.
#[inline(never)]
fn rehearse(
    constants: &mut Constants,
    arrays: &mut ModelArrays,
    state: &mut StateMemory,
    stretch: Real,
) -> Result<(), ModelError> {
    let arrays = arrays.first(&constants.size)?;
    for _ in 0..REHEARSALS {
        let Some(limit) = trial::refusal(constants, &arrays, state)? else { break };
        let count = steps_per_sample(MARGIN * limit, stretch)?;
        constants.set_step(SAMPLING_INTERVAL / count as Real, count);
    }
    Ok(())
}

/// Where a node of the scenario's own shape rests, m.
pub(super) fn place_of(scenario: &Scenario, grid: &Grid, [u, v, w]: [usize; 3]) -> [Real; 3] {
    if grid.is_solid() {
        return solid_position(scenario, grid, [u, v, w]);
    }
    let [x, y] = reference_position(scenario, grid, u, v);
    [x, y, 0.0]
}

/// What a trial of the scenario finds, on a coarse mesh and, if that is not enough, on its own. Apart, so that its numbers
/// leave the stack before the model's come.
#[inline(never)]
fn foresee(
    scenario: &Scenario,
    grid: &Grid,
    position: Positions,
    arrays: &mut ModelArrays,
    state: &mut StateMemory,
    place: &mut Option<Constants>,
) -> Result<Forecast, ModelError> {
    let mut tried = scenario.clone();
    let motion = trial::prepare(&mut tried);
    let size = scenario.thickness() / COARSE_ROWS;
    tried.mesh.element_size = math::max(size, scenario.mesh.element_size);
    let coarse = Grid::new(&tried)?;
    // The cells of a layer that says its rows may be flat or tall, and a coarse mesh says little of those.
    let says_rows = scenario.layers.iter().any(|layer| layer.rows > 0);
    // Nor does it of nodes at an edge of the face or of a layer, or between layers that meet.
    let even = grid.has_even_surface() && Outline::of(scenario).radius == 0.0;
    let open = grid.layer_open.contains(&true);
    if coarse != *grid && !says_rows && even && !open {
        let rest = |node| place_of(&tried, &coarse, node);
        let forecast = trial::run(&tried, &motion, coarse, &rest, arrays, state, place)?;
        let has_foam = place.as_ref().is_some_and(Constants::has_foam);
        if forecast.ratio >= if has_foam { REPEAT_FOAM_BELOW } else { REPEAT_BELOW } {
            return Ok(forecast);
        }
    }
    tried.mesh.element_size = scenario.mesh.element_size;
    trial::run(&tried, &motion, *grid, position, arrays, state, place)
}

/// Part of the limit that is kept where a trial has found `ratio`.
fn margin(ratio: Real) -> Real {
    MARGIN * math::exp(MARGIN_POWER * math::ln(ratio))
}

/// Steps per sampling interval: as few as are not longer than `step`, s, which a cell at this `stretch` asks for.
fn steps_per_sample(step: Real, stretch: Real) -> Result<u32, ModelError> {
    // A step that is a whole divisor but for `SAME` counts as that divisor.
    let count = math::max(1.0, math::ceil(SAMPLING_INTERVAL / step * (1.0 - real::SAME)));
    if count > MAX_STEPS_PER_SAMPLE as Real {
        return Err(ModelError::StepTooSmall { step, smallest: SMALLEST_STEP, stretch });
    }
    Ok(count as u32)
}
