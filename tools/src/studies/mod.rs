//! What a drop depends on: one thing changed at a time, beside what the paper reports of it.
//!
//! A [`Study`] plans [`case`]s for a scenario, [`sweep`] simulates them on all cores, the study evaluates the
//! [`results`], and [`page`] shows them. The convergence with the mesh is judged by [`richardson`].

pub mod case;
pub mod columns;
pub mod damping;
pub mod diameter;
pub mod evaluation;
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

pub use results::Study;

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
    /// The study called `name`, or that of the parameter of `scenario` called so.
    pub fn find(name: &str, scenario: &Scenario) -> Option<&'static Study> {
        let named = STUDIES.into_iter().find(|study| study.name == name);
        named.or_else(|| Parameter::find_in(scenario, name).map(|parameter| parameter::study(name, parameter)))
    }
}
