//! The identified material in a drop: what a run of it needs.

use softanvil_kernel::Scenario;

use crate::run::{Drop, Run, RunError};

/// Halvings of the energy that are tried.
const HALVINGS: u32 = 6;

/// A drop that a material goes through.
pub struct Trial {
    /// Its scenario.
    pub scenario: Scenario,
    /// Why the whole energy fails, if it does; the scenario has less then.
    pub failure: Option<String>,
}

impl Trial {
    /// Drops on the anvil of `scenario`, with less and less energy until a drop goes through.
    ///
    /// # Errors
    /// Why even the smallest energy fails.
    pub fn new(scenario: &Scenario) -> Result<Self, RunError> {
        let mut failure: Option<RunError> = None;
        for halving in 0..=HALVINGS {
            let energy = scenario.impactor.drop_energy * 0.5_f64.powi(halving as i32);
            let tried = Scenario { impactor: scenario.impactor.with_energy(energy), ..scenario.clone() };
            match (run(&tried), failure) {
                (Ok(_), failure) => {
                    return Ok(Self { scenario: tried, failure: failure.map(|error| error.to_string()) });
                }
                // The first tells what is wrong with the drop that was asked for.
                (Err(error), None) => failure = Some(error),
                (Err(_), first) => failure = first,
            }
        }
        match failure {
            Some(error) => Err(error),
            None => run(scenario).map(|_| Self { scenario: scenario.clone(), failure: None }),
        }
    }

    /// What a user should know, in lines; `file` holds [`Trial::scenario`].
    pub fn text(&self, file: &str) -> String {
        let energy = self.scenario.impactor.drop_energy;
        let mut text = String::new();
        if let Some(failure) = &self.failure {
            text += &format!(
                "! A drop of the study's energy fails on this material: {failure}. It is too soft for that anvil, or its law \
                 unstable under such a compression.\n"
            );
        }
        text += &format!("A drop of {energy} J goes through: softanvil run --scenario {file}\n");
        text
    }
}

fn run(scenario: &Scenario) -> Result<Run, RunError> {
    Drop::new(scenario)?.run(|_| {})
}
