//! What a drop depends on: one thing changed at a time, beside what the paper reports of it.
//!
//! A [`Study`] plans [`case`]s for a scenario, [`sweep`] simulates them on all cores, the study evaluates the
//! [`results`], and [`page`] shows them. The convergence with the mesh is judged by [`richardson`].

pub mod case;
pub mod columns;
pub mod damping;
pub mod diameter;
pub mod friction;
pub mod law;
pub mod mesh;
pub mod page;
pub mod parameter;
pub mod poisson;
pub mod results;
pub mod richardson;
pub mod sweep;
pub mod thickness;
pub mod values;
pub mod variants;

use softanvil_kernel::{Parameter, Scenario};

use self::case::Case;
use self::page::Evaluation;
use self::results::Results;
use crate::failure::Failure;
use crate::scenario_file::assign;

/// Makes the cases of a study for a scenario and some values.
pub type Plan = fn(&Study, &Scenario, &[String]) -> Result<Vec<Case>, Failure>;

/// One of the studies.
pub struct Study {
    /// Name on the command line and of its files.
    pub name: &'static str,
    /// Title of its page.
    pub title: &'static str,
    /// What is changed and why, for the reader of the page.
    pub about: &'static str,
    /// What its values are, with their unit.
    pub values: &'static str,
    /// The values unless told otherwise.
    pub default_values: &'static [&'static str],
    /// Names of what tells its cases apart, with units.
    pub settings: &'static [&'static str],
    /// Its cases for a scenario and some values.
    pub plan: Plan,
    /// What the results say.
    pub evaluate: fn(&Results) -> Evaluation,
}

impl std::fmt::Debug for Study {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

/// All studies, in the order of `study all`.
pub static STUDIES: [&Study; 7] = [
    &mesh::STUDY,
    &friction::STUDY,
    &poisson::STUDY,
    &damping::STUDY,
    &law::STUDY,
    &thickness::STUDY,
    &diameter::STUDY,
];

impl Study {
    /// The study called `name`, or that of the parameter called so.
    pub fn find(name: &str) -> Option<&'static Study> {
        let named = STUDIES.into_iter().find(|study| study.name == name);
        named.or_else(|| Parameter::find(name).map(parameter::study))
    }
}

/// Sets a parameter of `scenario`.
///
/// # Errors
/// A value that is refused, with its unit and legal range.
pub(crate) fn set(scenario: &mut Scenario, name: &str, value: f64) -> Result<(), Failure> {
    let parameter = assign::find(name).map_err(Failure::Failed)?;
    parameter.set(scenario, value).map_err(|error| Failure::Input(error.to_string()))
}
