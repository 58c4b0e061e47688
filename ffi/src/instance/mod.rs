//! [`Instance`]: one simulation as an FMI master sees it, whatever the version of the standard.
//!
//! A call that is refused changes nothing. The only exception is a step that the kernel cannot complete: it leads to
//! [`Mode::Failed`], from which the instance can be reset or restored.

mod clock;
mod error;
mod impact;
mod mode;
mod saved;
mod stepping;
mod values;

use core::fmt::{self, Display};

use softanvil_kernel::parameter::Values;
use softanvil_kernel::{Changes, MemoryError, ModelError, Parameter, ParameterError, Simulation, preset};

use crate::variables::{Inputs, Table, Version, profile, same_bits};

use clock::Clock;
pub use error::Error;
use impact::Impact;
pub use mode::{Function, Mode};
pub use saved::SavedState;
pub use stepping::{Advance, Pause};
pub use values::HASH_DIGITS;

/// Start and end of the experiment in the master's time.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Experiment {
    /// Time at the start of the drop, s.
    start: f64,
    /// Time past which no step may lead, s.
    stop: Option<f64>,
}

/// A model in one line.
pub struct Summary<'a>(Option<&'a Simulation>);

impl Display for Summary<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(model) = self.0.map(Simulation::constants) else { return Ok(()) };
        write!(f, "model of {} elements, time step {} s", model.grid.n_elem(), model.dt)
    }
}

/// One simulation as a master sees it.
pub struct Instance {
    table: Table,
    version: Version,
    /// Whether the master handles events; FMI 3.0 alone has them.
    event_mode_used: bool,
    mode: Mode,
    /// Points of the profiles.
    points: u64,
    /// The parameters, as the master has set them.
    values: Values,
    inputs: Inputs,
    experiment: Experiment,
    clock: Clock,
    impact: Impact,
    /// The model that was built last, which may be older than the scenario until the drop starts.
    simulation: Option<Simulation>,
    /// Whether that is at the start of a drop on a fresh anvil.
    is_fresh: bool,
}

impl Instance {
    /// A new instance of the preset.
    pub fn new(version: Version) -> Self {
        Self {
            table: Table::new(),
            version,
            event_mode_used: false,
            points: profile::START_POINTS,
            mode: Mode::Instantiated,
            values: Values::of(&preset::study()),
            inputs: Inputs::start(),
            experiment: Experiment { start: 0.0, stop: None },
            clock: Clock::at(0.0),
            impact: Impact::first(0.0),
            simulation: None,
            is_fresh: false,
        }
    }

    /// Refuses `function` where the standard does not allow it.
    ///
    /// # Errors
    /// The function and the mode in which it was called.
    pub fn check_call(&self, function: &Function) -> Result<(), Error> {
        if function.legal & self.mode as u8 != 0 { Ok(()) } else { Err(Error::Call { mode: self.mode }) }
    }

    /// Sets start and end of the experiment, s.
    ///
    /// # Errors
    /// Times that are not finite, or an end before the start.
    pub fn setup(&mut self, start: f64, stop: Option<f64>) -> Result<(), Error> {
        if !start.is_finite() {
            return Err(Error::StartTime { start });
        }
        if let Some(stop) = stop
            && !(stop.is_finite() && stop >= start)
        {
            return Err(Error::StopTime { stop, start });
        }
        self.experiment = Experiment { start, stop };
        self.clock = Clock::at(start);
        self.impact = Impact::first(start);
        Ok(())
    }

    /// The same for a master that handles events: steps tell of them, and event mode is legal.
    pub fn with_events(self) -> Self {
        Self { event_mode_used: true, ..self }
    }

    /// Whether the master handles events.
    pub fn event_mode_used(&self) -> bool {
        self.event_mode_used
    }

    /// From or to event or configuration mode.
    ///
    /// # Errors
    /// Event mode in an instance whose master does not handle events.
    pub fn enter(&mut self, mode: Mode) -> Result<(), Error> {
        if mode == Mode::Event && !self.event_mode_used {
            return Err(Error::Unsupported { what: "event mode without eventModeUsed at instantiation" });
        }
        self.mode = mode;
        Ok(())
    }

    /// Begins or ends a look of the master at an intermediate state.
    pub fn set_intermediate_update(&mut self, looks: bool) {
        self.mode = if looks { Mode::IntermediateUpdate } else { Mode::Step };
    }

    /// Begins initialization. The scenario may still change, so nothing is built yet.
    pub fn enter_initialization(&mut self) {
        self.mode = Mode::Initialization;
    }

    /// Builds the model and gets ready for the first step. Gives what was changed of the preset, because some of it may have
    /// no effect: a master that sets every start value sets those of other choices, too.
    ///
    /// # Errors
    /// A scenario that cannot be simulated; it can be corrected.
    pub fn exit_initialization(&mut self) -> Result<Changes, Error> {
        let changes = self.changes()?;
        let scenario = self.prepare()?.constants().scenario.clone();
        self.values.update(&scenario);
        self.mode = if self.event_mode_used { Mode::Event } else { Mode::Step };
        Ok(changes)
    }

    /// The parameters, as the master has set them and as they follow from each other.
    pub fn values(&self) -> &Values {
        &self.values
    }

    fn changes(&self) -> Result<Changes, ParameterError> {
        let mut changes = Changes::of(&preset::study());
        Parameter::all().try_for_each(|parameter| changes.set_if_other(parameter, self.values.get(parameter)))?;
        Ok(changes)
    }

    /// Ends the simulation; its results stay readable.
    pub fn terminate(&mut self) {
        self.mode = Mode::Terminated;
    }

    /// Back to a new instance. The model is kept, in case the next run wants the same one.
    pub fn reset(&mut self) {
        let (simulation, is_fresh) = (self.simulation.take(), self.is_fresh);
        *self = Self { simulation, is_fresh, event_mode_used: self.event_mode_used, ..Self::new(self.version) };
    }

    /// The version of the standard that the master speaks.
    pub fn version(&self) -> Version {
        self.version
    }

    /// Whether the last step could not be completed.
    pub fn has_failed(&self) -> bool {
        self.mode == Mode::Failed
    }

    /// Whether the impactor has touched the layer and is not clear of it, so that the results are those so far.
    pub fn is_cut_off(&self) -> bool {
        let scalars = self.simulation.as_ref().map(Simulation::scalars);
        scalars.is_some_and(|scalars| scalars.metrics.has_touched() && !scalars.contact_has_ended())
    }

    /// The model in one line, for the log.
    pub fn summary(&self) -> Summary<'_> {
        Summary(self.simulation.as_ref())
    }

    /// The simulation at the start of the current scenario's drop.
    #[inline(never)]
    fn prepare(&mut self) -> Result<&mut Simulation, Error> {
        let scenario = self.changes()?.resolve().map_err(ModelError::Scenario).map_err(Error::Model)?;
        let kept = self.simulation.take().filter(|kept| same_bits(&kept.constants().scenario, &scenario));
        let simulation = match kept {
            Some(mut kept) => {
                if !self.is_fresh {
                    kept.reset().map_err(memory)?;
                }
                kept
            }
            None => Simulation::new(&scenario).map_err(Error::Model)?,
        };
        self.is_fresh = true;
        Ok(self.simulation.insert(simulation))
    }
}

/// Too little memory for model or state.
fn memory(error: MemoryError) -> Error {
    Error::Model(ModelError::Memory(error))
}

#[cfg(test)]
mod tests;
