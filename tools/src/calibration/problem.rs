//! The problem file: what is searched for, where, and by which score.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};
use softanvil_kernel::preset::Preset;
use softanvil_kernel::{Changes, Parameter, Scenario};

use super::material_test::MaterialTest;
use super::possible::Possible;
use super::prior::Prior;
use super::target::{Impact, Target, read_impacts};
use super::uncertainty::options::UncertaintyOptions;
use super::variable::{Range, Variable, apply, check_fits_impacts};
use crate::failure::Failure;
use crate::files::folder;
use crate::measurement::quantity::{COUNT, QUANTITIES};
use crate::measurement::series;
use crate::measurement::series::Sensor;
use crate::run::Until;
use crate::scenario_file::assign::{self, Given, Written};
use crate::scenario_file::names;
use crate::{presets, scenario_file};

/// The file, as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    #[serde(default = "study")]
    preset: String,
    scenario: Option<PathBuf>,
    #[serde(default)]
    fixed: BTreeMap<String, Value>,
    search: SearchOptions,
    #[serde(default)]
    objective: ObjectiveOptions,
    prior: Option<Prior>,
    #[serde(default)]
    uncertainty: UncertaintyOptions,
    parameters: BTreeMap<String, Value>,
    #[serde(default)]
    impact: Vec<Impact>,
    impacts: Option<PathBuf>,
    #[serde(default)]
    material_test: Vec<MaterialTest>,
}

fn study() -> String {
    "study".into()
}

/// How to search.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SearchOptions {
    /// Seed of the random numbers.
    #[serde(default = "one")]
    pub seed: u64,
    /// Evaluations to spend.
    pub evaluations: usize,
    /// Evaluations in a generation; 0 for 4 + 3 ln n of n parameters.
    #[serde(default)]
    pub population: usize,
    /// First standard deviation, as a part of every range.
    #[serde(default = "fifth")]
    pub step: f64,
}

fn one() -> u64 {
    1
}

fn fifth() -> f64 {
    0.2
}

/// What the score is made of.
#[derive(Clone, Debug, Deserialize, Serialize)]
#[serde(deny_unknown_fields, default)]
pub struct ObjectiveOptions {
    /// Share of the root mean square of the errors in the score; the rest is the mean of their absolute values.
    pub root_mean_square: f64,
    /// Weights of the errors, by key of the number, and of the difference of a trace; 1 if left out.
    pub weights: BTreeMap<String, f64>,
    /// Errors, %, by key of the number, beyond which the excess counts once more in full.
    pub limits: BTreeMap<String, f64>,
    /// Which force is compared with the measured one.
    pub force: Sensor,
    /// Channel frequency class of the filter on it, Hz; none if left out.
    pub cfc: Option<f64>,
    /// Most steps per sampling interval of 50 us: stiffer materials are refused, for the sake of speed. 0 allows all.
    pub steps_per_sample: u32,
    /// Smallest Poisson's ratio that a layer may have at once, before anything has relaxed; none if left out.
    pub poissons_ratio_at_once: Option<f64>,
    /// Whether an error counts only as far as it is outside the interval that the printed number has been rounded from.
    pub rounding: bool,
    /// Points of score for a mean square distance of one from the material tests, in standard deviations.
    pub material_weight: f64,
}

impl Default for ObjectiveOptions {
    fn default() -> Self {
        Self {
            root_mean_square: 0.0,
            weights: BTreeMap::new(),
            limits: BTreeMap::new(),
            force: Sensor::default(),
            cfc: None,
            steps_per_sample: 0,
            poissons_ratio_at_once: None,
            rounding: false,
            material_weight: 1.0,
        }
    }
}

/// Key of the weight of a trace's difference.
pub const TRACE: &str = "trace";

impl ObjectiveOptions {
    /// Weights in the order of [`QUANTITIES`].
    pub fn weights(&self) -> [f64; COUNT] {
        QUANTITIES.each_ref().map(|quantity| self.weights.get(quantity.key).copied().unwrap_or(1.0))
    }

    /// Weight of a trace's difference.
    pub fn trace_weight(&self) -> f64 {
        self.weights.get(TRACE).copied().unwrap_or(1.0)
    }

    /// Limits, %, in the order of [`QUANTITIES`].
    pub fn limits(&self) -> [f64; COUNT] {
        QUANTITIES.each_ref().map(|quantity| self.limits.get(quantity.key).copied().unwrap_or(f64::INFINITY))
    }

