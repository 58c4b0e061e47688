//! From TOML to a scenario.

use std::ops::Range;
use std::path::Path;

use softanvil_kernel::{Changes, Parameter, ParameterError, Scenario, ScenarioError};
use toml_edit::{Document, Item, TableLike, TomlError, Value};

use super::assign::{self, Given, Written};
use super::names::{self, LAYERS};
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
    #[error("line {line}: {reason}")]
    Unknown {
        /// Line of the key, from 1.
        line: usize,
        /// The name, with the nearest one or how it is written now.
        reason: String,
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
    /// The parameter has a value already.
    #[error("line {line}: {reason}")]
    Twice {
        /// Line of the second value, from 1.
        line: usize,
        /// Both names.
        reason: String,
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

/// Reads a material file upon `base`: a scenario file with sections of layers alone.
///
/// # Errors
/// As [`read`], and a section that is no layer's.
pub fn read_material(path: &Path, base: &Scenario) -> Result<Scenario, Failure> {
    let refuse = |error: &dyn std::fmt::Display| Failure::Input(format!("{}: {error}", path.display()));
    let text = std::fs::read_to_string(path).map_err(|error| refuse(&error))?;
    parse_material(&text, base).map_err(|error| refuse(&error))
}

/// The scenario that the material in `text` makes of `base`.
///
/// # Errors
/// As [`parse`], and a section that is no layer's.
pub fn parse_material(text: &str, base: &Scenario) -> Result<Scenario, ScenarioFileError> {
    let document = Document::parse(text).map_err(|error| syntax(text, &error))?;
    let names: Vec<_> = base.layers.iter().map(|layer| layer.name.as_str()).filter(|name| !name.is_empty()).collect();
    if let Some((group, _)) = document.iter().find(|(group, _)| !names.contains(group)) {
        let line = line_of(text, key_span(document.as_table(), group));
        let legal = format!("the name of a layer ({})", names.join(", "));
        let reason = format!("{group} is refused: expected {legal} in a material");
        return Err(ScenarioFileError::Unknown { line, reason });
    }
    parse(text, base)
}

/// The scenario that `text` makes of `base`.
///
/// # Errors
/// The first line that is not TOML, names no parameter, or gives it an illegal value; or values that contradict each other,
/// have no effect, or do not fit together.
pub fn parse(text: &str, base: &Scenario) -> Result<Scenario, ScenarioFileError> {
    let document = Document::parse(text).map_err(|error| syntax(text, &error))?;
    let mut content = Content { changes: Changes::of(base), given: Given::default() };
    // First of all the layers, whose names may be those of sections.
    if let Some(item) = document.get(LAYERS) {
        let position = Position { text, span: key_span(document.as_table(), LAYERS) };
        read_layers(&position, item, &mut content)?;
    }
    for (group, item) in document.iter().filter(|(group, _)| *group != LAYERS) {
        let position = Position { text, span: key_span(document.as_table(), group) };
        let is_group = |parameter: Parameter| parameter.name().group() == group;
        let is_layer = || content.changes.values().scenario().layers.iter().any(|layer| layer.name == group);
        if !Parameter::all().any(is_group) && !is_layer() {
            return Err(position.unknown(&content.changes, group));
        }
        let Some(section) = item.as_table_like() else {
            return Err(position.wrong_type(group, item, format!("a section [{group}] of keys")));
        };
        read_section(&position, group, section, &mut content)?;
    }
    Ok(content.changes.apply()?)
}

/// What a file has said so far.
struct Content {
    changes: Changes,
    given: Given,
}

/// Reads the tables of layers: as many as there are layers, the first next to the core.
fn read_layers(position: &Position, item: &Item, content: &mut Content) -> Result<(), ScenarioFileError> {
    let legal = || format!("a table [[{LAYERS}]] for each layer");
    let tables: Vec<&dyn TableLike> = match item {
        Item::ArrayOfTables(tables) => tables.iter().map(|table| table as &dyn TableLike).collect(),
        Item::Value(Value::Array(array)) => {
            let tables: Option<Vec<_>> = array.iter().map(|value| Some(value.as_inline_table()? as _)).collect();
            tables.ok_or_else(|| position.wrong_type(LAYERS, item, legal()))?
        }
        _ => return Err(position.wrong_type(LAYERS, item, legal())),
    };
    if let Some(count) = Parameter::find("layers.count") {
        position.set(content, count, "layers.count", tables.len() as f64)?;
    }
    for (number, table) in tables.into_iter().enumerate() {
        for (field, item) in table.iter() {
            let position = Position { span: key_span(table, field), ..*position };
            let name = format!("{LAYERS}[{number}].{field}");
            if field == "name" {
                let text = item.as_str().ok_or_else(|| position.wrong_type(&name, item, "a text".into()))?;
                let legal = names::check_layer_name(content.changes.values(), number, text);
                legal.map_err(|legal| position.wrong_type(&name, item, legal))?;
                content.changes.name_layer(number, text);
                continue;
            }
            let parameter = Parameter::find(&name).ok_or_else(|| position.unknown(&content.changes, &name))?;
            position.set(content, parameter, &name, position.value(&parameter, item)?)?;
        }
    }
    Ok(())
}

fn read_section(
    position: &Position,
    group: &str,
    section: &dyn TableLike,
    content: &mut Content,
) -> Result<(), ScenarioFileError> {
    for (field, item) in section.iter() {
        let name = format!("{group}.{field}");
        let position = Position { span: key_span(section, field), ..*position };
        let changes = &content.changes;
        let parameter = changes.values().find(&name).ok_or_else(|| position.unknown(changes, &name))?;
        position.set(content, parameter, &name, position.value(&parameter, item)?)?;
    }
    Ok(())
}

/// Where in the text something stands.
struct Position<'a> {
    text: &'a str,
    span: Option<Range<usize>>,
}

impl Position<'_> {
    /// Counted for errors alone: a file has a position for each of its keys.
    fn line(&self) -> usize {
        line_of(self.text, self.span.clone())
    }

    /// The number that `item` gives to `parameter`; for a choice, its index.
    fn value(&self, parameter: &Parameter, item: &Item) -> Result<f64, ScenarioFileError> {
        let written = match item {
            Item::Value(Value::Float(number)) => Written::Number(*number.value()),
            Item::Value(Value::Integer(number)) => Written::Number(*number.value() as f64),
            Item::Value(Value::String(text)) => Written::Label(text.value()),
            _ => Written::Other,
        };
        assign::number(parameter, written).map_err(|legal| self.wrong_type(&parameter.name().to_string(), item, legal))
    }

    fn set(
        &self,
        content: &mut Content,
        parameter: Parameter,
        name: &str,
        value: f64,
    ) -> Result<(), ScenarioFileError> {
        let twice = |reason| ScenarioFileError::Twice { line: self.line(), reason };
        content.given.add(parameter, name).map_err(twice)?;
        let refused = |error| ScenarioFileError::Value { line: self.line(), error };
        content.changes.set(parameter, value).map_err(refused)
    }

    fn unknown(&self, changes: &Changes, name: &str) -> ScenarioFileError {
        let reason = names::unknown(&changes.values().scenario(), name);
        ScenarioFileError::Unknown { line: self.line(), reason }
    }

    fn wrong_type(&self, name: &str, item: &Item, legal: String) -> ScenarioFileError {
        let found = match item {
            Item::Value(value) => value.clone().decorated("", "").to_string(),
            _ => "a section".into(),
        };
        ScenarioFileError::Type { line: self.line(), name: name.into(), found, legal }
    }
}

/// What `text`, a file of another kind, says.
///
/// # Errors
/// Line and message of what is no TOML or not that kind of it.
#[cfg(feature = "command-line")]
pub(crate) fn from_toml<T: serde::de::DeserializeOwned>(text: &str) -> Result<T, String> {
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
