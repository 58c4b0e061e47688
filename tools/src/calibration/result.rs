//! What a search has found, for people and for other programs.

use std::fmt::Write;

use serde_json::{Map, Value, json};
use softanvil_records::understood::Understood;

use super::convergence::{Convergence, Descent};
use super::determined::{self, Determined};
use super::log::Entry;
use super::material_test::MaterialTest;
use super::objective::{Evaluation, evaluate, scenario};
use super::problem::Problem;
use super::search::best;
use super::spread::{EQUALLY_GOOD, Spread, spread};
use super::uncertainty::{Outcome, summary};
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::measurement::errors::error_percent;
use crate::measurement::quantity::QUANTITIES;
use crate::run::{Ending, MARK};
use crate::scenario_file;
use crate::text::number::four_digits;
use crate::text::table::{align_right, new_table, text as table_text};
use crate::text::wrap::filled;

/// Names of the files of a result.
pub const FILES: [&str; 3] = ["best.toml", "summary.json", "summary.txt"];

/// What is said in place of a mean of no numbers.
const TRACES_ALONE: &str = "No numbers were measured, traces alone";

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
    /// Their spread, by variable: of meaning once the search has converged.
    pub spread: Vec<Spread>,
    /// The descents of the search.
    pub descents: Vec<Descent>,
    /// How far it has come.
    pub convergence: Convergence,
}

impl Found {
    /// Takes stock of the evaluations and the descents that made them; none if there is none.
    pub fn new(problem: &Problem, entries: &[Entry], descents: Vec<Descent>) -> Option<Self> {
        let entry = best(entries)?.clone();
        let evaluation = evaluate(problem, &entry.values);
        let (equally_good, spread) = spread(problem, entries);
        let convergence = Convergence::of(&descents);
        Some(Self { entry, evaluation, evaluations: entries.len(), equally_good, spread, descents, convergence })
    }

    /// Writes [`FILES`] to `folder`, with what a posterior tells where one was asked for; returns the text.
    ///
    /// # Errors
    /// A file that is not to be replaced, or cannot be written.
    pub fn write(
        &self,
        problem: &Problem,
        uncertainty: Option<&Outcome>,
        folder: &mut Folder,
    ) -> Result<String, Failure> {
        let scenario = scenario(problem, &self.entry.values).map_err(Failure::Failed)?;
        let mut text = self.text(problem);
        let mut json = self.json(problem);
        if let Some(outcome) = uncertainty {
            text = format!("{}\n\n{}", text.trim_end(), summary::of_outcome(outcome));
            json["uncertainty"] = summary::json(outcome);
        }
        let toml = self.head(problem) + &scenario_file::to_toml(&scenario);
        let contents = [toml, crate::output::json::text(&json), text.clone()];
        let files = FILES.map(String::from).into_iter().zip(contents.map(String::into_bytes));
        folder.write(&files.collect::<Vec<_>>())?;
        Ok(text)
    }

    /// Where the best scenario comes from, as comments of its file.
    fn head(&self, problem: &Problem) -> String {
        let (score, evaluations) = (self.entry.score, self.evaluations);
        let found = format!("The best of {evaluations} evaluations by `softanvil calibrate`, score {score:.3}.\n");
        let impacts = match problem.has_numbers() {
            true => format!("Mean |error| of all measured numbers {:.2} %.\n", self.evaluation.mean_error),
            false => format!("{TRACES_ALONE}.\n"),
        };
        let lines = found + &impacts + &self.material_lines(problem) + &self.convergence.text(problem.variables.len());
        let lines = lines + &self.bounds(problem) + &self.determined(problem);
        lines.lines().map(|line| format!("# {line}\n")).collect::<String>() + "#\n"
    }

    /// The values that lie on a bound of their range, in lines.
    fn bounds(&self, problem: &Problem) -> String {
        let values = problem.variables.iter().zip(&self.entry.values);
        let lines = values.filter_map(|(variable, value)| {
            let (name, unit, bound) = (&variable.name, variable.unit, variable.bound(*value)?);
            let value = four_digits(*value);
            Some(format!("! {name} = {value} {unit} lies on the {bound} of its range: the best may lie beyond it.\n"))
        });
        lines.collect()
    }

