//! The posterior as a file: samples of the parameters and of what the model misses, what they belong to, and the bands of
//! the impacts that they were inferred from.

use std::path::Path;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};
use softanvil_kernel::{Parameter, Scenario};

use super::error_model::ErrorModel;
use super::waves::Sample;
use crate::calibration::problem::Problem;
use crate::calibration::variable::{Range, Scale, Variable};
use crate::failure::Failure;
use crate::measurement::band::Expected;
use crate::measurement::quantity::{COUNT, QUANTITIES};
use crate::text::number::four_digits;

/// Name of the file.
pub const NAME: &str = "posterior.json";
/// What the file says about its maker.
const GENERATOR: &str = "softanvil calibrate --uncertainty";
/// Column of a discrepancy: this and the key of its number.
const DISCREPANCY: &str = "discrepancy.";
/// Groups of parameters that say which impact is predicted and how it is read: any will do.
const FREE: [&str; 4] = ["impactor", "time", "measurement", "geometry"];
/// Of these groups, what the samples belong to all the same.
const BOUND: [&str; 1] = ["geometry.formulation"];

/// How far beside its samples the value of a scenario may lie, as a part of the range.
const BESIDE: f64 = 0.05;

/// A parameter of the samples.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub struct Column {
    /// Its name in problem files.
    pub name: String,
    /// SI unit.
    pub unit: String,
    /// Smallest value of the prior.
    pub min: f64,
    /// Largest value of the prior.
    pub max: f64,
    /// The scale on which the prior is flat.
    pub scale: Scale,
}

/// The file.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Posterior {
    /// What made it.
    generator: String,
    /// Version of the program.
    version: String,
    /// Digest of the problem.
    pub problem: String,
    /// The parameters of the scenario that the samples belong to, in SI.
    scenario: Map<String, Value>,
    /// What the samples are of.
    pub parameters: Vec<Column>,
    /// Keys of the numbers of which the model's discrepancy was inferred.
    pub discrepancies: Vec<String>,
    /// Relative standard deviation of a measurement, by quantity.
    pub noise: [f64; COUNT],
    /// How the chains and the emulator did.
    pub diagnostics: Value,
    /// The impacts of the problem.
    pub impacts: Vec<Expected>,
    /// Values of the parameters, then the discrepancies.
    samples: Vec<Vec<f64>>,
}

impl Posterior {
    /// Of `samples` for `problem`, in which the numbers of the file are rounded as it holds them; without impacts yet.
    pub fn new(problem: &Problem, errors: &ErrorModel, samples: &[Sample], diagnostics: Value) -> Self {
        let column = |variable: &Variable| Column {
            name: variable.name.clone(),
            unit: variable.unit.into(),
            min: variable.range.min,
            max: variable.range.max,
            scale: variable.range.scale,
        };
        let row = |sample: &Sample| -> Vec<f64> {
            sample.values.iter().chain(&sample.discrepancies).map(|value| rounded(*value)).collect()
        };
        Self {
            generator: GENERATOR.into(),
            version: env!("CARGO_PKG_VERSION").into(),
            problem: problem.digest(),
            scenario: parameters_of(&problem.scenario),
            parameters: problem.variables.iter().map(column).collect(),
            discrepancies: errors.inferred.iter().map(|i| QUANTITIES[*i].key.into()).collect(),
            noise: errors.noise,
            diagnostics,
            impacts: Vec::new(),
            samples: samples.iter().map(row).collect(),
        }
    }

