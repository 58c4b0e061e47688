//! A trial of a scenario with a step that follows its limit: from the first touch to the deepest point, to find how far the
//! limit falls.
//!
//! A drop begins at the surface with the speed that the mass has there, and ends where it turns; on a foam or a solid, whose free sides
//! may fold as it comes back, where the mass is up at the surface again or falls anew. A driven or prescribed
//! face goes down to the depth it is expected at, slowly against the waves in the layer.

use crate::error::{ModelError, StepError};
use crate::impactor::StepInput;
use crate::mesh::Grid;
use crate::model::{Constants, Model, ModelArrays};
use crate::number::instruction_set::InstructionSet;
use crate::number::math;
use crate::number::real::Real;
use crate::sampling::SMALLEST_STEP;
use crate::scenario::{DropBy, Impactor, Motion, Scenario};
use crate::setup::assembly::assemble;
use crate::setup::numbers::Positions;
use crate::state::{State, StateMemory};
use crate::step::{Cells, Critical, SolidCells, advance_once, among_threads};

/// What a trial has found.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Forecast {
    /// Smallest limit of the step over that at rest.
    pub ratio: Real,
    /// Smallest principal stretch in the section of the cell that had it.
    pub stretch: Real,
}

/// Most steps between two looks at all cells. The monitor looks at some of them in each step.
const MAX_STRIDE: Real = 16.0;

/// Part of the limit that it may fall by between two looks at a foam, half of what the step keeps away from it; the next look comes
/// sooner where it fell by more, or a cell that is pressed fast would turn inside out by a step that is no longer stable.
const FALL: Real = 0.05;

/// Part of the layer's thickness that the face may travel between two looks, so that no limit falls far in between.
const TRAVEL: Real = 0.02;

/// Most steps of a trial, so that its work is bounded whatever the scenario; what it has found until then counts.
const MAX_STEPS: usize = 1 << 17;

/// Part of the energy brought in that may be left unexplained on the way: a little less than the 0.5 % that plausible drops are tested for.
const LEFT_UNEXPLAINED: Real = 0.004;

/// Part of the first impact's smallest limit at which that of the next one counts no more: a single drop on a foam that the
/// next one would press flat is not to pay a thousand times over.
const NEXT_IMPACT: Real = 0.25;

/// Part of the limit that the step follows it at: what is left is more than the limit falls between two looks.
const FOLLOWED: Real = 0.9;

/// Speed of a pressing face over that of shear waves in the relaxed layer.
const PRESS_SPEED: Real = 0.05;

/// Deepest that a face is taken to press, as a part of the layer's thickness.
const DEEPEST: Real = 0.95;

/// Makes of a `scenario` that of its trial; tells how the impactor moves.
pub(crate) fn prepare(scenario: &mut Scenario) -> TrialMotion {
    let motion = TrialMotion::new(scenario);
    let impactor = &mut scenario.impactor;
    impactor.gap = 0.0;
    match motion {
        TrialMotion::Drop { speed } => (impactor.drop_by, impactor.drop_speed) = (DropBy::Speed, speed),
        TrialMotion::Press { .. } => impactor.motion = Motion::Driven,
    }
    motion
}

/// Runs the trial `scenario`, whose impactor moves by `motion`, on its `grid`, whose nodes rest at `position([u, v, w])`, m, with
/// the constants in `place`, which the model itself will take.
///
/// # Errors
/// As [`assemble`], and too little memory for a state.
#[inline(never)]
pub(crate) fn run(
    scenario: &Scenario,
    motion: &TrialMotion,
    grid: Grid,
    position: Positions,
    arrays: &mut ModelArrays,
    state: &mut StateMemory,
    place: &mut Option<Constants>,
) -> Result<Forecast, ModelError> {
    let constants = assemble(scenario, grid, position, arrays, place)?;
    let arrays = arrays.first(&constants.size)?;
    let at_rest = limit_at_rest(constants, &arrays);
    let mut trial = Trial { smallest: at_rest, stretch: 1.0, constants };
    trial.constants.set_step(FOLLOWED * at_rest, 1);
    State::new(&trial.model(&arrays), state.lend())?;
    among_threads(&grid, || trial.march_through(motion, SMALLEST_STEP, &arrays, state))?;
    if trial.constants.softens() {
        // The next impact presses what has softened deeper.
        let model = trial.model(&arrays);
        if State::view(&model, state.lend())?.next_impact(&model, 0.0).is_ok() {
            let enough = math::max(SMALLEST_STEP, NEXT_IMPACT * trial.smallest);
            among_threads(&grid, || trial.march_through(motion, enough, &arrays, state))?;
        }
    }
    Ok(Forecast { ratio: trial.smallest / at_rest, stretch: trial.stretch })
}