    /// Whether the numbers make sense.
    ///
    /// # Errors
    /// What is refused.
    pub fn check(&self) -> Result<(), String> {
        let known = |key: &String| QUANTITIES.iter().any(|quantity| quantity.key == key);
        if let Some(key) = self.weights.keys().find(|key| !known(key) && *key != TRACE) {
            return Err(format!("objective.weights: {key} is unknown"));
        }
        if let Some(key) = self.limits.keys().find(|key| !known(key)) {
            return Err(format!("objective.limits: {key} is unknown"));
        }
        let bad = |value: &&f64| !(**value >= 0.0 && value.is_finite());
        if self.weights.values().chain(self.limits.values()).any(|value| bad(&value)) {
            return Err("objective: weights and limits have to be 0 or more".into());
        }
        if !(self.material_weight >= 0.0 && self.material_weight.is_finite()) {
            return Err("objective.material_weight has to be 0 or more".into());
        }
        if let Some(ratio) = self.poissons_ratio_at_once.filter(|ratio| !(-1.0..0.5).contains(ratio)) {
            return Err(format!("objective.poissons_ratio_at_once = {ratio} is refused: expected -1 to less than 0.5"));
        }
        if !(0.0..=1.0).contains(&self.root_mean_square) {
            return Err("objective.root_mean_square has to be from 0 to 1".into());
        }
        if let Some(class) = self.cfc {
            series::check_channel_class(class).map_err(|error| format!("objective.cfc: {error}"))?;
        }
        Ok(())
    }
}

/// A problem that is ready to be searched.
pub struct Problem {
    /// The scenario that the variables change.
    pub scenario: Scenario,
    /// What is varied.
    pub variables: Vec<Variable>,
    /// The impacts.
    pub targets: Vec<Target>,
    /// What the score is made of.
    pub objective: ObjectiveOptions,
    /// Tests of the material by itself.
    pub material_tests: Vec<MaterialTest>,
    /// The demand of quasi-static tests.
    pub prior: Option<Prior>,
    /// What is known of the errors of the measured numbers, for a posterior.
    pub uncertainty: UncertaintyOptions,
    /// How to search.
    pub search: SearchOptions,
    /// When the simulations end: a duration of the file's own is kept, even if it cuts an impact off.
    pub until: Until,
}

impl Problem {
    /// Everything that the scores and the order of the evaluations depend on, but for how many are made.
    pub fn inputs(&self) -> Value {
        let parameter = |parameter: Parameter| (parameter.name().to_string(), parameter.get(&self.scenario).into());
        let variable = |variable: &Variable| {
            let start = variable.start(&self.scenario);
            let Range { min, max, scale, .. } = variable.range;
            (variable.name.clone(), json!({ "min": min, "max": max, "scale": scale, "start": start }))
        };
        json!({
            "version": env!("CARGO_PKG_VERSION"),
            "scenario": Parameter::of(&self.scenario).map(parameter).collect::<Map<_, _>>(),
            "extended": self.until == Until::Over,
            "parameters": self.variables.iter().map(variable).collect::<Map<_, _>>(),
            "impacts": self.targets.iter().map(Target::inputs).collect::<Vec<_>>(),
            "objective": self.objective,
            "material_tests": self.material_tests,
            "prior": self.prior,
            "search": {
                "seed": self.search.seed, "population": self.search.population, "step": self.search.step,
            },
        })
    }

    /// Whether numbers were measured, and not traces alone.
    pub fn has_numbers(&self) -> bool {
        self.targets.iter().flat_map(|target| target.measured).any(|measured| measured.is_some())
    }

    /// Digest of [`Problem::inputs`].
    pub fn digest(&self) -> String {
        folder::digest(self.inputs().to_string().as_bytes())
    }

