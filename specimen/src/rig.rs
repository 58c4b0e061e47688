//! Memory of a simulation whose material may change its times on the way.

use softanvil_kernel::element::{CellConstants, CellHistory, HoopConstants};
use softanvil_kernel::scenario::StepBy;
use softanvil_kernel::tensor::deviator::Deviator;
use softanvil_kernel::{
    Model, ModelError, ModelMemory, SAMPLING_INTERVAL, Scalars, Scenario, Size, State, StateMemory, StepInput, step,
};

use crate::{Error, Recorder};

/// The state of a test between its parts.
pub(crate) struct Rig {
    nodes: Vec<f64>,
    cells: Vec<CellConstants>,
    hoops: Vec<HoopConstants>,
    state_nodes: Vec<f64>,
    state_cells: Vec<CellHistory>,
    viscous: Vec<Deviator>,
    /// None before the first part.
    scalars: Option<Scalars>,
    /// The step that was chosen for the first part, s.
    step: f64,
}

impl Rig {
    /// Memory for `scenario` and for the same with other relaxation times.
    pub(crate) fn new(scenario: &Scenario) -> Result<Self, Error> {
        let size = Size::of(scenario)?;
        Ok(Self {
            nodes: vec![0.0; size.model_nodes],
            cells: vec![CellConstants::ZERO; size.model_cells],
            hoops: vec![HoopConstants::ZERO; size.model_hoops],
            state_nodes: vec![0.0; size.state_nodes],
            state_cells: vec![CellHistory::REST; size.state_cells],
            viscous: vec![Deviator::ZERO; size.state_viscous],
            scalars: None,
            step: 0.0,
        })
    }

    /// Goes on for `duration` s with the constants of `scenario`, from where the last part ended.
    ///
    /// The relaxation times are no part of the stability limit, so every part goes on with the step of the first.
    pub(crate) fn run(&mut self, scenario: &Scenario, duration: f64, record: &mut Recorder) -> Result<(), Error> {
        let (nodes, cells, hoops) = (&mut self.nodes, &mut self.cells, &mut self.hoops);
        let mut constants = None;
        let memory = ModelMemory { constants: &mut constants, nodes, cells, hoops };
        let (nodes, cells, viscous) = (&mut self.state_nodes, &mut self.state_cells, &mut self.viscous);
        let begins = self.scalars.is_none();
        let mut scenario = scenario.clone();
        if !begins {
            (scenario.time.step_by, scenario.time.step) = (StepBy::Given, self.step);
        }
        let mut state = StateMemory { scalars: self.scalars.get_or_insert(Scalars::BLANK), nodes, cells, viscous };
        let model = Model::new(&scenario, memory, &mut state)?;
        self.step = model.constants.dt;
        let state = if begins { State::new(&model, state) } else { State::view(&model, state) };
        let mut state = state.map_err(ModelError::Memory)?;
        for _ in 0..(duration / SAMPLING_INTERVAL).ceil() as u64 {
            let before = state.scalars.impactor.deformation();
            for _ in 0..model.constants.steps_per_sample {
                step(&model, &mut state, &StepInput::default())?;
            }
            let after = state.scalars.impactor.deformation();
            record.take(state.scalars.sampler.last.contact_force, [before, after]);
        }
        Ok(())
    }
}
