//! From TOML to a scenario.

use std::ops::Range;
use std::path::Path;

use serde::de::DeserializeOwned;
use softanvil_kernel::{Changes, PARAMETERS, Parameter, ParameterError, Scenario, ScenarioError};
use toml_edit::{Document, Item, TableLike, TomlError, Value};

use super::assign::{self, Written};
use super::split;
use super::suggestion::suggestion;
use crate::failure::Failure;

/// Why a scenario file is refused.
///
/// ```
/// use softanvil_kernel::preset;
/// use softanvil_tools::scenario_file::{ScenarioFileError, parse};
///
/// let refused = parse("[impactor]\nmas = 4.0\n", &preset::study()).unwrap_err();
/// assert!(matches!(refused, ScenarioFileError::Unknown { line: 2, .. }));
/// assert!(refused.to_string().contains("impactor.mass"));
/// let scenario = parse("[impactor]\nmass = 4.0\n", &preset::study())?;
/// assert_eq!(scenario.impactor.mass, 4.0);
/// # Ok::<(), ScenarioFileError>(())
/// ```
#[derive(Debug, thiserror::Error)]
pub enum ScenarioFileError {
    /// The text is not TOML.
    #[error("line {line}: {message}")]
    Syntax {
        /// Line of the error, from 1.
        line: usize,
        /// What is wrong there.
        message: String,
    },
    /// No parameter or section has this name.
    #[error("line {line}: {name} is unknown{suggestion}")]
    Unknown {
        /// Line of the key, from 1.
        line: usize,
        /// The name.
        name: String,
        /// The nearest name, or nothing.
        suggestion: String,
    },
    /// The value is of the wrong type.
    #[error("line {line}: {name} = {found} is refused: expected {legal}")]
    Type {
        /// Line of the key, from 1.
        line: usize,
        /// The name.
        name: String,
        /// What stands there.
        found: String,
        /// What may stand there.
        legal: String,
    },
    /// The number is out of its range.
    #[error("line {line}: {error}")]
    Value {
        /// Line of the key, from 1.
        line: usize,
        /// Value, unit and range.
        error: ParameterError,
    },
    /// The parameters do not fit together.
    #[error("{0}")]
    Scenario(#[from] ScenarioError),
}

/// Reads a scenario file upon `base`.
///
/// # Errors
/// A file that cannot be read, or what [`parse`] refuses, with the name of the file.
pub fn read(path: &Path, base: &Scenario) -> Result<Scenario, Failure> {
    let refuse = |error: &dyn std::fmt::Display| Failure::Input(format!("{}: {error}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| refuse(&error))?;
    parse(&text, base).map_err(|error| refuse(&error))
}

/// Reads a material file upon `base`: a scenario file with materials alone.
///
/// # Errors
/// As [`read`], and a section that is no material.
pub fn read_material(path: &Path, base: &Scenario) -> Result<Scenario, Failure> {
    let refuse = |error: &dyn std::fmt::Display| Failure::Input(format!("{}: {error}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| refuse(&error))?;
    let document = Document::parse(text.as_str()).map_err(|error| refuse(&syntax(&text, &error)))?;
    if let Some((group, _)) = document.iter().find(|(group, _)| !MATERIALS.contains(group)) {
        let line = line_of(&text, key_span(document.as_table(), group));
        return Err(refuse(&format!(
            "line {line}: {group} is refused: expected {} in a material",
            MATERIALS.join(" or ")
        )));
    }
    parse(&text, base).map_err(|error| refuse(&error))
}

/// Groups of parameters that are materials.
const MATERIALS: [&str; 2] = ["silicone", "skin"];

/// The scenario that `text` makes of `base`.
///
/// # Errors
/// The first line that is not TOML, names no parameter, or gives it an illegal value; or values that contradict each other,
/// have no effect, or do not fit together.
pub fn parse(text: &str, base: &Scenario) -> Result<Scenario, ScenarioFileError> {
    let document = Document::parse(text).map_err(|error| syntax(text, &error))?;
    let mut changes = Changes::of(base);
    for (group, item) in document.iter() {
        let position = Position { text, line: line_of(text, key_span(document.as_table(), group)) };
        if !PARAMETERS.iter().any(|parameter| split(parameter.name).0 == group) {
            return Err(position.unknown(group));
        }
        let Some(section) = item.as_table_like() else {
            return Err(position.wrong_type(group, item, format!("a section [{group}] of keys")));
        };
        read_section(&position, group, section, &mut changes)?;
    }
    Ok(changes.apply()?)
}

fn read_section(
    position: &Position,
    group: &str,
    section: &dyn TableLike,
    changes: &mut Changes,
) -> Result<(), ScenarioFileError> {
    for (field, item) in section.iter() {
        let name = format!("{group}.{field}");
        let position = Position { line: line_of(position.text, key_span(section, field)), ..*position };
        let Some(parameter) = Parameter::find(&name) else {
            return Err(position.unknown(&name));
        };
        let value = position.value(parameter, item)?;
        changes.set(parameter, value).map_err(|error| ScenarioFileError::Value { line: position.line, error })?;
    }
    Ok(())
}

/// Where in the text something stands.
struct Position<'a> {
    text: &'a str,
    line: usize,
}

impl Position<'_> {
    /// The number that `item` gives to `parameter`; for a choice, its index.
    fn value(&self, parameter: &Parameter, item: &Item) -> Result<f64, ScenarioFileError> {
        let written = match item {
            Item::Value(Value::Float(number)) => Written::Number(*number.value()),
            Item::Value(Value::Integer(number)) => Written::Number(*number.value() as f64),
            Item::Value(Value::String(text)) => Written::Label(text.value()),
            _ => Written::Other,
        };
        assign::number(parameter, written).map_err(|legal| self.wrong_type(parameter.name, item, legal))
    }

    fn unknown(&self, name: &str) -> ScenarioFileError {
        ScenarioFileError::Unknown { line: self.line, name: name.into(), suggestion: suggestion(name) }
    }

    fn wrong_type(&self, name: &str, item: &Item, legal: String) -> ScenarioFileError {
        let found = match item {
            Item::Value(value) => value.clone().decorated("", "").to_string(),
            _ => "a section".into(),
        };
        ScenarioFileError::Type { line: self.line, name: name.into(), found, legal }
    }
}

/// What `text`, a file of another kind, says.
///
/// # Errors
/// Line and message of what is no TOML or not that kind of it.
pub(crate) fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    toml_edit::de::from_str(text).map_err(|error| {
        let message = error.message().split_whitespace().collect::<Vec<_>>().join(" ");
        format!("line {}: {message}", line_of(text, error.span()))
    })
}

fn syntax(text: &str, error: &TomlError) -> ScenarioFileError {
    let message = error.message().split_whitespace().collect::<Vec<_>>().join(" ");
    ScenarioFileError::Syntax { line: line_of(text, error.span()), message }
}

fn key_span(table: &dyn TableLike, key: &str) -> Option<Range<usize>> {
    table.key(key).and_then(|key| key.span())
}

/// The line, from 1, in which `span` begins.
fn line_of(text: &str, span: Option<Range<usize>>) -> usize {
    let start = span.map_or(0, |span| span.start);
    1 + text.bytes().take(start).filter(|byte| *byte == b'\n').count()
}