    /// Reads the file; what it names stands beside it.
    ///
    /// # Errors
    /// What is refused, with the name of the file.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let refuse = |error: String| Failure::Input(format!("{}: {error}", path.display()));
        let text = std::fs::read_to_string(path).map_err(|error| refuse(error.to_string()))?;
        let folder = path.parent().unwrap_or(Path::new("."));
        Self::parse(&text, folder).map_err(refuse)
    }

    /// The problem that `text` describes; the files that it names stand in `folder`.
    ///
    /// # Errors
    /// The first thing that is refused.
    pub fn parse(text: &str, folder: &Path) -> Result<Self, String> {
        let file: File = scenario_file::from_toml(text)?;
        let preset: &Preset =
            presets::parse(&file.preset).map_err(|legal| format!("preset {}: {legal}", file.preset))?;
        let mut scenario = (preset.scenario)();
        if let Some(path) = &file.scenario {
            scenario = scenario_file::read(&folder.join(path), &scenario).map_err(|error| error.to_string())?;
        }
        let mut changes = Changes::of(&scenario);
        let mut given = Given::default();
        for (name, value) in &file.fixed {
            fix(&mut changes, &mut given, name, value)?;
        }
        let layers = changes.values().scenario();
        let variables = file.parameters.iter().map(|(name, range)| variable(&layers, name, range));
        let variables = variables.collect::<Result<Vec<_>, _>>()?;
        for variable in &variables {
            let parameter = variable.parameter();
            let added = parameter.map_or(Ok(()), |parameter| given.add(parameter, &variable.name));
            added.map_err(|error| format!("parameters: {error}"))?;
        }
        let scenario = changed(changes, &variables)?;
        if variables.is_empty() {
            return Err("[parameters] is empty: there is nothing to search for".into());
        }
        let mut impacts = file.impact;
        if let Some(path) = &file.impacts {
            impacts.extend(read_impacts(&folder.join(path))?);
        }
        file.objective.check()?;
        let target = |impact: &Impact| Target::new(impact, &scenario, folder, file.objective.cfc);
        let targets = impacts.iter().map(target).collect::<Result<Vec<_>, _>>()?;
        let possible = Possible::new(&scenario, &variables)?;
        targets.iter().try_for_each(|target| possible.check(target))?;
        if !targets.iter().any(|target| !target.predict) {
            return Err("no [[impact]] counts: there is nothing to aim at".into());
        }
        if let Some(prior) = &file.prior {
            prior.check(&scenario)?;
        }
        for test in &file.material_test {
            test.check(&scenario)?;
        }
        file.uncertainty.check()?;
        let search = file.search;
        if search.evaluations == 0 || !(search.step > 0.0 && search.step <= 1.0) {
            return Err("search: evaluations has to be above 0, step above 0 and at most 1".into());
        }
        let own_duration = scenario.time.duration != (preset.scenario)().time.duration;
        let until = if own_duration { Until::Duration } else { Until::Over };
        Ok(Self {
            scenario,
            variables,
            targets,
            objective: file.objective,
            material_tests: file.material_test,
            prior: file.prior,
            uncertainty: file.uncertainty,
            search,
            until,
        })
    }
}

fn variable(scenario: &Scenario, name: &str, range: &Value) -> Result<Variable, String> {
    let range = Range::deserialize(range).map_err(|error| format!("{name}: {error}"))?;
    Variable::new(scenario, name, range)
}

/// The scenario of `changes` and of what is searched for, all of which acts.
fn changed(mut changes: Changes, variables: &[Variable]) -> Result<Scenario, String> {
    for variable in variables {
        variable.give(&mut changes)?;
    }
    let scenario = changes.resolve().map_err(|error| error.to_string())?;
    // A term that may begin at 0 acts in the middle of its range.
    let (mut middle, values) =
        (scenario.clone(), variables.iter().map(|variable| variable.value(0.5)).collect::<Vec<_>>());
    apply(variables, &values, &mut middle)?;
    if let Some(no_effect) = changes.without_effect(&middle).next() {
        return Err(no_effect.to_string());
    }
    scenario.validate().map_err(|error| error.to_string())?;
    Ok(scenario)
}

