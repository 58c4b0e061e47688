//! A model and its state in memory of their own, for hosts that can allocate (feature `alloc`).

use alloc::vec::Vec;

use crate::element::{CellConstants, CellHistory, HoopConstants};
use crate::error::{MemoryError, ModelError, SnapshotError, StepError};
use crate::impactor::StepInput;
use crate::model::{Constants, Model, ModelMemory, Size};
use crate::number::real::Real;
use crate::result::Output;
use crate::scenario::Scenario;
use crate::scenario::parameter::Parameter;
use crate::state::{Scalars, State, StateContent, StateMemory, StateView, restore, save, snapshot_size};
use crate::step::steps;
use crate::tensor::deviator::Deviator;

/// An owned simulation. A clone goes on by itself.
///
/// ```
/// use softanvil_kernel::{Simulation, StepInput, preset};
///
/// let mut simulation = Simulation::new(&preset::study())?;
/// simulation.run(4e-3, &StepInput::default())?;
/// let saved = simulation.save()?;
/// simulation.run(1e-3, &StepInput::default())?;
/// let force = simulation.output("contact.force");
/// simulation.restore(&saved)?;
/// simulation.run(1e-3, &StepInput::default())?;
/// assert_eq!(simulation.output("contact.force"), force);
/// # Ok::<(), Box<dyn core::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Simulation {
    constants: Constants,
    scalars: Scalars,
    model_nodes: Vec<Real>,
    model_cells: Vec<CellConstants>,
    model_hoops: Vec<HoopConstants>,
    state_nodes: Vec<Real>,
    state_cells: Vec<CellHistory>,
    state_viscous: Vec<Deviator>,
}

impl Simulation {
    /// Allocates and builds the model of `scenario`, at the start of its drop.
    ///
    /// # Errors
    /// A refused scenario, or no memory; see [`ModelError`].
    pub fn new(scenario: &Scenario) -> Result<Self, ModelError> {
        Self::build(scenario, |memory, state| Model::new(scenario, memory, state))
    }

    /// The same with nodes that rest at `position(u, v)`, m; see [`Model::with_positions`].
    ///
    /// # Errors
    /// As [`Simulation::new`], and a cell without area.
    pub fn with_positions(
        scenario: &Scenario,
        position: &dyn Fn(usize, usize) -> [Real; 2],
    ) -> Result<Self, ModelError> {
        Self::build(scenario, |memory, state| Model::with_positions(scenario, position, memory, state))
    }

    /// The same of a solid with nodes that rest at `position([u, v, w])`, m; see [`Model::with_node_positions`].
    ///
    /// # Errors
    /// As [`Simulation::new`], and a tetrahedron without volume.
    pub fn with_node_positions(
        scenario: &Scenario,
        position: &dyn Fn([usize; 3]) -> [Real; 3],
    ) -> Result<Self, ModelError> {
        Self::build(scenario, |memory, state| Model::with_node_positions(scenario, position, memory, state))
    }

