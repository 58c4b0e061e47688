//! What it costs to reduce the anvil to a section: the same drop in two dimensions and in three, and the length with which a
//! section bears what the solid does.

pub mod effective_length;
pub mod json;
pub mod picture;
pub mod table;

use indicatif::ProgressBar;
use softanvil_kernel::scenario::{Body, Formulation, Section, Symmetry};
use softanvil_kernel::{ModelError, Scenario};

use crate::failure::Failure;
use crate::progress;
use crate::run::{Drop, RunError, Until};
use crate::sweep::Sweep;
use crate::sweep::case::{Case, Outcome};
use effective_length::Found;

/// One scenario in both formulations.
#[derive(Debug)]
pub struct Comparison {
    /// What tells it from the others: a text for each of the sweep's headings.
    pub settings: Vec<String>,
    /// In three dimensions.
    pub solid: Outcome,
    /// As a section of the scenario's length.
    pub section: Outcome,
    /// The length with which the section bears as much; none of a dome, whose section has none.
    pub length: Option<Found>,
}

/// All of them.
pub struct Reduction {
    /// Names of what tells them apart, with units.
    pub headings: Vec<String>,
    /// One for each scenario.
    pub comparisons: Vec<Comparison>,
    /// One length for all, if each has its own, or one that is nearest to it.
    pub common: Option<Common>,
}

/// What sections have in common.
#[derive(Debug)]
pub struct Common {
    /// Mean of the lengths, m.
    pub length: f64,
    /// The section of that length, for each scenario.
    pub sections: Vec<Outcome>,
    /// Largest difference of its force from that of the solid, %.
    pub worst: f64,
}

/// Simulates `cases` of `sweep` in both formulations, each run `until`.
///
/// # Errors
/// A scenario that one of the formulations refuses, or that fails.
pub fn compare(sweep: &Sweep, cases: &[Case], until: Until) -> Result<Reduction, Failure> {
    // Refused before anything is simulated.
    for case in cases {
        for scenario in [as_solid(&case.scenario), as_section(&case.scenario)] {
            scenario.validate().map_err(ModelError::from).map_err(RunError::from)?;
        }
    }
    let bar = progress::bar(0);
    let mut comparisons = Vec::new();
    // One solid at a time: each takes tens of megabytes.
    for (number, case) in cases.iter().enumerate() {
        bar.set_message(format!("{} of {} {}", number + 1, cases.len(), case.settings.join(" ")));
        comparisons.push(Comparison::new(case, until, &bar)?);
    }
    let common = common(cases, &comparisons, until)?;
    let headings = sweep.headings().into_iter().map(str::to_string).collect();
    Ok(Reduction { headings, comparisons, common })
}

impl Comparison {
    fn new(case: &Case, until: Until, bar: &ProgressBar) -> Result<Self, Failure> {
        let drop = Drop::until(&as_solid(&case.scenario), until)?;
        bar.set_length(drop.steps());
        bar.reset();
        let solid = Outcome::new(drop.run(|steps| bar.inc(steps))?);
        let scenario = as_section(&case.scenario);
        let section = Outcome::simulate(&scenario, until)?;
        let length = match scenario.geometry.formulation {
            Formulation::PlaneStrain => Some(effective_length::find(&scenario, until, &section, solid.force())?),
            _ => None,
        };
        Ok(Self { settings: case.settings.clone(), solid, section, length })
    }

    /// Difference of a force from that of the solid, %.
    pub fn difference(&self, outcome: &Outcome) -> f64 {
        100.0 * (outcome.force() / self.solid.force() - 1.0)
    }
}

/// The scenario in three dimensions.
fn as_solid(scenario: &Scenario) -> Scenario {
    let mut solid = scenario.clone();
    match scenario.geometry.formulation {
        Formulation::PlaneStrain => solid.geometry.body = Body::Prism,
        Formulation::Axisymmetric => solid.geometry.body = Body::Revolved,
        Formulation::Solid => {}
    }
    if !scenario.geometry.formulation.is_solid() && scenario.geometry.section == Section::Full {
        solid.geometry.symmetry = Symmetry::Half;
    }
    solid.geometry.formulation = Formulation::Solid;
    solid
}

/// The scenario as a section.
fn as_section(scenario: &Scenario) -> Scenario {
    let mut section = scenario.clone();
    if scenario.geometry.formulation.is_solid() {
        section.geometry.formulation = match scenario.geometry.body {
            Body::Prism => Formulation::PlaneStrain,
            Body::Revolved => Formulation::Axisymmetric,
        };
        let both_sides = scenario.geometry.symmetry != Symmetry::Quarter && scenario.geometry.body == Body::Prism;
        section.geometry.section = if both_sides { Section::Full } else { Section::Half };
    }
    section
}

/// One length for all scenarios, if there are several and each has one, or a nearest one.
fn common(cases: &[Case], comparisons: &[Comparison], until: Until) -> Result<Option<Common>, Failure> {
    let found = comparisons.iter().map(|comparison| comparison.length.as_ref()?.nearest());
    let Some(lengths) = found.collect::<Option<Vec<f64>>>().filter(|lengths| lengths.len() > 1) else {
        return Ok(None);
    };
    let length = lengths.iter().sum::<f64>() / lengths.len() as f64;
    let section = |case: &Case| {
        let mut scenario = as_section(&case.scenario);
        scenario.geometry.length = length;
        Outcome::simulate(&scenario, until)
    };
    let sections = cases.iter().map(section).collect::<Result<Vec<_>, RunError>>()?;
    let differences = comparisons.iter().zip(&sections).map(|(comparison, section)| comparison.difference(section));
    let worst = differences.map(f64::abs).fold(0.0, f64::max);
    Ok(Some(Common { length, sections, worst }))
}
