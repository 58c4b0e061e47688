//! The options that say which drop to simulate.

use std::path::PathBuf;

use clap::Args;
use softanvil_kernel::Changes;
use softanvil_kernel::preset::Preset;
use softanvil_kernel::scenario::Motion;

use crate::failure::Failure;
use crate::output::subject::Subject;
use crate::presets;
use crate::run::Until;
use crate::scenario_file::assign::{self, Given};
use crate::scenario_file::{self, names};

/// Which drop to simulate.
#[derive(Debug, Args)]
pub struct DropOptions {
    /// Preset to start from
    #[arg(long, value_name = "NAME", default_value = "study", value_parser = presets::parse)]
    preset: &'static Preset,
    /// Scenario file (TOML, as `softanvil scenario` prints it); keys left out keep the preset's value
    #[arg(long, value_name = "FILE")]
    scenario: Option<PathBuf>,
    /// Material file (TOML, as `softanvil fit --out` writes it); its values stand over those of the scenario
    #[arg(long, value_name = "FILE")]
    material: Option<PathBuf>,
    /// Parameter to set over those, by its name in the scenario file: silicone.c10=2e5 or layers[0].c10=2e5; repeat for more
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    #[command(flatten)]
    start: StartOptions,
    /// Simulated time in s, to the end of which a drop is simulated whatever happens [default: the scenario's; a preset's is
    /// extended, up to 20 times, until the contact has ended]
    #[arg(long, value_name = "S", allow_negative_numbers = true)]
    duration: Option<f64>,
}

/// How fast the impactor is at the start, instead of the scenario's.
#[derive(Debug, Args)]
#[group(multiple = false)]
struct StartOptions {
    /// Impact energy in J
    #[arg(long, value_name = "J", allow_negative_numbers = true)]
    energy: Option<f64>,
    /// Drop height in m
    #[arg(long, value_name = "M", allow_negative_numbers = true)]
    height: Option<f64>,
    /// Speed at the start in m/s, downwards
    #[arg(long, value_name = "M_PER_S", allow_negative_numbers = true)]
    speed: Option<f64>,
}

impl DropOptions {
    /// The drop that the options describe.
    ///
    /// # Errors
    /// A scenario file or a value that is refused.
    pub fn subject(&self) -> Result<Subject, Failure> {
        let preset = (self.preset.scenario)();
        let mut scenario = match &self.scenario {
            Some(path) => scenario_file::read(path, &preset)?,
            None => preset.clone(),
        };
        if let Some(path) = &self.material {
            scenario = scenario_file::read_material(path, &scenario)?;
        }
        let mut own_duration = scenario.time.duration != preset.time.duration || self.duration.is_some();
        let (mut changes, mut given) = (Changes::of(&scenario), Given::default());
        for text in &self.set {
            let parameter = assign::set_text(&mut changes, &mut given, text)
                .map_err(|error| Failure::Input(format!("--set {text}: {error}")))?;
            own_duration |= parameter.name() == DURATION;
        }
        self.start.apply(&mut changes, &mut given)?;
        if let Some(duration) = self.duration {
            set(&mut changes, &mut given, ("--duration", DURATION), duration)?;
        }
        let scenario = changes.apply().map_err(|error| Failure::Input(error.to_string()))?;
        Ok(Subject {
            scenario,
            until: if own_duration { Until::Duration } else { Until::Over },
            preset: self.preset,
            scenario_file: self.scenario.clone(),
            material_file: self.material.clone(),
            set: self.set.clone(),
        })
    }
}

/// Name of the parameter that says how long a run is.
pub(super) const DURATION: &str = "time.duration";

impl StartOptions {
    fn apply(&self, changes: &mut Changes, given: &mut Given) -> Result<(), Failure> {
        for (option, value) in [("energy", self.energy), ("height", self.height), ("speed", self.speed)] {
            if let Some(value) = value {
                if changes.values().scenario().impactor.motion == Motion::Prescribed {
                    let text = "is refused: impactor.motion = prescribed does not fall; expected drop";
                    return Err(Failure::Input(format!("--{option} {text}")));
                }
                let names = (format!("--{option}"), format!("impactor.drop_{option}"));
                set(changes, given, (&names.0, &names.1), value)?;
            }
        }
        Ok(())
    }
}

/// Sets the parameter called `name` by `option`.
fn set(changes: &mut Changes, given: &mut Given, (option, name): (&str, &str), value: f64) -> Result<(), Failure> {
    let parameter = names::find(changes.values(), name).map_err(Failure::Input)?;
    given.add(parameter, option).map_err(Failure::Input)?;
    changes.set(parameter, value).map_err(|error| Failure::Input(error.to_string()))
}