/// A limit, s, that the step of `constants` is above in its drop: that of a cell, or half of the step where a cell turns inside out or energy is
/// left unexplained; none if the drop goes through.
///
/// # Errors
/// Too little memory for a state.
#[inline(never)]
pub(super) fn refusal(
    constants: &Constants,
    arrays: &ModelArrays,
    state: &mut StateMemory,
) -> Result<Option<Real>, ModelError> {
    let model = Model::view(constants, arrays.nodes, arrays.cells, arrays.hoops);
    let mut state = State::new(&model, state.lend())?;
    let steps = constants.steps_in(constants.scenario.time.duration).min(MAX_STEPS as u64);
    let unexplained = LEFT_UNEXPLAINED * state.scalars.energy.external;
    for _ in 0..steps {
        match advance_once(InstructionSet::best(), &model, &mut state, &StepInput::default()) {
            Ok(()) if math::abs(state.scalars.energy.residual()) > unexplained => return Ok(Some(0.5 * constants.dt)),
            Ok(()) => {}
            Err(StepError::Unstable { limit, .. }) => return Ok(Some(limit)),
            Err(StepError::Inverted { .. }) => return Ok(Some(0.5 * constants.dt)),
            Err(_) => break,
        }
    }
    Ok(None)
}

/// Largest step that is stable at rest, s, of the model in `arrays`.
pub(super) fn limit_at_rest(constants: &Constants, arrays: &ModelArrays) -> Real {
    if !constants.grid.is_solid() {
        return Cells::new(constants, arrays).limit_at_rest();
    }
    let nodes = arrays.nodes.get(..constants.size.model_nodes).unwrap_or_default();
    let model = Model::view(constants, nodes, arrays.cells, arrays.hoops);
    SolidCells::at_rest(&model).limit()
}

/// A trial on its way.
struct Trial<'c> {
    constants: &'c mut Constants,
    /// Smallest limit so far, s.
    smallest: Real,
    /// Smallest principal stretch of the cell that had it.
    stretch: Real,
}

impl Trial<'_> {
    fn model<'m>(&'m self, arrays: &'m ModelArrays) -> Model<'m> {
        Model::view(self.constants, arrays.nodes, arrays.cells, arrays.hoops)
    }

    /// From the touch to the end of the motion, or until the limit is below `enough`, s.
    ///
    /// # Errors
    /// Too little memory for a state.
    fn march_through(
        &mut self,
        motion: &TrialMotion,
        enough: Real,
        arrays: &ModelArrays,
        state: &mut StateMemory,
    ) -> Result<(), ModelError> {
        let (mut time, mut steps, mut turned) = (0.0, 0, false);
        // To a foam the touch is a blow: the first looks come at once.
        let stiffens = self.constants.has_foam();
        let mut most = if stiffens { 1.0 } else { MAX_STRIDE };
        while steps < MAX_STEPS {
            let model = self.model(arrays);
            let mut view = State::view(&model, state.lend())?;
            let stride = stride(&model, &view, most);
            let stopped = march(&model, &mut view, motion, stride, &mut time);
            steps += stride;
            let rises = view.scalars.impactor.velocity_half >= 0.0;
            let falls_anew = turned && !rises;
            turned |= rises;
            let comes_back = rises
                && matches!(motion, TrialMotion::Drop { .. })
                && (self.constants.has_foam() || self.constants.grid.is_solid())
                && view.scalars.impactor.deformation() > 0.0;
            let ended = falls_anew || (motion.has_ended(self.constants, &view, time) && !comes_back);
            let before = self.smallest;
            self.look(arrays, state, stopped);
            if stiffens {
                most = next_most(stride as Real, 1.0 - self.smallest / before);
            }
            if ended || stopped.is_some_and(|error| matches!(error, StepError::Inverted { .. })) {
                break;
            }
            if self.smallest < enough {
                break;
            }
        }
        Ok(())
    }

    /// The cell whose limit is the smallest, if it is below the smallest so far.
    fn critical(&self, arrays: &ModelArrays, state: &mut StateMemory) -> Option<Critical> {
        let bound = self.smallest * self.smallest;
        if self.constants.grid.is_solid() {
            let model = self.model(arrays);
            let view = State::view(&model, state.lend()).ok()?;
            return SolidCells::of(&model, &view).critical(InstructionSet::best(), bound);
        }
        Cells::new(self.constants, arrays).critical(InstructionSet::best(), &|block| state.cells.get(block), bound)
    }

    /// Looks at all cells, and at what the monitor may have found; goes on with a smaller step where the limit has fallen.
    fn look(&mut self, arrays: &ModelArrays, state: &mut StateMemory, stopped: Option<StepError>) {
        let found = self.critical(arrays, state);
        if let Some(Critical { limit_squared, stretch, .. }) = found {
            (self.smallest, self.stretch) = (math::sqrt(limit_squared), stretch);
        }
        let step = FOLLOWED * self.smallest;
        if step < self.constants.dt || stopped.is_some() {
            self.constants.set_step(step, 1);
        }
    }
}