    fn build(
        scenario: &Scenario,
        model: impl for<'m> FnOnce(ModelMemory<'m>, &mut StateMemory) -> Result<Model<'m>, ModelError>,
    ) -> Result<Self, ModelError> {
        let size = Size::of(scenario)?;
        let mut model_nodes = filled(0.0, size.model_nodes, "model nodes")?;
        let mut model_cells = filled(CellConstants::ZERO, size.model_cells, "model cells")?;
        let mut model_hoops = filled(HoopConstants::ZERO, size.model_hoops, "model hoops")?;
        let mut state_nodes = filled(0.0, size.state_nodes, "state nodes")?;
        let mut state_cells = filled(CellHistory::REST, size.state_cells, "state cells")?;
        let mut state_viscous = filled(Deviator::ZERO, size.state_viscous, "state viscous history")?;
        let (mut constants, mut scalars) = (None, Scalars::BLANK);
        let (nodes, cells, viscous) = (&mut state_nodes, &mut state_cells, &mut state_viscous);
        let mut state = StateMemory { scalars: &mut scalars, nodes, cells, viscous };
        let (nodes, cells, hoops) = (&mut model_nodes, &mut model_cells, &mut model_hoops);
        let model = model(ModelMemory { constants: &mut constants, nodes, cells, hoops }, &mut state)?;
        State::new(&model, state)?;
        let constants = model.constants.clone();
        Ok(Self { constants, scalars, model_nodes, model_cells, model_hoops, state_nodes, state_cells, state_viscous })
    }

    /// The scalar constants of the model.
    pub fn constants(&self) -> &Constants {
        &self.constants
    }

    /// The numbers of the state that are not arrays.
    pub fn scalars(&self) -> &Scalars {
        &self.scalars
    }

    /// Simulated time, s.
    pub fn time(&self) -> Real {
        self.constants.time(self.scalars.step_index)
    }

    /// Runs `work` on model and state.
    ///
    /// # Errors
    /// Never in practice: the memory was sized for this model.
    #[inline(always)]
    pub fn with<R>(&mut self, work: impl FnOnce(&Model, &mut State) -> R) -> Result<R, MemoryError> {
        let model = Model::view(&self.constants, &self.model_nodes, &self.model_cells, &self.model_hoops);
        let memory = StateMemory {
            scalars: &mut self.scalars,
            nodes: &mut self.state_nodes,
            cells: &mut self.state_cells,
            viscous: &mut self.state_viscous,
        };
        Ok(work(&model, &mut State::view(&model, memory)?))
    }

    /// Runs `work` on model and state, which are only read, as many may do at the same time.
    ///
    /// ```
    /// use softanvil_kernel::{Simulation, preset};
    ///
    /// let anvil = Simulation::new(&preset::study())?;
    /// let at_rest = anvil.read(|_, state| state.displacement().iter().all(|component| component.iter().all(|u| *u == 0.0)))?;
    /// assert!(at_rest);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Simulation::with`].
    pub fn read<R>(&self, work: impl for<'a> FnOnce(&Model<'a>, &StateView<'a>) -> R) -> Result<R, MemoryError> {
        let model = Model::view(&self.constants, &self.model_nodes, &self.model_cells, &self.model_hoops);
        let content = StateContent { nodes: &self.state_nodes, cells: &self.state_cells, viscous: &self.state_viscous };
        let state = StateView::new(&model, &self.scalars, content)?;
        Ok(work(&model, &state))
    }

    /// Makes `n` steps. The external force is held; a driven face is where the input says, and moves as it says, at the end of
    /// the last of them.
    ///
    /// # Errors
    /// As [`steps`]; the steps before a failure stay done.
    pub fn step(&mut self, n: u64, input: &StepInput) -> Result<(), StepError> {
        self.with(|model, state| steps(model, state, n, input))?
    }

    /// Makes the steps that cover `duration` s, rounded up to whole sampling intervals of 50 us; see [`Simulation::step`].
    ///
    /// # Errors
    /// As [`Simulation::step`], and a duration that is no legal `time.duration`.
    pub fn run(&mut self, duration: Real, input: &StepInput) -> Result<(), StepError> {
        let time = self.time();
        let legal = Parameter::find("time.duration").map_or(Ok(()), |parameter| parameter.check(duration));
        legal.map_err(|error| StepError::Input { error, time })?;
        self.step(self.constants.steps_in(duration), input)
    }

    /// The output called `name`, in the unit of its row in [`crate::OUTPUTS`]; none if there is none of this name.
    pub fn output(&self, name: &str) -> Option<Real> {
        Output::find(name).map(|output| (output.read)(&self.constants, &self.scalars))
    }

    /// The state as a snapshot, which [`Simulation::restore`] takes on any target.
    ///
    /// # Errors
    /// A state that has failed, or no memory.
    pub fn save(&mut self) -> Result<Vec<u8>, SnapshotError> {
        let mut bytes = filled(0, snapshot_size(&self.constants), "snapshot")?;
        self.with(|model, state| save(model, state, &mut bytes))??;
        Ok(bytes)
    }

    /// Goes on from a snapshot of the same model.
    ///
    /// # Errors
    /// Bytes that are no such snapshot; nothing changes then.
    pub fn restore(&mut self, bytes: &[u8]) -> Result<(), SnapshotError> {
        self.with(|model, state| restore(model, state, bytes))?
    }

    /// Lets the anvil rest for `rest` s and the impactor fall again on it, as it is; see [`State::next_impact`].
    ///
    /// ```
    /// use softanvil_kernel::material::Hyperfoam;
    /// use softanvil_kernel::{Simulation, StepInput, preset};
    ///
    /// let mut scenario = preset::elastic();
    /// let foam = &mut scenario.layers[0].material;
    /// *foam = foam.with(Hyperfoam::new([1e6, 0.0, 0.0], [4.0, 1.0, 1.0], [0.2, 0.0, 0.0]));
    /// (foam.softening_r, foam.softening_m) = (1.5, 2e4);
    /// let mut anvil = Simulation::new(&scenario)?;
    /// anvil.run(scenario.time.duration, &StepInput::default())?;
    /// let first = anvil.scalars().metrics;
    /// anvil.next_impact(60.0)?;
    /// anvil.run(scenario.time.duration, &StepInput::default())?;
    /// assert!(anvil.scalars().metrics.max_deformation > first.max_deformation);
    /// # Ok::<(), Box<dyn core::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`State::next_impact`].
    pub fn next_impact(&mut self, rest: Real) -> Result<(), StepError> {
        self.with(|model, state| state.next_impact(model, rest))?
    }

    /// Back to the start of the drop.
    ///
    /// # Errors
    /// As [`Simulation::with`].
    pub fn reset(&mut self) -> Result<(), MemoryError> {
        self.with(|model, state| state.reset(model))
    }
}

