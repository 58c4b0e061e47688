//! The tables of the kernel: what there is to set and to read.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use softanvil_kernel::parameter::Kind;
use softanvil_kernel::preset::PRESETS;
use softanvil_kernel::{FIELDS, OUTPUTS, Parameter};
use softanvil_tools::identity;

/// The parameters of the test and of one layer: dictionaries of name, group, field, kind, labels, unit, minimum, maximum and
/// description.
#[pyfunction]
pub fn parameters(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    let rows = Parameter::all().filter(|parameter| parameter.layer().is_none_or(|layer| layer == 0)).map(|parameter| {
        let (row, name) = (PyDict::new(py), parameter.name());
        let kind = match parameter.kind() {
            Kind::Quantity => "quantity",
            Kind::Count => "count",
            Kind::Choice { .. } => "choice",
        };
        let (minimum, maximum) = parameter.range();
        row.set_item("name", name.to_string())?;
        row.set_item("group", name.group())?;
        row.set_item("field", name.field())?;
        row.set_item("kind", kind)?;
        row.set_item("labels", parameter.labels())?;
        row.set_item("unit", parameter.unit())?;
        row.set_item("minimum", minimum)?;
        row.set_item("maximum", maximum)?;
        row.set_item("description", parameter.description())?;
        Ok(row)
    });
    PyList::new(py, rows.collect::<PyResult<Vec<_>>>()?)
}

/// The outputs: (name, unit, description).
#[pyfunction]
pub fn outputs() -> Vec<(&'static str, &'static str, &'static str)> {
    OUTPUTS.iter().map(|output| (output.name, output.unit, output.description)).collect()
}

/// The fields: (name, unit, description).
#[pyfunction]
pub fn fields() -> Vec<(&'static str, &'static str, &'static str)> {
    FIELDS.iter().map(|field| (field.name, field.unit, field.description)).collect()
}

/// The presets: (name, description).
#[pyfunction]
pub fn presets() -> Vec<(&'static str, &'static str)> {
    PRESETS.iter().map(|preset| (preset.name, preset.description)).collect()
}

/// Digest of what the kernel computes, 16 hexadecimal digits.
#[pyfunction]
pub fn kernel_digest() -> String {
    identity::kernel_digest()
}

/// What the module was compiled for: processor, system and C library.
#[pyfunction]
pub fn target() -> String {
    identity::target()
}

/// Version of the package.
#[pyfunction]
pub fn version() -> &'static str {
    env!("CARGO_PKG_VERSION")
}