/// Sets a parameter to what stands under [fixed]: a number, or the label of a choice.
fn fix(changes: &mut Changes, given: &mut Given, name: &str, value: &Value) -> Result<(), String> {
    let parameter = names::find(changes.values(), name).map_err(|error| format!("fixed: {error}"))?;
    given.add(parameter, name).map_err(|error| format!("fixed: {error}"))?;
    let written = match value {
        Value::Number(number) => number.as_f64().map_or(Written::Other, Written::Number),
        Value::String(label) => Written::Label(label),
        _ => Written::Other,
    };
    let number = assign::number(&parameter, written)
        .map_err(|legal| format!("fixed: {name} = {value} is refused: expected {legal}"))?;
    check_fits_impacts(&parameter)?;
    changes.set(parameter, number).map_err(|error| format!("fixed: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = "[search]\nevaluations = 10\n[parameters]\n\"silicone.c10\" = { min = 1e4, max = 1e6 }\n\
                        [[impact]]\nenergy = 14.7\ntable_1 = true\n";

    fn refused(text: &str) -> String {
        Problem::parse(text, Path::new(".")).err().unwrap()
    }

    #[test]
    fn what_is_left_out_has_defaults() {
        let problem = Problem::parse(GOOD, Path::new(".")).unwrap();
        assert_eq!((problem.search.seed, problem.objective.force), (1, Sensor::Contact));
        assert_eq!(problem.objective.weights(), [1.0; COUNT]);
        assert_eq!(problem.variables.len(), 1);
    }

    #[test]
    fn choices_and_numbers_can_be_fixed() {
        let text = format!("{GOOD}[fixed]\n\"core.interface\" = \"frictional\"\n\"core.friction_coefficient\" = 1\n");
        let problem = Problem::parse(&text, Path::new(".")).unwrap();
        assert_eq!(problem.scenario.core.friction_coefficient, 1.0);
        assert!(
            refused(&text.replace("frictional\"", "glued\""))
                .contains("expected \"bonded\" or \"frictional\" or \"sliding\"")
        );
        assert!(refused(&text.replace("= 1\n", "= -1\n")).contains("expected 0 to 10"));
    }

    #[test]
    fn a_parameter_stands_once_by_whatever_name() {
        let range = "\"layers[0].c10\" = { min = 1e4, max = 1e6 }\n[[impact]]";
        assert_eq!(
            refused(&GOOD.replace("[[impact]]", range)),
            "parameters: layers[0].c10 and silicone.c10 state the same thing: expected one of them"
        );
        assert_eq!(
            refused(&format!("{GOOD}[fixed]\n\"silicone.c10\" = 1e5\n")),
            "parameters: silicone.c10 is given twice: expected one value"
        );
    }

    /// Both sides go through the filter, unless the trace has been through it.
    #[test]
    fn a_trace_is_filtered_as_the_simulated_force_is() {
        // A half sine of 8 ms and 3 kN with one sample of twice that.
        let force =
            |i: i32| 3e3 * (f64::from(i - 20) * std::f64::consts::PI / 80.0).sin() * f64::from(1 + i32::from(i == 60));
        let row =
            |i: i32| format!("{},{}\n", 1e-4 * f64::from(i), if (20..=100).contains(&i) { force(i) } else { 0.0 });
        let rows: String = (0..200).map(row).collect();
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("a.csv"), format!("time [s],force [N]\n{rows}")).unwrap();
        let peak = |objective: &str, filtered: &str| {
            let text = GOOD.replace("table_1 = true", &format!("trace = \"a.csv\"\n{filtered}"));
            let problem = Problem::parse(&format!("{text}[objective]\n{objective}"), folder.path());
            problem.map(|problem| problem.targets[0].trace.as_ref().unwrap().peak())
        };
        let raw = peak("", "").unwrap();
        assert!(peak("cfc = 180", "").unwrap() < 0.7 * raw);
        assert_eq!(peak("cfc = 180", "filtered = true\n"), Ok(raw));
        assert!(peak("", "filtered = true\n").unwrap_err().contains("filtered has no effect"));
    }

    #[test]
    fn a_refused_problem_says_what_is_wrong() {
        for (from, to, message) in [
            ("evaluations = 10", "evalations = 10", "line 2: unknown field `evalations`"),
            ("evaluations = 10", "evaluations = 0", "evaluations has to be above 0"),
            ("min = 1e4, ", "", "silicone.c10: missing field `min`"),
            ("silicone.c10", "silicone.c9", "silicone.c9 is unknown"),
            ("14.7", "3", "14.7, 9.8 and 4.9"),
            ("table_1 = true", "table_1 = true\npredict = true", "nothing to aim at"),
            ("[search]", "[objective.limits]\npeak = 3\n[search]", "objective.limits: peak is unknown"),
            ("[search]", "[prior]\nweight = -1\n[search]", "have to be above 0"),
            ("[search]", "preset = \"other\"\n[search]", "preset other: expected study"),
        ] {
            let error = refused(&GOOD.replacen(from, to, 1));
            assert!(error.contains(message), "{error}");
        }
    }
}