    /// The tables for people.
    pub fn text(&self, problem: &Problem) -> String {
        let mut text = format!("{}\n\n{}\n\n", self.parameters(problem), self.impacts(problem));
        if !problem.material_tests.is_empty() {
            let _ = write!(text, "{}\n\n", self.material_tests(problem));
        }
        text += &filled(&(self.convergence.text(problem.variables.len()) + &self.bounds(problem)));
        text += &filled(&self.determined(problem));
        let (factor, points) = EQUALLY_GOOD;
        let spread = match self.convergence.is_reached() {
            true => format!(
                "Spread: of the {} evaluations with scores up to {factor} times the best or {points} points above it; as a \
                 part of the range, 0 is pinned, 1 is free.\n",
                self.equally_good
            ),
            false => "Spread: untold, because it says nothing before the search has converged.\n".into(),
        };
        let counted = problem.targets.iter().flat_map(|target| target.counts).filter(|counts| *counts).count();
        let searched = problem.variables.len();
        let channel = problem.objective.cfc.map_or(String::new(), |class| format!(", filtered by CFC {class}"));
        let counted = match problem.has_numbers() {
            true => format!("{counted} numbers counted"),
            false => TRACES_ALONE.to_lowercase(),
        };
        let mean = match problem.has_numbers() {
            true => format!(" mean |error| of all measured numbers {:.2} %,", self.evaluation.mean_error),
            false => String::new(),
        };
        text += &filled(&format!(
            "Score {:.3},{mean} after {} evaluations: {searched} parameter{} searched, {counted}.\n{spread}Compared force: \
             {}{channel}.",
            self.entry.score,
            self.evaluations,
            if searched == 1 { "" } else { "s" },
            problem.objective.force.label(),
        ));
        if problem.targets.iter().any(|target| target.trace.is_some()) {
            text += "Traces are aligned with the simulated forces by the largest cross-correlation.\n";
        }
        if self.evaluation.impacts.iter().any(|impact| matches!(impact.ending, Ending::InContact)) {
            let _ = writeln!(text, "! Numbers marked {MARK} are cut off in contact: the simulated time is too short.");
        }
        for demand in self.demands(problem) {
            let _ = writeln!(text, "Prior: {}", demand);
        }
        for target in &problem.targets {
            if let Some(understood) = &target.understood {
                let _ = write!(text, "\nMeasured trace of {} J:\n{understood}", target.energy);
            }
        }
        text
    }

    /// What the data determine, in lines; nothing before the search has converged.
    fn determined(&self, problem: &Problem) -> String {
        if self.convergence.is_reached() { determined::text(problem, &self.spread) } else { String::new() }
    }

