//! The comparison for programs: SI units.

use serde_json::{Map, Value, json};

use super::{Comparison, Reduction};
use crate::measurement::quantity::QUANTITIES;
use crate::sweep::case::Outcome;

/// Everything.
pub fn of_reduction(reduction: &Reduction) -> Value {
    let common = reduction.common.as_ref();
    let case = |(number, comparison): (usize, &Comparison)| {
        let found = comparison.length.as_ref().and_then(|found| found.length());
        let shared = common.map(|common| of_outcome(&common.sections[number]));
        let settings: Map<String, Value> = reduction
            .headings
            .iter()
            .zip(&comparison.settings)
            .map(|(name, text)| (name.clone(), text.parse::<f64>().map_or(text.as_str().into(), Value::from)))
            .collect();
        json!({
            "settings": settings,
            "solid": of_outcome(&comparison.solid),
            "section": of_outcome(&comparison.section),
            "section_difference_percent": comparison.difference(&comparison.section),
            "effective_length": found,
            "section_of_common_length": shared,
        })
    };
    json!({
        "effective_length": common.map(|common| common.length),
        "largest_difference_percent": common.map(|common| common.worst),
        "cases": reduction.comparisons.iter().enumerate().map(case).collect::<Vec<_>>(),
    })
}

fn of_outcome(outcome: &Outcome) -> Value {
    let numbers = QUANTITIES.iter().zip(outcome.values).map(|(quantity, value)| (quantity.key.into(), value.into()));
    let mut object: Map<String, Value> = numbers.collect();
    object.insert("held_force".into(), outcome.held_force().into());
    object.insert("ending".into(), outcome.ending().key().into());
    object.insert("elements".into(), outcome.run.constants.grid.n_elem().into());
    object.insert("trace_hash".into(), outcome.run.trace_hash().into());
    Value::Object(object)
}
