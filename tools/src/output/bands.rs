//! 90 % bands for people, and what lies outside of them.

use softanvil_kernel::Scenario;

use crate::measurement::band::{Band, Expected};
use crate::measurement::quantity::{COUNT, QUANTITIES, Quantity};
use crate::paper::validation::{TableComparison, Validation};
use crate::paper::{Case, DECIMALS};
use crate::text::table::{FIXED_BLANK, align_right, new_plain_table, text};
use crate::text::wrap::filled;

/// Index of the impulse.
const IMPULSE: usize = 3;
/// How much more the restitution has to fall in the experiment than in the model to tell of a mechanism.
const TELLING: f64 = 0.1;

/// The bands of the paper's drops beside what was measured; nothing where there is no posterior.
pub fn of_validation(validation: &Validation) -> String {
    let mut table =
        new_plain_table(&["energy", "90 % band of", "experiment", "Softanvil", "parameters", "with misfit", ""]);
    let mut rows = 0;
    for case in &validation.cases {
        let Some(expected) = &case.expected else { continue };
        for (i, quantity) in QUANTITIES.iter().enumerate() {
            rows += 1;
            let (parameters, measured) = (&expected.parameters[i], &expected.measured[i]);
            table.add_row([
                if i == 0 { format!("{} J", case.paper.energy) } else { String::new() },
                title(quantity),
                format!("{:.*}", DECIMALS[i], case.paper.experiment[i] * quantity.display_scale),
                format!("{:.*}", quantity.decimals, case.record.values[i] * quantity.display_scale),
                shown(quantity, parameters),
                shown(quantity, measured),
                marks(case.paper, expected, i).into(),
            ]);
        }
    }
    if rows == 0 {
        return String::new();
    }
    align_right(&mut table, 2..6);
    format!(
        "{}\nParameters: what they leave open. With misfit: where a measured number lies.\n* The experiment lies outside of the first band, ** of both.\n",
        text(&mut table)
    )
}

/// The bands of one drop.
pub fn of_drop(expected: &Expected) -> String {
    let mut table = new_plain_table(&["90 % band of", "parameters", "median", "with misfit"]);
    for (i, quantity) in QUANTITIES.iter().enumerate() {
        let (parameters, measured) = (&expected.parameters[i], &expected.measured[i]);
        table.add_row([
            title(quantity),
            shown(quantity, parameters),
            format!("{:.*}", quantity.decimals, parameters.median * quantity.display_scale),
            shown(quantity, measured),
        ]);
    }
    align_right(&mut table, 1..4);
    let about = format!(
        "By {} samples of the posterior: what the parameters leave open, and with it what the model misses and the noise of a \
         measurement.\n",
        expected.samples
    );
    format!("{}\n{}", text(&mut table), filled(&about))
}

/// Name and unit, which stay in one line.
fn title(quantity: &Quantity) -> String {
    format!("{} ({})", quantity.label, quantity.display_unit).replace(' ', &FIXED_BLANK.to_string())
}

fn shown(quantity: &Quantity, band: &Band) -> String {
    let of = |value: f64| format!("{:.*}", quantity.decimals, value * quantity.display_scale);
    format!("{}-{}", of(band.low), of(band.high))
}

/// Half of the last digit in which the paper prints a quantity, in SI.
fn half_digit(quantity: usize) -> f64 {
    0.5 * 10f64.powi(-(DECIMALS[quantity] as i32)) / QUANTITIES[quantity].display_scale
}

fn marks(paper: &Case, expected: &Expected, i: usize) -> &'static str {
    let holds = |band: &Band| band.holds(paper.experiment[i], half_digit(i));
    match (holds(&expected.parameters[i]), holds(&expected.measured[i])) {
        (_, false) => "**",
        (false, true) => "*",
        (true, true) => "",
    }
}

