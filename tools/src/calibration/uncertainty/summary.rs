//! What a posterior tells, for people and for other programs.

use serde_json::{Map, Value, json};

use super::normal::quantile;
use super::outcome::Outcome;
use super::posterior::Posterior;
use super::waves::Inferred;
use crate::calibration::variable::{Range, Scale};
use crate::measurement::band::TAIL;
use crate::text::number::four_digits;
use crate::text::table::{align_right, new_plain_table, text as table_text};
use crate::text::wrap::filled;

/// Width of a 90 % interval over that of the prior below which the data determine a parameter, and above which they say
/// nothing of it.
const DETERMINED: (f64, f64) = (1.0 / 3.0, 0.8);

/// What the samples say about one column.
pub struct Marginal {
    /// Mean.
    pub mean: f64,
    /// 5 %, 50 % and 95 % quantiles.
    pub quantiles: [f64; 3],
    /// Width of the 90 % interval over that of the prior, on its scale; none of a discrepancy.
    pub part: Option<f64>,
}

/// The marginals of all columns.
pub fn marginals(posterior: &Posterior) -> Vec<Marginal> {
    let of = |index: usize| {
        let values: Vec<f64> = posterior.values(index).collect();
        let quantiles = [TAIL, 0.5, 1.0 - TAIL].map(|part| quantile(&values, part));
        let part = posterior.parameters.get(index).map(|column| {
            let on_scale = |value: f64| match column.scale {
                Scale::Linear => value,
                Scale::Log => value.ln(),
            };
            let [low, _, high] = quantiles.map(on_scale);
            (high - low) / ((1.0 - 2.0 * TAIL) * (on_scale(column.max) - on_scale(column.min)))
        });
        Marginal { mean: values.iter().sum::<f64>() / values.len() as f64, quantiles, part }
    };
    (0..posterior.titles().len()).map(of).collect()
}

/// Correlations of all columns.
pub fn correlations(posterior: &Posterior) -> Vec<Vec<f64>> {
    let columns = posterior.titles().len();
    let deviations: Vec<Vec<f64>> = (0..columns)
        .map(|index| {
            let values: Vec<f64> = posterior.values(index).collect();
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            values.iter().map(|value| value - mean).collect()
        })
        .collect();
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let of = |a: &Vec<f64>, b: &Vec<f64>| product(a, b) / (product(a, a) * product(b, b)).sqrt();
    deviations.iter().map(|a| deviations.iter().map(|b| of(a, b)).collect()).collect()
}

fn verdict(part: f64) -> &'static str {
    match part {
        part if part < DETERMINED.0 => "determined",
        part if part < DETERMINED.1 => "narrowed",
        _ => "open",
    }
}

/// Whether the median of a parameter's samples lies so near an end of its range that the range decides.
fn near_bound(posterior: &Posterior, index: usize, marginal: &Marginal) -> bool {
    let Some(column) = posterior.parameters.get(index) else { return false };
    let range = Range { min: column.min, max: column.max, scale: column.scale, start: None };
    range.part(marginal.quantiles[0]) < 0.02 || range.part(marginal.quantiles[2]) > 0.98
}

/// The tables for people.
pub fn text(posterior: &Posterior, inferred: &Inferred) -> String {
    let (titles, marginals) = (posterior.titles(), marginals(posterior));
    let mut table = new_plain_table(&["posterior of", "mean", "5 %", "median", "95 %", "unit", "of prior", ""]);
    for (index, (title, marginal)) in titles.iter().zip(&marginals).enumerate() {
        let [low, median, high] = marginal.quantiles.map(four_digits);
        let bound = if near_bound(posterior, index, marginal) { "*" } else { "" };
        table.add_row([
            title.clone(),
            four_digits(marginal.mean),
            low,
            median,
            high,
            posterior.parameters.get(index).map_or("1".into(), |column| column.unit.clone()),
            marginal.part.map_or(String::new(), |part| format!("{part:.2}")),
            marginal.part.map_or(String::new(), |part| format!("{}{bound}", verdict(part))),
        ]);
    }
    align_right(&mut table, 1..5);
    align_right(&mut table, 6..7);
    let remark = match (0..marginals.len()).any(|index| near_bound(posterior, index, &marginals[index])) {
        true => "* The interval reaches an end of the range: there the prior decides, and not the data.\n",
        false => "",
    };
    format!(
        "{}\n{}\n{}\n{}",
        table_text(&mut table),
        filled(remark),
        correlation_table(posterior, &titles),
        filled(&how(posterior, inferred))
    )
}

