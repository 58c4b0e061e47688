//! [`Run`]: a scene, stride by stride.

use core::fmt;

use softanvil_kernel::state::{restore, save, snapshot_size, state_digest};
use softanvil_kernel::{InstructionSet, Model, ModelError, SnapshotError, State, StepError, step_with};

use crate::memory::Memory;
use crate::record::Record;
use crate::scenes::{SAMPLES_PER_RECORD, Scene};

/// A scene on its way.
pub struct Run<'a> {
    scene: &'static Scene,
    /// The constants of the simulation.
    pub model: Model<'a>,
    /// The state that changes.
    pub state: State<'a>,
    /// What the steps are made with.
    pub instructions: InstructionSet,
}

/// Why a scene could not be simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// The scenario is refused.
    Model(ModelError),
    /// A step failed.
    Step(StepError),
    /// A snapshot is refused.
    Snapshot(SnapshotError),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Model(error) => error.fmt(f),
            Self::Step(error) => error.fmt(f),
            Self::Snapshot(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for Failure {}

impl<'a> Run<'a> {
    /// A scene at its start, in `memory`.
    ///
    /// # Errors
    /// A scenario that is refused, or more than the memory holds.
    pub fn new(scene: &'static Scene, memory: &'a mut Memory) -> Result<Self, Failure> {
        let (model, mut state) = memory.split();
        let model = Model::new(&(scene.scenario)(), model, &mut state).map_err(Failure::Model)?;
        let state = State::new(&model, state).map_err(|error| Failure::Model(error.into()))?;
        Ok(Self { scene, model, state, instructions: InstructionSet::best() })
    }

    /// Steps between records.
    pub fn stride(&self) -> u64 {
        SAMPLES_PER_RECORD * u64::from(self.model.constants.steps_per_sample)
    }

    /// Steps of the whole scene: its duration, in whole strides.
    pub fn steps(&self) -> u64 {
        let steps = self.model.constants.steps_in(self.model.constants.scenario.time.duration);
        steps.div_ceil(self.stride()) * self.stride()
    }

    /// The current record.
    pub fn record(&self) -> Record {
        let scalars = &self.state.scalars;
        Record {
            step: scalars.step_index,
            force: scalars.force.contact,
            position: scalars.impactor.position,
            state: state_digest(&self.model, &self.state),
        }
    }

    /// Makes one step.
    ///
    /// # Errors
    /// A step that fails.
    pub fn step(&mut self) -> Result<(), Failure> {
        let input = (self.scene.input)(self.model.constants, self.state.scalars.step_index);
        step_with(self.instructions, &self.model, &mut self.state, &input).map_err(Failure::Step)
    }

    /// Goes on to the next record; none at the end.
    ///
    /// # Errors
    /// A step that fails.
    pub fn advance(&mut self) -> Result<Option<Record>, Failure> {
        if self.state.scalars.step_index >= self.steps() {
            return Ok(None);
        }
        for _ in 0..self.stride() {
            self.step()?;
        }
        Ok(Some(self.record()))
    }

    /// Saves the state; returns the bytes that it takes.
    ///
    /// # Errors
    /// Too little room.
    pub fn save<'b>(&self, bytes: &'b mut [u8]) -> Result<&'b [u8], Failure> {
        let (given, needed) = (bytes.len(), snapshot_size(self.model.constants));
        let short = Failure::Snapshot(SnapshotError::Length { given, needed });
        let bytes = bytes.get_mut(..needed).ok_or(short)?;
        save(&self.model, &self.state, bytes).map_err(Failure::Snapshot)?;
        Ok(bytes)
    }

    /// Takes over a saved state.
    ///
    /// # Errors
    /// A snapshot that is refused.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        restore(&self.model, &mut self.state, bytes).map_err(Failure::Snapshot)
    }
}
