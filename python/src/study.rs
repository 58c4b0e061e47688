//! Many drops at once.

use std::sync::atomic::{AtomicBool, Ordering};

use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::{PyKeyboardInterrupt, PyRuntimeError};
use pyo3::prelude::*;
use rayon::prelude::*;
use softanvil_kernel::{OUTPUTS, Output, Parameter, ScenarioError};
use softanvil_tools::output::subject::Subject;
use softanvil_tools::run::{Drop, RunError};

use crate::error::{self, OrRaise};
use crate::interrupt::interruptible;
use crate::run::{Recording, Run, Unfinished, simulate, value};
use crate::settings::Settings;

/// Runs `work` on so many threads, one per core for 0.
fn on_threads<T: Send>(threads: usize, work: impl FnOnce() -> T + Send) -> PyResult<T> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.map(|pool| pool.install(work)).map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

/// Simulates the drops of `scenarios` on so many `threads`, one per core for 0. What fails is an exception in its place.
#[pyfunction]
pub fn run_many(py: Python<'_>, scenarios: Vec<Settings>, threads: usize) -> PyResult<Vec<Py<PyAny>>> {
    let subjects: Vec<_> = scenarios.iter().map(Settings::subject).collect();
    let recording = Recording { frames: None, impacts: 1, rest: 60.0 };
    let runs = interruptible(py, |stop| {
        on_threads(threads, || {
            let drops = scenarios.par_iter().zip(subjects).with_max_len(1);
            drops
                .map(|(settings, subject)| Ok::<_, ScenarioError>(simulate(settings, &subject?, recording, stop)))
                .collect::<Vec<_>>()
        })
    })??;
    let given = |run: Result<Result<Run, Unfinished>, ScenarioError>| match run.or_raise(py) {
        Ok(Ok(run)) => Ok(Py::new(py, run)?.into_any()),
        Ok(Err(Unfinished::Stopped)) => Err(PyKeyboardInterrupt::new_err(())),
        Ok(Err(Unfinished::Error(error))) => {
            Ok(Err::<(), RunError>(error).or_raise(py).unwrap_err().into_value(py).into_any())
        }
        Err(error) => Ok(error.into_value(py).into_any()),
    };
    runs.into_iter().map(given).collect()
}

/// What became of a row: its results, whether they are final, and the hash of its trace; or why there is nothing.
type Outcome = Result<(Vec<f64>, String, String), String>;

/// Columns of what became of rows.
type Columns<'py> = (Vec<&'static str>, Vec<Bound<'py, PyArray1<f64>>>, Vec<String>, Vec<String>, Vec<String>);

/// The measured numbers of a drop.
fn results() -> impl Iterator<Item = &'static Output> {
    OUTPUTS.iter().filter(|output| output.name.starts_with("result.") && output.name != "result.complete")
}

/// Simulates `base` with the `rows` of values of the parameters called `names`, on so many threads. Gives names and columns of
/// the results, endings, hashes and errors; a row that is refused or fails has an error and no numbers.
#[pyfunction]
pub fn run_rows<'py>(
    py: Python<'py>,
    base: &Settings,
    names: Vec<String>,
    rows: Vec<Vec<Bound<'py, PyAny>>>,
    threads: usize,
) -> PyResult<Columns<'py>> {
    let find = |name: &String| base.find(name).map_err(|reason| error::scenario(py, reason));
    let parameters = names.iter().map(find).collect::<PyResult<Vec<_>>>()?;
    let subjects: Vec<_> = rows.iter().map(|row| of_row(base, &parameters, row)).collect();
    let outcomes = interruptible(py, |stop| {
        on_threads(threads, || {
            subjects.into_par_iter().with_max_len(1).map(|subject| outcome(subject, stop)).collect::<Option<Vec<_>>>()
        })
    })??;
    let outcomes = outcomes.ok_or_else(|| PyKeyboardInterrupt::new_err(()))?;
    let number = |place: usize| {
        let of = |outcome: &Outcome| outcome.as_ref().map_or(f64::NAN, |(values, ..)| values[place]);
        outcomes.iter().map(of).collect::<Vec<_>>().into_pyarray(py)
    };
    let keys: Vec<_> = results().map(|output| output.name).collect();
    let columns = (0..keys.len()).map(number).collect();
    let text = |of: fn(&Outcome) -> &str| outcomes.iter().map(|outcome| of(outcome).to_string()).collect();
    Ok((
        keys,
        columns,
        text(|outcome| outcome.as_ref().map_or("failed", |(_, ending, _)| ending)),
        text(|outcome| outcome.as_ref().map_or("", |(.., hash)| hash)),
        text(|outcome| outcome.as_ref().err().map_or("", |error| error)),
    ))
}

/// The drop of one row of values; a value of none is not given.
fn of_row(base: &Settings, parameters: &[Parameter], row: &[Bound<'_, PyAny>]) -> Result<Subject, String> {
    let mut settings = base.clone();
    for (parameter, value) in parameters.iter().zip(row).filter(|(_, value)| !value.is_none()) {
        let number = settings.number(parameter, value).map_err(|error| error.value(value.py()).to_string())?;
        let dropped = settings.give(*parameter, number).map_err(|error| error.to_string())?;
        if let Some(other) = dropped.iter().find(|other| parameters.contains(other)) {
            let names = [other.name(), parameter.name()];
            return Err(format!("{} and {} state the same thing: expected one of them", names[0], names[1]));
        }
    }
    settings.subject().map_err(|error| error.to_string())
}

/// Simulates; nothing if it is no longer wanted.
fn outcome(subject: Result<Subject, String>, stop: &AtomicBool) -> Option<Outcome> {
    let run = subject.and_then(|subject| {
        let drop = Drop::until(&subject.scenario, subject.until).map_err(|error| error.to_string())?;
        drop.run_while(|_| !stop.load(Ordering::Relaxed)).map_err(|error| error.to_string())
    });
    match run {
        Ok(None) => None,
        Ok(Some(run)) => {
            let values = results().map(|output| value(&run, output)).collect();
            Some(Ok((values, run.ending().key().into(), run.trace_hash())))
        }
        Err(error) => Some(Err(error)),
    }
}
