//! What is stored of every simulation of a study, in SI: the lines of its CSV and the cases of its JSON.

use super::case::Outcome;
use super::results::Study;
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
pub static COLUMNS: [Column; 11] = [
    Column { key: "peak_force", unit: "N", read: |o| impact(o, o.values[0]) },
    Column { key: "max_deformation", unit: "m", read: |o| impact(o, o.values[1]) },
    Column { key: "impact_duration", unit: "s", read: |o| impact(o, o.values[2]) },
    Column { key: "impulse", unit: "N.s", read: |o| impact(o, o.values[3]) },
    Column { key: "restitution", unit: "1", read: |o| impact(o, o.restitution()) },
    Column { key: "held_force", unit: "N", read: Outcome::held_force },
    Column { key: "energy_friction", unit: "J", read: |o| Some(o.run.end().energy.friction) },
    Column { key: "energy_viscous", unit: "J", read: |o| Some(o.run.end().energy.viscous) },
    Column { key: "energy_slider_dissipation", unit: "J", read: |o| Some(o.run.end().energy.slider_dissipation) },
    Column { key: "elements", unit: "1", read: |o| Some(o.run.constants.grid.n_elem() as f64) },
    Column { key: "dt", unit: "s", read: |o| Some(o.run.constants.dt) },
];

fn impact(outcome: &Outcome, value: f64) -> Option<f64> {
    (outcome.held_force().is_none() && outcome.ending() != Ending::NoContact).then_some(value)
}

/// Titles of the columns of the CSV.
pub fn header(study: &Study) -> Vec<String> {
    let settings = study.settings.iter().map(|name| si(name, "").0);
    let numbers = COLUMNS.iter().map(|column| format!("{} [{}]", column.key, column.unit));
    std::iter::once("case".into())
        .chain(settings)
        .chain(numbers)
        .chain(["ending", "trace_hash", "failure"].map(String::from))
        .collect()
}

/// The line of case `number` of `study`.
pub fn record(study: &Study, number: usize, settings: &[String], outcome: &Result<Outcome, String>) -> Vec<String> {
    let number_of = |column: &Column| {
        let value = outcome.as_ref().ok().and_then(column.read);
        value.map_or(String::new(), |value| value.to_string())
    };
    let ends = match outcome {
        Ok(outcome) => [outcome.ending().key().into(), outcome.run.trace_hash(), String::new()],
        Err(reason) => [String::new(), String::new(), reason.clone()],
    };
    let settings = study.settings.iter().zip(settings).map(|(name, text)| si(name, text).1);
    let leading = std::iter::once(number.to_string()).chain(settings);
    leading.chain(COLUMNS.iter().map(number_of)).chain(ends).collect()
}

/// Units in which tables show settings, with their SI unit and its size.
const DISPLAYED: [(&str, &str, f64); 5] =
    [("mm", "m", 1e-3), ("ms", "s", 1e-3), ("kPa", "Pa", 1e3), ("MPa", "Pa", 1e6), ("%", "1", 1e-2)];

/// A setting, `name [unit]` and its text, in SI. Texts that are no numbers stay as they are.
pub fn si(name: &str, text: &str) -> (String, String) {
    let unit = name.rsplit_once(" [").and_then(|(plain, rest)| Some((plain, rest.strip_suffix(']')?)));
    let known = unit.and_then(|(plain, unit)| DISPLAYED.iter().find(|row| row.0 == unit).map(|row| (plain, row)));
    let Some((plain, (_, unit, scale))) = known else { return (name.into(), text.into()) };
    let number = text.parse::<f64>().map(|value| {
        // Twelve digits leave out the noise of the change of units.
        let rounded = format!("{:.11e}", value * scale).parse().unwrap_or(value * scale);
        f64::to_string(&rounded)
    });
    (format!("{plain} [{unit}]"), number.unwrap_or_else(|_| text.into()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::quantity::QUANTITIES;

    #[test]
    fn settings_are_stored_in_si() {
        for (name, text, stored) in [
            ("thickness [mm]", "14.7", ("thickness [m]", "0.0147")),
            ("G [MPa]", "0.06", ("G [Pa]", "60000")),
            ("limit stress [kPa]", "none", ("limit stress [Pa]", "none")),
            ("silicone.c10 [Pa]", "2e5", ("silicone.c10 [Pa]", "2e5")),
            ("made by", "core", ("made by", "core")),
        ] {
            assert_eq!(si(name, text), (stored.0.into(), stored.1.into()));
        }
    }

    #[test]
    fn the_four_numbers_come_first_under_their_keys() {
        assert!(QUANTITIES.iter().zip(&COLUMNS).all(|(quantity, column)| quantity.key == column.key));
    }
}