/// `n` copies of `value`.
///
/// # Errors
/// The heap has no room for them.
fn filled<T: Copy>(value: T, n: usize, what: &'static str) -> Result<Vec<T>, MemoryError> {
    let mut items = Vec::new();
    items.try_reserve_exact(n).map_err(|_| MemoryError { what, given: 0, needed: n })?;
    items.resize(n, value);
    Ok(items)
}

#[cfg(all(test, not(feature = "single")))]
mod tests {
    use super::*;
    use crate::scenario::preset;

    fn after(duration: Real) -> Simulation {
        let mut simulation = Simulation::new(&preset::study()).unwrap();
        simulation.run(duration, &StepInput::default()).unwrap();
        simulation
    }

    #[test]
    fn a_clone_and_a_restored_one_go_on_with_the_same_bits() {
        let input = StepInput::default();
        let (whole, mut half) = (after(6e-3), after(3e-3));
        let saved = half.save().unwrap();
        let mut clone = half.clone();
        half.step(1000, &input).unwrap();
        clone.run(3e-3, &input).unwrap();
        assert_eq!(clone.scalars(), whole.scalars());
        half.restore(&saved).unwrap();
        half.run(3e-3, &input).unwrap();
        assert_eq!(half.scalars(), whole.scalars());
    }

    #[test]
    fn outputs_go_by_name_and_durations_are_checked() {
        let mut simulation = after(3e-3);
        assert_eq!(simulation.output("result.peak_force"), Some(simulation.scalars().metrics.peak_force));
        assert_eq!(simulation.output("result.peak"), None);
        let before = *simulation.scalars();
        for duration in [f64::NAN, f64::INFINITY, -1.0, 0.0, 101.0] {
            assert!(matches!(simulation.run(duration, &StepInput::default()), Err(StepError::Input { .. })));
        }
        assert_eq!(*simulation.scalars(), before);
        assert!(matches!(simulation.restore(&[0; 8]), Err(SnapshotError::Length { .. })));
        assert_eq!(*simulation.scalars(), before);
    }

    /// Also of another length, as those of other versions are.
    #[test]
    fn a_snapshot_of_another_version_is_refused_by_its_number() {
        let mut simulation = after(3e-3);
        let before = *simulation.scalars();
        let mut saved = simulation.save().unwrap();
        let current = u64::from(saved[8]);
        saved[8] -= 1;
        for length in [saved.len(), saved.len() - 8, 16] {
            let other = SnapshotError::Version { given: current - 1, expected: current };
            assert_eq!(simulation.restore(&saved[..length]), Err(other));
        }
        assert_eq!(*simulation.scalars(), before);
    }
}