    /// Reads the file at `path`.
    ///
    /// # Errors
    /// A file that cannot be read, or is no posterior, with its name.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let refuse = |error: String| Failure::Input(format!("{}: {error}", path.display()));
        let text = std::fs::read_to_string(path).map_err(|error| refuse(error.to_string()))?;
        Self::parse(&text).map_err(refuse)
    }

    /// The posterior in `text`.
    ///
    /// # Errors
    /// What is refused.
    pub fn parse(text: &str) -> Result<Self, String> {
        if text.trim().is_empty() {
            return Err(
                "the file is empty: expected a posterior, as softanvil calibrate --uncertainty writes it".into()
            );
        }
        let posterior: Self = serde_json::from_str(text).map_err(|error| {
            format!("this is no posterior: {error}; softanvil calibrate --uncertainty writes one, {NAME}")
        })?;
        posterior.check()?;
        Ok(posterior)
    }

    fn check(&self) -> Result<(), String> {
        if self.generator != GENERATOR {
            return Err(format!("generator = {:?} is refused: expected {GENERATOR:?}", self.generator));
        }
        if self.samples.is_empty() {
            return Err("samples is empty: there is nothing to predict with".into());
        }
        if let Some(key) = self.discrepancies.iter().find(|key| quantity(key).is_none()) {
            let keys = QUANTITIES.each_ref().map(|quantity| quantity.key).join(", ");
            return Err(format!("discrepancies: {key} is unknown; expected {keys}"));
        }
        let width = self.parameters.len() + self.discrepancies.len();
        for (number, sample) in self.samples.iter().enumerate() {
            if sample.len() != width {
                let (found, number) = (sample.len(), number + 1);
                return Err(format!("sample {number} has {found} numbers: expected {width}, one for each column"));
            }
            for (value, column) in sample.iter().zip(&self.parameters) {
                let Column { name, unit, min, max, .. } = column;
                if !(*min..=*max).contains(value) {
                    let legal = format!("expected {min} to {max} {unit}");
                    return Err(format!("sample {}: {name} = {value} {unit} is refused: {legal}", number + 1));
                }
            }
            if let Some(value) = sample[self.parameters.len()..].iter().find(|value| value.is_nan() || **value < 0.0) {
                return Err(format!("sample {}: a discrepancy of {value} is refused: expected 0 or more", number + 1));
            }
        }
        Ok(())
    }

    /// Whether the samples are of the material, core and formulation of `scenario`, whose own values lie among them.
    ///
    /// # Errors
    /// The first difference, with both values.
    pub fn check_belongs(&self, scenario: &Scenario) -> Result<Vec<Variable>, String> {
        let variables = self.variables(scenario)?;
        for (index, variable) in variables.iter().enumerate() {
            let (value, own) = (variable.get(scenario), self.values(index));
            let (low, high) =
                own.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (f64::min(l, v), f64::max(h, v)));
            let part = |value: f64| variable.range.part(value);
            if part(value) < part(low) - BESIDE || part(value) > part(high) + BESIDE || part(value).is_nan() {
                let name = &variable.name;
                let (value, low, high, unit) = (four_digits(value), four_digits(low), four_digits(high), variable.unit);
                return Err(format!(
                    "the posterior is of another drop: {name} = {value} {unit} here, and {low} to {high} {unit} in its \
                     samples"
                ));
            }
        }
        match self.difference(scenario, &variables) {
            Some(difference) => Err(format!("the posterior is of another drop: {difference}")),
            None => Ok(variables),
        }
    }

    /// The first parameter that is not the samples' and is another one in `scenario`.
    fn difference(&self, scenario: &Scenario, variables: &[Variable]) -> Option<String> {
        // Values of the searched parameters differ, and what follows from them.
        let mut own = scenario.clone();
        let values: Vec<f64> = (0..variables.len()).filter_map(|index| self.values(index).next()).collect();
        crate::calibration::variable::apply(variables, &values, &mut own).ok()?;
        let mut theirs = scenario.clone();
        for parameter in Parameter::of(scenario) {
            if let Some(value) = self.scenario.get(&parameter.name().to_string()).and_then(Value::as_f64) {
                let _ = parameter.set(&mut theirs, value);
            }
        }
        crate::calibration::variable::apply(variables, &values, &mut theirs).ok()?;
        let counts = |parameter: &Parameter| {
            let name = parameter.name().to_string();
            let free = FREE.contains(&parameter.name().group()) && !BOUND.contains(&name.as_str());
            let thickness = parameter.layer().is_some() && parameter.name().field() == "thickness";
            !free && !thickness
        };
        let found = Parameter::of(scenario).filter(counts).find(|parameter| {
            let (here, there) = (parameter.get(&own), parameter.get(&theirs));
            (here - there).abs() > 1e-6 * here.abs().max(there.abs())
        })?;
        let shown = |scenario: &Scenario| {
            let value = found.get(scenario);
            match found.labels().get(value as usize) {
                Some(label) => format!("\"{label}\""),
                None => format!("{} {}", four_digits(value), found.unit()),
            }
        };
        Some(format!("{} is {} here and {} in the posterior", found.name(), shown(&own), shown(&theirs)))
    }

    /// What the samples vary in `scenario`.
    ///
    /// # Errors
    /// A parameter that it does not have.
    pub fn variables(&self, scenario: &Scenario) -> Result<Vec<Variable>, String> {
        let variable = |column: &Column| {
            let Column { min, max, scale, .. } = *column;
            let range = Range { min, max, scale, start: None };
            Variable::new(scenario, &column.name, range).map_err(|error| format!("the posterior's {error}"))
        };
        self.parameters.iter().map(variable).collect()
    }

    /// The values of a column in all samples.
    pub fn values(&self, index: usize) -> impl Iterator<Item = f64> + '_ {
        self.samples.iter().map(move |sample| sample[index])
    }

    /// `count` of the samples at most, evenly from all.
    pub fn samples(&self, count: usize) -> Vec<Sample> {
        let (all, n) = (self.samples.len(), self.parameters.len());
        let count = count.min(all);
        let sample = |i: usize| {
            let (values, discrepancies) = self.samples[i * all / count].split_at(n);
            Sample { values: values.to_vec(), discrepancies: discrepancies.to_vec() }
        };
        (0..count).map(sample).collect()
    }

    /// How many samples there are.
    pub fn count(&self) -> usize {
        self.samples.len()
    }

    /// Titles of the columns: parameters, then discrepancies.
    pub fn titles(&self) -> Vec<String> {
        let parameters = self.parameters.iter().map(|column| column.name.clone());
        parameters.chain(self.discrepancies.iter().map(|key| format!("{DISCREPANCY}{key}"))).collect()
    }

    /// The errors that the samples state.
    pub fn errors(&self) -> ErrorModel {
        let inferred = self.discrepancies.iter().filter_map(|key| quantity(key)).collect();
        ErrorModel { numbers: Vec::new(), noise: self.noise, scales: [0.0; COUNT], inferred }
    }

    /// The text of the file, a line for each sample.
    pub fn text(&self) -> String {
        let compact = |value: &Value| value.to_string();
        let Ok(Value::Object(mut object)) = serde_json::to_value(self) else { return String::new() };
        let mut lists = String::new();
        for key in ["impacts", "samples"] {
            let rows = object.shift_remove(key).unwrap_or_default();
            let rows: Vec<String> = rows.as_array().into_iter().flatten().map(compact).collect();
            lists += &format!(",\n  \"{key}\": [\n{}\n  ]", rows.join(",\n"));
        }
        let head = format!("{:#}", Value::Object(object));
        format!("{}{lists}\n}}\n", head.strip_suffix("\n}").unwrap_or_default())
    }
}

fn quantity(key: &str) -> Option<usize> {
    QUANTITIES.iter().position(|quantity| quantity.key == key)
}

/// All parameters of a scenario by name, in SI.
fn parameters_of(scenario: &Scenario) -> Map<String, Value> {
    Parameter::of(scenario).map(|parameter| (parameter.name().to_string(), parameter.get(scenario).into())).collect()
}

/// Six significant digits, as the file holds them.
pub fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
