//! Measured traces.

use std::path::PathBuf;
use std::str::FromStr;

use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use softanvil_records::sheet::Layout;
use softanvil_records::trace::{self, Options, Trace};
use softanvil_tools::measurement::measured;

use crate::error;
use crate::settings::Settings;

/// Times, s, forces, N, the largest deformation, m, and how the file was read, as JSON.
type Record<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Option<f64>, String);

/// Reads a force over time from a file of whatever layout.
#[pyfunction]
#[pyo3(signature = (path, scenario=None, *, time=None, force_column=None, acceleration=None, displacement=None, mass=None,
                    rate=None, offset=None, sign=None, impact=None, sheet=None, decimal=None))]
#[expect(clippy::too_many_arguments, reason = "they are the options of the command line")]
pub fn read_trace<'py>(
    py: Python<'py>,
    path: PathBuf,
    scenario: Option<PyRef<Settings>>,
    time: Option<&str>,
    force_column: Option<&str>,
    acceleration: Option<&str>,
    displacement: Option<&str>,
    mass: Option<&str>,
    rate: Option<&str>,
    offset: Option<f64>,
    sign: Option<&str>,
    impact: Option<usize>,
    sheet: Option<String>,
    decimal: Option<&str>,
) -> PyResult<Record<'py>> {
    let refuse = |reason: &dyn ToString| error::file(py, format!("{}: {}", path.display(), reason.to_string()));
    let options = Options {
        layout: Layout { decimal: option(py, "decimal", decimal, FromStr::from_str)?, sheet },
        time: option(py, "time", time, FromStr::from_str)?,
        force: option(py, "force_column", force_column, FromStr::from_str)?,
        acceleration: option(py, "acceleration", acceleration, FromStr::from_str)?,
        displacement: option(py, "displacement", displacement, FromStr::from_str)?,
        mass: option(py, "mass", mass, trace::mass)?,
        rate: option(py, "rate", rate, trace::rate)?,
        offset,
        sign: option(py, "sign", sign, trace::sign)?,
        impact,
    };
    let expected = scenario.and_then(|settings| measured::expected(&settings.resolved().impactor));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let read = py.detach(|| {
        let bytes = std::fs::read(&path).map_err(|error| error.to_string())?;
        trace::read(&name, &bytes, &options, expected.as_ref()).map_err(|error| error.to_string())
    });
    let Trace { times, forces, deformation, understood, .. } = read.map_err(|error| refuse(&error))?;
    Ok((times.into_pyarray(py), forces.into_pyarray(py), deformation, understood.json().to_string()))
}

/// The value of an option.
fn option<T>(
    py: Python<'_>,
    name: &str,
    text: Option<&str>,
    read: impl Fn(&str) -> Result<T, String>,
) -> PyResult<Option<T>> {
    let Some(text) = text else { return Ok(None) };
    read(text).map(Some).map_err(|legal| error::file(py, format!("{name} = {text} is refused: {legal}")))
}