fn correlation_table(posterior: &Posterior, titles: &[String]) -> String {
    let numbers: Vec<String> = (1..=titles.len()).map(|number| number.to_string()).collect();
    let header = ["correlation"].into_iter().chain(numbers.iter().map(String::as_str)).collect::<Vec<_>>();
    let mut table = new_plain_table(&header);
    for (number, (title, row)) in titles.iter().zip(correlations(posterior)).enumerate() {
        let cells = row.iter().enumerate().map(|(column, value)| match column {
            column if column <= number => format!("{value:+.2}"),
            _ => String::new(),
        });
        table.add_row([format!("{} {title}", number + 1)].into_iter().chain(cells));
    }
    align_right(&mut table, 1..1 + titles.len());
    table_text(&mut table)
}

/// How it came about.
fn how(posterior: &Posterior, inferred: &Inferred) -> String {
    let (chains, emulation) = (&inferred.diagnostics, &inferred.emulation);
    let largest = emulation.held_out_error.iter().copied().fold(0.0, f64::max);
    format!(
        "{} samples. Chains: acceptance {:.2}, R-hat {:.3}, autocorrelation time {:.0} moves, about {:.0} independent samples. \
         Emulator: degree {}, relative error at {} samples that it had not seen {:.2} % at most (root mean square of a \
         number), {:.0} % of them count after they were weighted by the likelihood of their simulations; {} points simulated \
         in {} waves.\n",
        posterior.count(),
        chains.acceptance,
        chains.r_hat,
        chains.autocorrelation_time,
        chains.effective_samples,
        emulation.degree,
        emulation.held_out,
        100.0 * largest,
        100.0 * emulation.counting,
        emulation.simulated,
        emulation.waves,
    )
}

/// What came of an inference, for people.
pub fn of_outcome(outcome: &Outcome) -> String {
    match outcome {
        Outcome::Posterior(_, text) => text.clone(),
        Outcome::Refused(why) => filled(&format!("! No posterior: {why}.\n")),
        Outcome::Interrupted => "! No posterior: interrupted; the same command continues.\n".into(),
    }
}

/// The same for other programs.
pub fn json(outcome: &Outcome) -> Value {
    match outcome {
        Outcome::Posterior(posterior, _) => of_posterior(posterior),
        Outcome::Refused(why) => json!({ "refused": why }),
        Outcome::Interrupted => json!({ "refused": "interrupted" }),
    }
}

fn of_posterior(posterior: &Posterior) -> Value {
    let titles = posterior.titles();
    let of = |(index, (title, marginal)): (usize, (&String, &Marginal))| {
        let [low, median, high] = marginal.quantiles;
        let row = json!({
            "mean": marginal.mean, "low": low, "median": median, "high": high,
            "unit": posterior.parameters.get(index).map_or("1", |column| column.unit.as_str()),
            "part_of_prior": marginal.part, "verdict": marginal.part.map(verdict),
            "reaches_bound": near_bound(posterior, index, marginal),
        });
        (title.clone(), row)
    };
    let marginals = marginals(posterior);
    let rows: Map<String, Value> = titles.iter().zip(&marginals).enumerate().map(of).collect();
    json!({
        "samples": posterior.count(),
        "marginals": rows,
        "correlations": { "columns": titles, "rows": correlations(posterior) },
        "diagnostics": posterior.diagnostics,
    })
}
