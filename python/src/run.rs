//! One drop, from the start to its end.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{IntoPyArray, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use softanvil_kernel::{OUTPUTS, Output, Simulation};
use softanvil_tools::output::subject::{self, Subject};
use softanvil_tools::output::trace;
use softanvil_tools::run::{Drop, Ending, Run as Recorded, RunError};

use crate::error::OrRaise;
use crate::field::StateView;
use crate::interrupt::interruptible;
use crate::settings::Settings;

/// How a drop is recorded.
#[derive(Clone, Copy)]
pub struct Recording {
    /// Samples of 50 us from one frame to the next; none for no frames.
    pub frames: Option<usize>,
    /// Impacts on the same anvil.
    pub impacts: u32,
    /// Time between two of them, s.
    pub rest: f64,
}

/// A drop that was simulated.
#[pyclass(module = "softanvil._softanvil", frozen)]
pub struct Run {
    run: Recorded,
    earlier: Vec<Recorded>,
    end: Arc<Simulation>,
    frames: Vec<Arc<Simulation>>,
    settings: Settings,
}

/// Why a drop gave nothing.
pub enum Unfinished {
    /// It failed or was refused.
    Error(RunError),
    /// It is no longer wanted.
    Stopped,
}

impl From<RunError> for Unfinished {
    fn from(error: RunError) -> Self {
        Self::Error(error)
    }
}

/// Simulates the drop of `subject`, which `settings` made, until it is over or `stop`.
///
/// # Errors
/// A scenario that is refused, a step that fails, or that it was stopped.
pub fn simulate(
    settings: &Settings,
    subject: &Subject,
    recording: Recording,
    stop: &AtomicBool,
) -> Result<Run, Unfinished> {
    let drop = Drop::until(&subject.scenario, subject.until)?;
    let (mut frames, mut sample) = (Vec::new(), 0);
    let watch = |steps, simulation: &mut Simulation| {
        if steps == 0 {
            // The frames are those of the last impact.
            (frames, sample) = (Vec::new(), 0);
        }
        if recording.frames.is_some_and(|every| sample % every == 0) {
            frames.push(Arc::new(simulation.clone()));
        }
        sample += 1;
        if stop.load(Ordering::Relaxed) { Err(Unfinished::Stopped) } else { Ok(()) }
    };
    let (earlier, run, end) = drop.run_impacts(recording.impacts, recording.rest, watch)?;
    Ok(Run { run, earlier, end: Arc::new(end), frames, settings: settings.clone() })
}

/// Simulates the drop of `settings`, with `frames`, so many samples of 50 us apart.
#[pyfunction]
pub fn run(py: Python<'_>, settings: Settings, frames: Option<usize>, impacts: u32, rest: f64) -> PyResult<Run> {
    let subject = settings.subject().or_raise(py)?;
    let recording = Recording { frames, impacts, rest };
    match interruptible(py, |stop| simulate(&settings, &subject, recording, stop))? {
        Ok(run) => Ok(run),
        Err(Unfinished::Error(error)) => Err(error).or_raise(py),
        Err(Unfinished::Stopped) => Err(pyo3::exceptions::PyKeyboardInterrupt::new_err(())),
    }
}

/// Name, unit and, for every sample of a run, value of the outputs of a trace, (columns, samples); the first is the time.
type Trace<'py> = (Vec<&'static str>, Vec<&'static str>, Bound<'py, PyArray2<f64>>);

#[pymethods]
impl Run {
    /// The trace: names, units, and values (columns, samples).
    fn trace<'py>(&self, py: Python<'py>) -> PyResult<Trace<'py>> {
        let samples = self.run.samples();
        let mut values: Vec<f64> = samples.iter().map(|sample| self.run.time(sample)).collect();
        let (mut names, mut units) = (vec!["time"], vec!["s"]);
        for output in trace::columns() {
            values.extend(samples.iter().map(|sample| (output.read)(&self.run.constants, sample)));
            names.push(output.name);
            units.push(output.unit);
        }
        let shape = [names.len(), samples.len()];
        Ok((names, units, values.into_pyarray(py).reshape(shape)?))
    }

    /// Every output at the end, in SI, by its name.
    fn outputs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        outputs_of(py, &self.run)
    }

    /// The same of the impacts before the last.
    fn earlier<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        self.earlier.iter().map(|run| outputs_of(py, run)).collect()
    }

    /// What else there is to know of it.
    fn facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let (facts, ending, constants) = (PyDict::new(py), self.run.ending(), &self.run.constants);
        facts.set_item("ending", ending.key())?;
        facts.set_item("complete", ending == Ending::Complete)?;
        let cut: Vec<_> = OUTPUTS.iter().map(|output| output.name).filter(|name| ending.cuts(name)).collect();
        facts.set_item("cut", cut)?;
        facts.set_item("trace_hash", self.run.trace_hash())?;
        facts.set_item("steps", self.run.end().step_index)?;
        facts.set_item("time_step", constants.dt)?;
        facts.set_item("elements", constants.grid.n_elem())?;
        facts.set_item("warnings", subject::warnings(constants, self.run.end()))?;
        Ok(facts)
    }

    /// The state at the end.
    fn end(&self) -> StateView {
        StateView { state: Arc::clone(&self.end), settings: self.settings.clone() }
    }

    /// The states of the frames.
    fn frames(&self) -> Vec<StateView> {
        let view = |state: &Arc<Simulation>| StateView { state: Arc::clone(state), settings: self.settings.clone() };
        self.frames.iter().map(view).collect()
    }
}

/// An output at the end; no number of what an impact would have had that was none.
pub fn value(run: &Recorded, output: &Output) -> f64 {
    let absent = run.ending() == Ending::NoContact && output.name.starts_with("result.");
    if absent { f64::NAN } else { run.result(output) }
}

fn outputs_of<'py>(py: Python<'py>, run: &Recorded) -> PyResult<Bound<'py, PyDict>> {
    let outputs = PyDict::new(py);
    for output in OUTPUTS {
        outputs.set_item(output.name, value(run, output))?;
    }
    Ok(outputs)
}
