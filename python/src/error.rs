//! Errors as exceptions: the classes are those of `softanvil._errors`.

use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::PyType;
use softanvil_kernel::{MemoryError, ModelError, ParameterError, ScenarioError, SnapshotError, StepError};
use softanvil_tools::run::RunError;
use softanvil_tools::scenario_file::ScenarioFileError;

/// The exception of `class` with `arguments`.
fn raise<A>(py: Python<'_>, class: &str, arguments: A) -> PyErr
where
    A: pyo3::PyErrArguments + Send + Sync + 'static,
{
    static MODULE: PyOnceLock<Py<PyAny>> = PyOnceLock::new();
    let module = MODULE.get_or_try_init(py, || Ok::<_, PyErr>(py.import("softanvil._errors")?.into_any().unbind()));
    let found = module.and_then(|module| Ok(module.bind(py).getattr(class)?.cast_into::<PyType>()?));
    match found {
        Ok(class) => PyErr::from_type(class, arguments),
        Err(error) => error,
    }
}

/// A scenario, or what is given for one, that is refused.
pub fn scenario(py: Python<'_>, message: impl ToString) -> PyErr {
    raise(py, "ScenarioError", (message.to_string(),))
}

/// A simulation that failed.
pub fn simulation(py: Python<'_>, message: impl ToString) -> PyErr {
    raise(py, "SimulationError", (message.to_string(),))
}

/// A file that is refused, or cannot be written.
pub fn file(py: Python<'_>, message: impl ToString) -> PyErr {
    raise(py, "FileError", (message.to_string(),))
}

/// A value that is refused, by the parameter called `name`.
pub fn parameter(py: Python<'_>, error: &ParameterError) -> PyErr {
    let ParameterError { name, value, unit, min, max } = error;
    raise(py, "ParameterError", (error.to_string(), name.to_string(), *value, *unit, *min, *max))
}

/// A value of another kind than the parameter `name` takes; `value` as it was written.
pub fn kind(
    py: Python<'_>,
    message: String,
    name: String,
    value: Py<PyAny>,
    unit: &'static str,
    range: (f64, f64),
) -> PyErr {
    raise(py, "ParameterError", (message, name, value, unit, range.0, range.1))
}

/// A place that is not there.
pub fn index(message: String) -> PyErr {
    PyIndexError::new_err(message)
}

/// What a kernel's error is in Python.
pub trait IntoPython {
    /// The exception.
    fn into_python(self, py: Python<'_>) -> PyErr;
}

impl IntoPython for ScenarioError {
    fn into_python(self, py: Python<'_>) -> PyErr {
        match &self {
            Self::Parameter(error) => parameter(py, error),
            _ => scenario(py, self),
        }
    }
}

impl IntoPython for ScenarioFileError {
    fn into_python(self, py: Python<'_>) -> PyErr {
        scenario(py, self)
    }
}

impl IntoPython for ModelError {
    fn into_python(self, py: Python<'_>) -> PyErr {
        match self {
            Self::Scenario(error) => error.into_python(py),
            _ => scenario(py, self),
        }
    }
}

impl IntoPython for StepError {
    fn into_python(self, py: Python<'_>) -> PyErr {
        match &self {
            Self::Input { error, .. } => parameter(py, error),
            _ => simulation(py, self),
        }
    }
}

impl IntoPython for RunError {
    fn into_python(self, py: Python<'_>) -> PyErr {
        match self {
            Self::Model(error) => error.into_python(py),
            Self::Step(error) => error.into_python(py),
            Self::Driven => scenario(py, self),
        }
    }
}

impl IntoPython for MemoryError {
    fn into_python(self, py: Python<'_>) -> PyErr {
        simulation(py, self)
    }
}

impl IntoPython for SnapshotError {
    fn into_python(self, py: Python<'_>) -> PyErr {
        simulation(py, self)
    }
}

/// The value of a result, or its exception.
pub trait OrRaise<T> {
    /// As `?` needs it.
    fn or_raise(self, py: Python<'_>) -> PyResult<T>;
}

impl<T, E: IntoPython> OrRaise<T> for Result<T, E> {
    fn or_raise(self, py: Python<'_>) -> PyResult<T> {
        self.map_err(|error| error.into_python(py))
    }
}