/// The remaining misses in two sentences: what lies outside of the bands, and what of the experiment the model lacks. Nothing
/// where there is no posterior.
pub fn misses(validation: &Validation) -> String {
    let cases: Vec<(&TableComparison, &Expected)> =
        validation.cases.iter().filter_map(|case| Some((case, case.expected.as_ref()?))).collect();
    let (Some(hard), Some(soft)) = (cases.first(), cases.last()) else { return String::new() };
    let outside = |mark: &str| {
        let of_case = |(case, expected): &(&TableComparison, &Expected)| {
            let (case, expected) = (*case, (*expected).clone());
            let own: Vec<String> = (0..COUNT)
                .filter(|i| marks(case.paper, &expected, *i).starts_with(mark))
                .map(|i| format!("{} ({:+.0} %)", QUANTITIES[i].label, case.softanvil_errors()[i]))
                .collect();
            (!own.is_empty()).then(|| format!("{} at {} J", list(&own), case.paper.energy))
        };
        list(&cases.iter().filter_map(of_case).collect::<Vec<_>>())
    };
    let (by_parameters, by_all) = (outside("*"), outside("**"));
    let and_all = match by_all.as_str() {
        "" => "all lie within the bands that hold what the model misses as well".into(),
        outside => format!("of the bands that hold what the model misses as well only {outside}"),
    };
    let first = match by_parameters.as_str() {
        "" => "No measured number lies outside of what the parameters leave open.".into(),
        outside => format!("Outside of what the parameters leave open lie {outside}; {and_all}."),
    };
    format!("{first} {}\n", mechanism([soft.0, hard.0]))
}

fn list(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// What the restitutions of the softest and of the hardest drop say.
fn mechanism(cases: [&TableComparison; 2]) -> String {
    let measured = cases.map(|case| restitution(&case.run.constants.scenario, &case.paper.experiment));
    let model = cases.map(|case| restitution(&case.run.constants.scenario, &case.record.values));
    let energies = cases.map(|case| case.paper.energy);
    let fall = |[soft, hard]: [f64; 2]| soft - hard;
    let facts = format!(
        "The restitution that the impulses imply goes from {:.2} at {} J to {:.2} at {} J in the experiment and from {:.2} to {:.2} \
         in the model",
        measured[0], energies[0], measured[1], energies[1], model[0], model[1]
    );
    match fall(measured) - fall(model) > TELLING {
        true => format!("{facts}: what is missing is a loss whose share grows with the load."),
        false => format!("{facts}, so that no loss of another kind shows in it."),
    }
}

/// Rebound speed over impact speed that an impulse and a duration imply: impulse = m (v0 + v1) + m g T.
fn restitution(scenario: &Scenario, values: &[f64; COUNT]) -> f64 {
    /// Index of the impact duration.
    const DURATION: usize = 2;
    let impactor = &scenario.impactor;
    let speed = impactor.start_speed();
    (values[IMPULSE] / impactor.mass - impactor.gravity * values[DURATION]) / speed - 1.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measurement::band::ForceBand;
    use crate::measurement::reading::Reading;
    use crate::paper::TABLE_1;

    /// The bands of the preset, from `low` to `high` times what was measured.
    fn validation(low: f64, high: f64) -> Validation {
        let preset = crate::presets::parse("study").unwrap();
        let expected = TABLE_1.iter().map(|case| {
            let band = |factor: [f64; 2]| {
                case.experiment.map(|value| Band { low: factor[0] * value, median: value, high: factor[1] * value })
            };
            Expected {
                energy: case.energy,
                samples: 1,
                parameters: band([low, high]),
                measured: band([0.5, 2.0]),
                force: ForceBand::default(),
            }
        });
        Validation::new(preset, Reading::PLAIN).unwrap().with(&expected.collect::<Vec<_>>())
    }

    #[test]
    fn what_lies_outside_is_told_in_two_sentences() {
        let inside = misses(&validation(0.9, 1.1));
        assert!(inside.starts_with("No measured number lies outside"), "{inside}");
        // All are 10 % off, and within the wide bands.
        let outside = misses(&validation(1.1, 1.2));
        assert!(outside.contains("peak force") && outside.contains("at 14.7 J"), "{outside}");
        assert!(outside.contains("all lie within the bands"), "{outside}");
        // Source: impulse = m (v0 + v1) + m g T with the printed numbers.
        assert!(outside.contains("from 0.50 at 4.9 J to 0.29 at 14.7 J in the experiment"), "{outside}");
        assert_eq!(outside.matches(". ").count(), 1, "{outside}");
        let table = of_validation(&validation(1.1, 1.2));
        assert_eq!(table.lines().filter(|line| line.trim_end().ends_with('*')).count(), 12, "{table}");
    }

    #[test]
    fn without_a_posterior_nothing_is_said() {
        let preset = crate::presets::parse("study").unwrap();
        let validation = Validation::new(preset, Reading::PLAIN).unwrap();
        assert_eq!((of_validation(&validation), misses(&validation)), (String::new(), String::new()));
    }
}
