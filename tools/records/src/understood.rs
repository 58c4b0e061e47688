//! How a file was understood, for people and for other programs.

use std::fmt;

use serde_json::{Map, Value};

/// One thing that was understood.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Its name.
    pub key: &'static str,
    /// For people.
    pub text: String,
    /// For programs, in SI units.
    pub value: Value,
}

/// Everything that was understood of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Understood {
    /// What it holds, and how it was read.
    pub statements: Vec<Statement>,
    /// What is unlikely, and why.
    pub warnings: Vec<String>,
}

impl Understood {
    /// Adds a statement.
    pub fn say(&mut self, key: &'static str, text: impl Into<String>, value: impl Into<Value>) {
        self.statements.push(Statement { key, text: text.into(), value: value.into() });
    }

    /// The value of statement `key`.
    pub fn get(&self, key: &str) -> Option<&Value> {
        self.statements.iter().find(|statement| statement.key == key).map(|statement| &statement.value)
    }

    /// The same for other programs.
    pub fn json(&self) -> Value {
        let statements = self.statements.iter().map(|statement| (statement.key.to_string(), statement.value.clone()));
        let mut object: Map<String, Value> = statements.collect();
        object.insert("warnings".into(), self.warnings.clone().into());
        Value::Object(object)
    }
}

impl fmt::Display for Understood {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        for statement in &self.statements {
            writeln!(f, "  {:<12} {}", statement.key.replace('_', " "), statement.text)?;
        }
        for warning in &self.warnings {
            writeln!(f, "! {warning}")?;
        }
        Ok(())
    }
}
