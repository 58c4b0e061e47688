//! What a search has found, for people and for other programs.

use std::fmt::Write;
use std::path::Path;

use serde_json::{Map, Value, json};

use super::log::Entry;
use super::objective::{Evaluation, evaluate, scenario};
use super::problem::Problem;
use super::search::best;
use super::spread::{EQUALLY_GOOD, Spread, spread};
use crate::failure::Failure;
use crate::quantity::QUANTITIES;
use crate::scenario_file;
use crate::staging;
use crate::table::{align_right, four_digits, new_table};
use crate::validation::error_percent;

/// The best values, evaluated once more, and how far they are pinned.
pub struct Found {
    /// The evaluation in the log.
    pub entry: Entry,
    /// The same, now.
    pub evaluation: Evaluation,
    /// Evaluations done.
    pub evaluations: usize,
    /// Evaluations that are about as good.
    pub equally_good: usize,
    /// Their spread, by variable.
    pub spread: Vec<Spread>,
}

impl Found {
    /// Takes stock of the evaluations; none if there is none.
    pub fn new(problem: &Problem, entries: &[Entry]) -> Option<Self> {
        let entry = best(entries)?.clone();
        let evaluation = evaluate(problem, &entry.values);
        let (equally_good, spread) = spread(problem, entries);
        Some(Self { entry, evaluation, evaluations: entries.len(), equally_good, spread })
    }

    /// Writes `best.toml`, `summary.json` and `summary.txt` to `folder`; returns the text.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn write(&self, problem: &Problem, folder: &Path) -> Result<String, Failure> {
        let scenario = scenario(problem, &self.entry.values).map_err(Failure::Failed)?;
        let text = self.text(problem);
        let [toml, json_file, summary] = ["best.toml", "summary.json", "summary.txt"].map(|name| folder.join(name));
        let files = [
            (toml.as_path(), scenario_file::to_toml(&scenario).into_bytes()),
            (json_file.as_path(), crate::json::text(&self.json(problem)).into_bytes()),
            (summary.as_path(), text.clone().into_bytes()),
        ];
        staging::write_files(&files).map_err(|(path, error)| Failure::writing(&path, error))?;
        Ok(text)
    }

    /// The tables for people.
    pub fn text(&self, problem: &Problem) -> String {
        let mut text = format!("{}\n\n{}\n", self.parameters(problem), self.impacts(problem));
        let _ = writeln!(
            text,
            "\nScore {:.3}, mean |error| of all measured numbers {:.2} %, after {} evaluations.\nSpread: of the {} \
             evaluations with scores up to {EQUALLY_GOOD} times the best; as a part of the range, 0 is pinned, 1 is free.\n\
             Compared force: {}{}.",
            self.entry.score,
            self.evaluation.mean_error,
            self.evaluations,
            self.equally_good,
            problem.objective.force.label(),
            problem.objective.cfc.map_or(String::new(), |class| format!(", filtered by CFC {class}")),
        );
        if self.evaluation.score != self.entry.score {
            let _ = writeln!(
                text,
                "The log says {:.3} for the best values and this program {:.3}: the log is of another version of it.",
                self.entry.score, self.evaluation.score
            );
        }
        for demand in self.demands(problem) {
            let _ = writeln!(text, "Prior: {}", demand);
        }
        text
    }

    fn demands(&self, problem: &Problem) -> Vec<String> {
        let Some(prior) = problem.prior else { return Vec::new() };
        let Ok(scenario) = scenario(problem, &self.entry.values) else { return Vec::new() };
        let line = |demand: &super::prior::Demand| {
            format!(
                "{}: measured {:.3} MPa, model {:.3} MPa",
                demand.label,
                demand.measured * 1e-6,
                demand.model * 1e-6
            )
        };
        prior.demands(&scenario.silicone).iter().map(line).collect()
    }

    fn parameters(&self, problem: &Problem) -> String {
        let mut table = new_table(&["parameter", "best", "unit", "range", "spread", "of range"]);
        for ((variable, value), spread) in problem.variables.iter().zip(&self.entry.values).zip(&self.spread) {
            let bound = if *value == variable.range.min || *value == variable.range.max { " (bound)" } else { "" };
            table.add_row([
                variable.name.clone(),
                format!("{}{bound}", four_digits(*value)),
                variable.unit.into(),
                format!("{} to {}", four_digits(variable.range.min), four_digits(variable.range.max)),
                format!("{} to {}", four_digits(spread.min), four_digits(spread.max)),
                format!("{:.2}", spread.part),
            ]);
        }
        align_right(&mut table, 1..2);
        align_right(&mut table, 5..6);
        table.trim_fmt()
    }

    fn impacts(&self, problem: &Problem) -> String {
        let mut table = new_table(&["impact", "quantity", "measured", "model", "error", "counts"]);
        for (target, simulated) in problem.targets.iter().zip(&self.evaluation.impacts) {
            for (i, quantity) in QUANTITIES.iter().enumerate() {
                let shown = |value: f64| format!("{:.*}", quantity.decimals, value * quantity.display_scale);
                let (value, measured) = (simulated.values[i], target.measured[i]);
                table.add_row([
                    format!("{} J", target.energy),
                    format!("{} ({})", quantity.label, quantity.display_unit),
                    measured.map_or(String::new(), shown),
                    shown(value),
                    measured.map_or(String::new(), |measured| format!("{:+.1} %", error_percent(value, measured))),
                    if target.counts[i] { "yes" } else { "no" }.into(),
                ]);
            }
            if let Some(curve) = simulated.curve {
                let rating = format!("R2 {:.3}, CORA {:.3}", curve.r_squared, curve.rating());
                let difference = format!("{:+.1} %", 100.0 * curve.difference);
                let counts = if target.predict { "no" } else { "yes" };
                table.add_row([
                    format!("{} J", target.energy),
                    "trace".into(),
                    String::new(),
                    rating,
                    difference,
                    counts.into(),
                ]);
            }
        }
        align_right(&mut table, 2..5);
        table.trim_fmt()
    }

    fn json(&self, problem: &Problem) -> Value {
        let parameter = |(index, value): (usize, &f64)| {
            let (variable, spread) = (&problem.variables[index], &self.spread[index]);
            let numbers = json!({
                "value": value, "unit": variable.unit, "min": variable.range.min, "max": variable.range.max,
                "spread": {"min": spread.min, "median": spread.median, "max": spread.max, "part": spread.part},
            });
            (variable.name.clone(), numbers)
        };
        let impact = |(target, simulated): (&super::target::Target, &super::objective::Simulated)| {
            let mut object = Map::new();
            object.insert("energy".into(), target.energy.into());
            for (i, quantity) in QUANTITIES.iter().enumerate() {
                let error = target.measured[i].map(|measured| error_percent(simulated.values[i], measured));
                let numbers = json!({"value": simulated.values[i], "measured": target.measured[i], "error_percent": error,
                    "counts": target.counts[i]});
                object.insert(quantity.key.into(), numbers);
            }
            Value::Object(object)
        };
        json!({
            "score": self.entry.score,
            "mean_error_percent": self.evaluation.mean_error,
            "evaluations": self.evaluations,
            "equally_good": self.equally_good,
            "parameters": self.entry.values.iter().enumerate().map(parameter).collect::<Map<_, _>>(),
            "impacts": problem.targets.iter().zip(&self.evaluation.impacts).map(impact).collect::<Vec<_>>(),
        })
    }
}
