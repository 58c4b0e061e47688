//! What came of pads, for programs: SI units, accelerations in g.

use serde_json::{Value, json};

use super::numbers::{LayerNumbers, Numbers};
use super::trial::{Outcome, Trial};
use crate::output::json::of_ending;

/// Everything.
pub fn of_trial(trial: &Trial) -> Value {
    let pads = trial.pads.iter().map(|(case, outcome)| {
        let mut object = match outcome {
            Ok(outcome) => of_outcome(outcome),
            Err(error) => json!({ "failure": error }),
        };
        object["name"] = case.name.clone().into();
        object["thickness"] = super::padding::thickness(&case.scenario).into();
        object
    });
    json!({
        "drop": trial.subject.json(),
        "standard": trial.standard,
        "bare": trial.bare.as_ref().map(of_outcome),
        "pads": pads.collect::<Vec<_>>(),
    })
}

fn of_outcome(outcome: &Outcome) -> Value {
    let mut object = of_numbers(&outcome.numbers);
    object["verdict"] = outcome.verdict.json();
    for (key, value) in of_ending(&outcome.run) {
        object[key] = value;
    }
    object["trace_hash"] = outcome.run.trace_hash().into();
    object
}

fn of_numbers(numbers: &Numbers) -> Value {
    json!({
        "peak_transmitted_force": numbers.transmitted,
        "peak_acceleration_g": numbers.acceleration,
        "impact_duration": numbers.duration,
        "impulse": numbers.impulse,
        "impact_energy": numbers.energy,
        "absorbed_energy": numbers.absorbed,
        "restitution": numbers.restitution,
        "max_deformation": numbers.deformation,
        "layers": numbers.layers.iter().map(of_layer).collect::<Vec<_>>(),
    })
}

fn of_layer(layer: &LayerNumbers) -> Value {
    json!({
        "name": layer.name,
        "pad": layer.is_pad,
        "max_compression": layer.extremes.compression,
        "max_stretch": layer.extremes.stretch,
        "tear_stretch": layer.tear_stretch,
        "torn": layer.has_torn(),
    })
}
