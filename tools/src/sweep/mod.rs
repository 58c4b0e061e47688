//! What a drop depends on: any parameters swept over values, alone or in all combinations, and the convergence with the mesh.
//!
//! A [`Sweep`] says what is changed, by the command line or by a [`mod@file`]; [`plan`] makes [`case`]s of it for a scenario, [`run`]
//! simulates them on all cores, and [`page`] shows the [`results`]. [`convergence`] judges meshes by [`richardson`].

pub mod axis;
pub mod case;
pub mod columns;
pub mod convergence;
pub mod file;
pub mod page;
mod picture;
pub mod plan;
pub mod results;
pub mod richardson;
pub mod run;
pub mod sheet;

use axis::{Axis, Value};
use itertools::Itertools;
use serde::Deserialize;
use softanvil_kernel::{Parameter, Scenario};

use crate::failure::Failure;

/// What is swept, and what a reader has to know of it.
#[derive(Clone, Debug)]
pub struct Sweep {
    /// Name of its files.
    pub name: String,
    /// Title of its page.
    pub title: String,
    /// What is changed and why, for the reader of the page.
    pub about: String,
    /// The arguments of `softanvil sweep` that make it.
    pub arguments: String,
    /// What is changed, in all combinations.
    pub axes: Vec<Axis>,
    /// Parts into which the mesh divides an element; empty if the mesh is the scenario's.
    pub refinements: Vec<f64>,
    /// Pairs of cases of which the page gives the changes.
    pub contrasts: Vec<Contrast>,
}

/// Two cases, by the names of their levels, and what the paper says of the change between them.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Contrast {
    /// What it is, for people.
    pub what: String,
    /// From where.
    pub from: Vec<String>,
    /// To where.
    pub to: Vec<String>,
    /// What the paper says; nothing if it is silent.
    pub paper: Option<String>,
}

impl Sweep {
    /// The sweep of `PARAMETER=LIST` texts, in all combinations, and on meshes finer by the factors `refinements`.
    ///
    /// # Errors
    /// A parameter that is unknown, or a value that is refused.
    pub fn of_parameters(texts: &[impl AsRef<str>], refinements: &[f64], scenario: &Scenario) -> Result<Self, Failure> {
        let texts: Vec<&str> = texts.iter().map(AsRef::as_ref).collect();
        let read = |text: &&str| {
            let (name, values) = text.split_once('=').unwrap_or((text, ""));
            let values: Vec<Value> = values.split(',').map(|value| Value::Text(value.into())).collect();
            let names = vec![name.trim().to_string()];
            let axis = Axis::of_values(None, &names, &values, scenario);
            axis.map(|axis| (names, axis)).map_err(|error| Failure::Input(format!("sweep {text}: {error}")))
        };
        let (names, axes): (Vec<_>, Vec<_>) =
            texts.iter().map(read).collect::<Result<Vec<_>, _>>()?.into_iter().unzip();
        let names = names.concat();
        let convergence = match refinements {
            [] => None,
            _ => Some(format!("--convergence={}", refinements.iter().join(","))),
        };
        let mut about =
            names.iter().filter_map(|name| Parameter::find_in(scenario, name)).map(|parameter| parameter.description());
        Ok(Self {
            name: if names.is_empty() { "convergence".into() } else { names.join("-") },
            title: if names.is_empty() { "Convergence with the mesh".into() } else { names.join(", ") },
            about: about.join("; "),
            arguments: texts.iter().map(ToString::to_string).chain(convergence).join(" "),
            axes,
            refinements: refinements.to_vec(),
            contrasts: Vec::new(),
        })
    }

    /// Names of what tells its cases apart, with units.
    pub fn headings(&self) -> Vec<&str> {
        let mesh: &[&str] = if self.refines() { &["rows", "columns"] } else { &[] };
        self.axes.iter().map(|axis| axis.name.as_str()).chain(mesh.iter().copied()).collect()
    }

    /// Whether each combination is simulated on several meshes.
    pub fn refines(&self) -> bool {
        !self.refinements.is_empty()
    }

    /// How many leading settings the cases of a group have in common, which differ by the last axis or by the mesh alone.
    pub fn common(&self) -> usize {
        if self.refines() { self.axes.len() } else { self.axes.len().saturating_sub(1) }
    }
}