    /// The material tests with what the best values give, Pa.
    fn tested<'a>(&self, problem: &'a Problem) -> Vec<(&'a MaterialTest, f64)> {
        let Ok(scenario) = scenario(problem, &self.entry.values) else { return Vec::new() };
        problem.material_tests.iter().map(|test| (test, test.model(&scenario))).collect()
    }

    fn material_tests(&self, problem: &Problem) -> String {
        let mut table = new_table(&["material test", "of", "measured (MPa)", "model (MPa)", "distance", "counts"]);
        let mega = |value: f64| format!("{:.3}", 1e-6 * value);
        for (test, model) in self.tested(problem) {
            table.add_row([
                test.name.clone(),
                format!("{} in {}", test.read(), test.course()),
                format!("{} +- {}", mega(test.value), mega(test.standard_deviation)),
                mega(model),
                format!("{:+.1} sd", test.distance(model)),
                if test.predict { "no" } else { "yes" }.into(),
            ]);
        }
        align_right(&mut table, 2..5);
        table_text(&mut table)
    }

    /// The same, a line each.
    fn material_lines(&self, problem: &Problem) -> String {
        let line = |(test, model): (&MaterialTest, f64)| {
            let (measured, scatter) = (1e-6 * test.value, 1e-6 * test.standard_deviation);
            let (model, distance) = (1e-6 * model, test.distance(model));
            let name = &test.name;
            format!("{name}: {model:.3} MPa, measured {measured:.3} +- {scatter:.3} MPa, {distance:+.1} sd.\n")
        };
        self.tested(problem).into_iter().map(line).collect()
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
        prior.demands(&scenario.layers[0].material).iter().map(line).collect()
    }

    fn parameters(&self, problem: &Problem) -> String {
        let mut table = new_table(&["parameter", "best", "unit", "range", "spread", "of range"]);
        for ((variable, value), spread) in problem.variables.iter().zip(&self.entry.values).zip(&self.spread) {
            let bound = variable.bound(*value).map_or(String::new(), |bound| format!(" ({bound})"));
            let told = |text: String| if self.convergence.is_reached() { text } else { "-".into() };
            table.add_row([
                variable.name.clone(),
                format!("{}{bound}", four_digits(*value)),
                variable.unit.into(),
                format!("{} to {}", four_digits(variable.range.min), four_digits(variable.range.max)),
                told(format!("{} to {}", four_digits(spread.min), four_digits(spread.max))),
                told(format!("{:.2}", spread.part)),
            ]);
        }
        align_right(&mut table, 1..2);
        align_right(&mut table, 5..6);
        table_text(&mut table)
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
                    simulated.ending.marked(quantity.output, shown(value)),
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
        table_text(&mut table)
    }

    fn json(&self, problem: &Problem) -> Value {
        let parameter = |(index, value): (usize, &f64)| {
            let (variable, spread) = (&problem.variables[index], &self.spread[index]);
            let told = |number: f64| self.convergence.is_reached().then_some(number);
            let numbers = json!({
                "value": value, "unit": variable.unit, "min": variable.range.min, "max": variable.range.max,
                "bound": variable.bound(*value),
                "spread": {"min": told(spread.min), "median": told(spread.median), "max": told(spread.max),
                    "part": told(spread.part)},
                "determined": self.convergence.is_reached().then(|| Determined::of(spread).key()),
            });
            (variable.name.clone(), numbers)
        };
        let impact = |(target, simulated): (&super::target::Target, &super::objective::Simulated)| {
            let mut object = Map::new();
            object.insert("energy".into(), target.energy.into());
            object.insert("ending".into(), simulated.ending.key().into());
            object.insert("trace".into(), target.understood.as_ref().map(Understood::json).into());
            for (i, quantity) in QUANTITIES.iter().enumerate() {
                let error = target.measured[i].map(|measured| error_percent(simulated.values[i], measured));
                let numbers = json!({"value": simulated.values[i], "measured": target.measured[i], "error_percent": error,
                    "counts": target.counts[i]});
                object.insert(quantity.key.into(), numbers);
            }
            Value::Object(object)
        };
        let material_test = |(test, model): (&MaterialTest, f64)| {
            json!({ "name": test.name, "layer": test.layer, "load": test.load, "quantity": test.quantity, "strain": test.strain,
                "rate": test.rate, "hold": test.hold, "measured": test.value, "standard_deviation": test.standard_deviation,
                "model": model, "distance": test.distance(model), "counts": !test.predict })
        };
        json!({
            "score": self.entry.score,
            "mean_error_percent": self.evaluation.mean_error,
            "evaluations": self.evaluations,
            "convergence": self.convergence.json(&self.descents),
            "equally_good": self.equally_good,
            "parameters": self.entry.values.iter().enumerate().map(parameter).collect::<Map<_, _>>(),
            "material_tests": self.tested(problem).into_iter().map(material_test).collect::<Vec<_>>(),
            "impacts": problem.targets.iter().zip(&self.evaluation.impacts).map(impact).collect::<Vec<_>>(),
        })
    }
}
