//! The identified material in a drop: what a run of it needs.

use softanvil_kernel::Scenario;

use crate::run::{Drop, Run, RunError};

/// Safety factors of the time step that are tried after the scenario's own. A soft material is pressed thinner than the step
/// is chosen for.
const FACTORS: [f64; 5] = [0.7, 0.5, 0.3, 0.2, 0.1];
/// Halvings of the energy that are tried.
const HALVINGS: u32 = 6;

/// A drop that a material goes through.
pub struct Trial {
    /// Its scenario.
    pub scenario: Scenario,
    /// The safety factor of its time step is lower than it was.
    pub lowered: bool,
    /// Why the whole energy fails, if it does; the scenario has less then.
    pub failure: Option<String>,
}

impl Trial {
    /// Drops on the anvil of `scenario`: with its own step, with smaller ones, and with less energy, until one goes through.
    ///
    /// # Errors
    /// Why even the smallest energy fails.
    pub fn new(scenario: &Scenario) -> Result<Self, RunError> {
        let own = scenario.time.safety_factor;
        let mut failure: Option<RunError> = None;
        for halving in 0..=HALVINGS {
            let energy = scenario.impactor.drop_energy * 0.5_f64.powi(halving as i32);
            for factor in [own].into_iter().chain(FACTORS.into_iter().filter(|factor| *factor < own)) {
                let mut tried = Scenario { impactor: scenario.impactor.with_energy(energy), ..*scenario };
                tried.time.safety_factor = factor;
                match run(&tried) {
                    Ok(_) => {
                        let failure = failure.filter(|_| halving > 0).map(|error| error.to_string());
                        return Ok(Self { scenario: tried, lowered: factor < own, failure });
                    }
                    // A step of the smallest factor tells what is wrong but for the step.
                    Err(error) if halving == 0 => failure = Some(error),
                    Err(_) => {}
                }
            }
        }
        match failure {
            Some(error) => Err(error),
            None => run(scenario).map(|_| Self { scenario: *scenario, lowered: false, failure: None }),
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
        if self.lowered {
            text += &format!(
                "! A drop of {energy} J needs the safety factor {} of the time step, as in {file}: softanvil run --scenario {file}\n",
                self.scenario.time.safety_factor
            );
        } else {
            text += &format!("A drop of {energy} J goes through: softanvil run --scenario {file}\n");
        }
        text
    }
}

fn run(scenario: &Scenario) -> Result<Run, RunError> {
    Drop::new(scenario)?.run(|_| {})
}
