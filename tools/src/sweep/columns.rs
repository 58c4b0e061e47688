//! What is stored of every simulation of a sweep, in SI: the lines of its CSV and the cases of its JSON.

use super::Sweep;
use super::case::Outcome;
use crate::run::Ending;

/// A number that is stored.
pub struct Column {
    /// Name.
    pub key: &'static str,
    /// SI unit.
    pub unit: &'static str,
    /// Reads it; none where it makes no sense.
    pub read: fn(&Outcome) -> Option<f64>,
}

/// Every number; a press has a force that holds it in place of the numbers of an impact.
pub static COLUMNS: [Column; 13] = [
    Column { key: "peak_force", unit: "N", read: |o| impact(o, o.values[0]) },
    Column { key: "max_deformation", unit: "m", read: |o| impact(o, o.values[1]) },
    Column { key: "impact_duration", unit: "s", read: |o| impact(o, o.values[2]) },
    Column { key: "impulse", unit: "N.s", read: |o| impact(o, o.values[3]) },
    Column { key: "restitution", unit: "1", read: |o| impact(o, o.restitution()) },
    Column { key: "vibration", unit: "1", read: |o| impact(o, o.vibration()) },
    Column { key: "held_force", unit: "N", read: Outcome::held_force },
    Column { key: "energy_friction", unit: "J", read: |o| Some(o.run.end().energy.friction) },
    Column { key: "energy_viscous", unit: "J", read: |o| Some(o.run.end().energy.viscous) },
    Column { key: "energy_slider_dissipation", unit: "J", read: |o| Some(o.run.end().energy.slider_dissipation) },
    Column { key: "elements", unit: "1", read: |o| Some(o.run.constants.grid.n_elem() as f64) },
    Column { key: "element_size", unit: "m", read: |o| Some(o.run.constants.scenario.mesh.element_size) },
    Column { key: "dt", unit: "s", read: |o| Some(o.run.constants.dt) },
];

fn impact(outcome: &Outcome, value: f64) -> Option<f64> {
    (outcome.held_force().is_none() && outcome.ending() != Ending::NoContact).then_some(value)
}

/// Titles of the columns of the CSV.
pub fn header(sweep: &Sweep) -> Vec<String> {
    let numbers = COLUMNS.iter().map(|column| format!("{} [{}]", column.key, column.unit));
    std::iter::once("case".into())
        .chain(sweep.headings().into_iter().map(String::from))
        .chain(numbers)
        .chain(["ending", "trace_hash", "failure"].map(String::from))
        .collect()
}

/// The line of case `number` with its `settings`.
pub fn record(number: usize, settings: &[String], outcome: &Result<Outcome, String>) -> Vec<String> {
    let number_of = |column: &Column| {
        let value = outcome.as_ref().ok().and_then(column.read);
        value.map_or(String::new(), |value| value.to_string())
    };
    let ends = match outcome {
        Ok(outcome) => [outcome.ending().key().into(), outcome.run.trace_hash(), String::new()],
        Err(reason) => [String::new(), String::new(), reason.clone()],
    };
    let leading = std::iter::once(number.to_string()).chain(settings.iter().cloned());
    leading.chain(COLUMNS.iter().map(number_of)).chain(ends).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::quantity::QUANTITIES;

    #[test]
    fn the_four_numbers_come_first_under_their_keys() {
        assert!(QUANTITIES.iter().zip(&COLUMNS).all(|(quantity, column)| quantity.key == column.key));
    }
}
