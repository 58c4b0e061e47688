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

use axis::Axis;
use serde::Deserialize;

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