/// Steps to the next look, and no more than `most`.
fn stride(model: &Model, state: &State, most: Real) -> usize {
    let travel = math::abs(state.scalars.impactor.velocity_half) * model.constants.dt;
    let way = TRAVEL * model.constants.scenario.thickness();
    // A quotient of any size or none ends in range.
    if way >= most * travel { most as usize } else { 1 + (way / travel) as usize }
}

/// Most steps to the next look, where the limit fell by the part `fall` of it in a `stride`.
fn next_most(stride: Real, fall: Real) -> Real {
    let wanted = if fall > FALL { stride * FALL / fall } else { 2.0 * stride };
    math::max(1.0, if wanted < MAX_STRIDE { wanted } else { MAX_STRIDE })
}

/// Makes some steps; gives the error that stops them.
fn march(model: &Model, state: &mut State, motion: &TrialMotion, steps: usize, time: &mut Real) -> Option<StepError> {
    for _ in 0..steps {
        *time += model.constants.dt;
        let driven_position = Some(motion.position(*time));
        let input = StepInput { driven_position, ..StepInput::default() };
        if let Err(error) = advance_once(InstructionSet::best(), model, state, &input) {
            return Some(error);
        }
    }
    None
}

/// How the impactor moves in a trial.
pub(crate) enum TrialMotion {
    /// Falls from the surface with this speed, m/s.
    Drop { speed: Real },
    /// Is pressed to this depth, m, at this speed, m/s.
    Press { depth: Real, speed: Real },
}

impl TrialMotion {
    fn new(scenario: &Scenario) -> Self {
        let (impactor, thickness) = (&scenario.impactor, scenario.thickness());
        let gaps = scenario.height() - thickness;
        let depth = match impactor.motion {
            Motion::Drop => return Self::Drop { speed: touching_speed(impactor) },
            Motion::Driven => scenario.time.design_compression * thickness + gaps,
            Motion::Prescribed => impactor.prescribed_depth,
        };
        let deepest = DEEPEST * thickness + gaps;
        let depth = if depth < deepest { depth } else { deepest };
        let slowest = scenario.layers.iter().map(|layer| &layer.material).fold(Real::MAX, |slowest, material| {
            let waves = math::sqrt(material.shear_modulus_inf() / material.density);
            if waves < slowest { waves } else { slowest }
        });
        Self::Press { depth, speed: PRESS_SPEED * slowest }
    }

    /// Height of a pressing face `time` s after its start, m.
    fn position(&self, time: Real) -> Real {
        match *self {
            Self::Drop { .. } => 0.0,
            Self::Press { depth, speed } if speed * time < depth => -(speed * time),
            Self::Press { depth, .. } => -depth,
        }
    }

    /// Whether the mass has turned, or passed the layer without a touch; or whether the face is at its depth.
    fn has_ended(&self, constants: &Constants, state: &State, time: Real) -> bool {
        let impactor = &state.scalars.impactor;
        match *self {
            Self::Drop { .. } => impactor.velocity_half >= 0.0 || impactor.deformation() > constants.scenario.height(),
            Self::Press { depth, speed } => speed * time >= depth,
        }
    }
}

/// Speed of a falling mass where it meets the undeformed surface, m/s.
fn touching_speed(impactor: &Impactor) -> Real {
    let start = impactor.start_speed();
    math::sqrt(start * start + 2.0 * impactor.gravity * impactor.gap)
}
