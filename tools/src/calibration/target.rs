//! The measured impacts that a search aims at.

use std::collections::BTreeMap;
use std::path::Path;

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::{Map, Value, json};
use softanvil_kernel::Scenario;
use softanvil_records::sheet::Layout;
use softanvil_records::trace;
use softanvil_records::understood::Understood;

use crate::files::folder;
use crate::measurement::measured::Measured;
use crate::measurement::quantity::{COUNT, QUANTITIES};
use crate::measurement::series::Series;
use crate::paper::{DECIMALS, TABLE_1};

/// An impact as the problem file states it: by what was measured, or as a line of the study's table.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Impact {
    /// Impact energy, J.
    pub energy: f64,
    /// Take the four numbers from the study's Table 1.
    #[serde(default)]
    pub table_1: bool,
    /// Peak force, N.
    pub peak_force: Option<f64>,
    /// Largest deformation, m.
    pub max_deformation: Option<f64>,
    /// Impact duration, s.
    pub impact_duration: Option<f64>,
    /// Impulse, N s.
    pub impulse: Option<f64>,
    /// Trace of force or acceleration: a file beside the problem file, or a table of it and what it leaves open.
    pub trace: Option<TraceFile>,
    /// Whether the trace has been filtered already: `objective.cfc` is for the simulated force alone then.
    #[serde(default)]
    pub filtered: bool,
    /// Half of the last printed digit of numbers, by key, in SI; that of the table if it is from there.
    #[serde(default)]
    pub half_unit: BTreeMap<String, f64>,
    /// Keys of numbers that are reported but do not count.
    #[serde(default)]
    pub ignore: Vec<String>,
    /// Whether nothing of this impact counts: it is simulated and reported, as a prediction.
    #[serde(default)]
    pub predict: bool,
}

/// A file with a measured trace.
#[derive(Clone, Debug)]
pub enum TraceFile {
    /// Its name.
    Name(String),
    /// Its name, and what it leaves open.
    Open(Box<OpenTrace>),
}

/// A file with a measured trace, and what it leaves open: the options of `softanvil measure`, without their dashes.
#[derive(Clone, Debug, Default)]
pub struct OpenTrace {
    /// Name of the file.
    file: String,
    time: Option<String>,
    force: Option<String>,
    acceleration: Option<String>,
    mass: Option<String>,
    rate: Option<String>,
    offset: Option<f64>,
    sign: Option<String>,
    impact: Option<u32>,
    sheet: Option<String>,
    decimal: Option<String>,
}

/// By hand, so that what is wrong is named with what is expected.
impl<'de> Deserialize<'de> for TraceFile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Value::deserialize(deserializer)? {
            Value::String(name) => Ok(Self::Name(name)),
            Value::Object(table) => {
                OpenTrace::of(&table).map(|open| Self::Open(Box::new(open))).map_err(D::Error::custom)
            }
            other => Err(D::Error::custom(format!(
                "trace = {other} is refused: expected the name of a file, or a table {{ file = \"drop.csv\" }} with keys of docs/measured-data.md"
            ))),
        }
    }
}

/// Keys of the table of a trace whose values are texts, each with an example.
const TEXTS: [(&str, &str); 9] = [
    ("file", "drop.csv"),
    ("time", "t [ms]"),
    ("force", "Fz [kN]"),
    ("acceleration", "a [m/s2]"),
    ("mass", "5 kg"),
    ("rate", "20 kHz"),
    ("sign", "-"),
    ("sheet", "Sheet1"),
    ("decimal", "comma"),
];
/// Those whose values are numbers.
const NUMBERS: [&str; 2] = ["offset", "impact"];

impl OpenTrace {
    fn of(table: &Map<String, Value>) -> Result<Self, String> {
        let known = || TEXTS.iter().map(|(key, _)| *key).chain(NUMBERS);
        if let Some(key) = table.keys().find(|key| !known().any(|known| known == *key)) {
            return Err(format!("trace.{key} is unknown: expected {}", known().collect::<Vec<_>>().join(", ")));
        }
        let refuse = |key: &str, legal: &str| format!("trace.{key} = {} is refused: expected {legal}", table[key]);
        let text = |key: &str| match table.get(key) {
            None => Ok(None),
            Some(Value::String(text)) => Ok(Some(text.clone())),
            Some(_) => {
                let example = TEXTS.iter().find(|(name, _)| *name == key).map_or("", |(_, example)| example);
                Err(refuse(key, &format!("a text in quotation marks, such as \"{example}\"")))
            }
        };
        let offset = table.get("offset").map(|value| value.as_f64().ok_or_else(|| refuse("offset", "a number")));
        let whole = |value: &Value| value.as_u64().and_then(|value| u32::try_from(value).ok());
        let impact =
            table.get("impact").map(|value| whole(value).ok_or_else(|| refuse("impact", "a whole number, 1 or more")));
        Ok(Self {
            file: text("file")?.ok_or("trace is refused: expected a key file with the name of the file")?,
            time: text("time")?,
            force: text("force")?,
            acceleration: text("acceleration")?,
            mass: text("mass")?,
            rate: text("rate")?,
            sign: text("sign")?,
            sheet: text("sheet")?,
            decimal: text("decimal")?,
            offset: offset.transpose()?,
            impact: impact.transpose()?,
        })
    }

    fn options(&self) -> Result<trace::Options, String> {
        fn parsed<T>(
            key: &str,
            text: &Option<String>,
            parse: impl Fn(&str) -> Result<T, String>,
        ) -> Result<Option<T>, String> {
            let refuse = |text: &str, error: String| format!("trace.{key} = \"{text}\" is refused: {error}");
            text.as_ref().map(|text| parse(text).map_err(|error| refuse(text, error))).transpose()
        }
        let column = |key: &str, text: &Option<String>| parsed(key, text, |text| text.parse::<trace::Choice>());
        if self.impact == Some(0) {
            return Err("trace.impact = 0 is refused: expected 1 or more".into());
        }
        Ok(trace::Options {
            layout: Layout { decimal: parsed("decimal", &self.decimal, str::parse)?, sheet: self.sheet.clone() },
            time: column("time", &self.time)?,
            force: column("force", &self.force)?,
            acceleration: column("acceleration", &self.acceleration)?,
            displacement: None,
            mass: parsed("mass", &self.mass, trace::mass)?,
            rate: parsed("rate", &self.rate, trace::rate)?,
            offset: self.offset,
            sign: parsed("sign", &self.sign, trace::sign)?,
            impact: self.impact.map(|impact| impact as usize),
        })
    }
}

/// What an error says to type, as the problem file has it.
fn as_keys(error: &str) -> String {
    let names =
        ["time", "force-column", "acceleration", "mass", "rate", "sign", "impact", "sheet", "offset", "decimal"];
    names.iter().fold(error.to_string(), |text, name| {
        let key = name.trim_end_matches("-column");
        text.replace(&format!("--{name} "), &format!("trace.{key} = "))
    })
}

/// An impact to aim at.
pub struct Target {
    /// Impact energy, J.
    pub energy: f64,
    /// What was measured, in SI and in the order of [`QUANTITIES`].
    pub measured: [Option<f64>; COUNT],
    /// By how much it may have been rounded, in SI.
    pub half_unit: [f64; COUNT],
    /// Which of them count.
    pub counts: [bool; COUNT],
    /// Measured force trace.
    pub trace: Option<Series>,
    /// How the trace was read.
    pub understood: Option<Understood>,
    /// Whether the impact is predicted only.
    pub predict: bool,
}

impl Target {
    /// The target that `impact` on `scenario` describes; its files stand in `folder`, and a trace goes through the filter of
    /// `channel_class`, Hz, as the simulated force does, unless it has been filtered.
    ///
    /// # Errors
    /// An energy that the table does not have, a number that is no positive one, an unknown key, or a trace that cannot
    /// be read.
    pub fn new(
        impact: &Impact,
        scenario: &Scenario,
        folder: &Path,
        channel_class: Option<f64>,
    ) -> Result<Self, String> {
        let energy = impact.energy;
        let refuse = |what: String| Err(format!("impact of {energy} J: {what}"));
        if !(energy > 0.0 && energy.is_finite()) {
            return refuse("expected an energy above 0".into());
        }
        let given = [impact.peak_force, impact.max_deformation, impact.impact_duration, impact.impulse];
        for (quantity, value) in QUANTITIES.iter().zip(given) {
            if value.is_some_and(|value| !(value > 0.0 && value.is_finite())) {
                return refuse(format!("{} has to be above 0", quantity.key));
            }
        }
        let measured = match (impact.table_1, TABLE_1.iter().find(|case| case.energy == energy)) {
            (false, _) => given,
            (true, Some(case)) => std::array::from_fn(|i| given[i].or(Some(case.experiment[i]))),
            (true, None) => return refuse("the study's table has 14.7, 9.8 and 4.9 J".into()),
        };
        let half_unit = half_units(impact, &measured).map_err(|error| format!("impact of {energy} J: {error}"))?;
        let mut counts = measured.map(|value| value.is_some() && !impact.predict);
        for key in &impact.ignore {
            match QUANTITIES.iter().position(|quantity| quantity.key == key) {
                Some(index) => counts[index] = false,
                None => return refuse(format!("ignore: {key} is unknown; expected {}", keys())),
            }
        }
        let given = match &impact.trace {
            Some(TraceFile::Name(file)) => Some((file, trace::Options::default())),
            Some(TraceFile::Open(open)) => Some((&open.file, open.options()?)),
            None => None,
        };
        let impactor = scenario.impactor.with_energy(energy);
        let read = |(file, options): (&String, trace::Options)| {
            Measured::read(&folder.join(file), &options, &impactor).map_err(|error| as_keys(&error))
        };
        let measured_trace = given.map(read).transpose()?;
        let understood = measured_trace.as_ref().map(|trace| trace.understood.clone());
        if impact.filtered && (measured_trace.is_none() || channel_class.is_none()) {
            return refuse("filtered has no effect: it is for a trace beside objective.cfc".into());
        }
        let class = channel_class.filter(|_| !impact.filtered);
        let filtered = |trace: Measured| match class {
            Some(class) => trace.series.filtered(class).map_err(|error| error.to_string()),
            None => Ok(trace.series),
        };
        let trace = measured_trace.map(filtered).transpose()?;
        if measured.iter().all(Option::is_none) && trace.is_none() {
            return refuse(format!("nothing was measured: give some of {}, trace, or table_1 = true", keys()));
        }
        Ok(Self { energy, measured, half_unit, counts, trace, understood, predict: impact.predict })
    }
}

impl Target {
    /// Everything that the score depends on.
    pub fn inputs(&self) -> Value {
        let mut object = Map::new();
        object.insert("energy".into(), self.energy.into());
        for (i, quantity) in QUANTITIES.iter().enumerate() {
            object.insert(
                quantity.key.into(),
                json!({
                    "measured": self.measured[i], "half_unit": self.half_unit[i], "counts": self.counts[i],
                }),
            );
        }
        object.insert("trace".into(), self.trace.as_ref().map(digest_of).into());
        object.insert("predict".into(), self.predict.into());
        Value::Object(object)
    }
}

/// By how much the numbers of `impact` may have been rounded, in SI: as it says, else as the table prints what is from there.
fn half_units(impact: &Impact, measured: &[Option<f64>; COUNT]) -> Result<[f64; COUNT], String> {
    let given = [impact.peak_force, impact.max_deformation, impact.impact_duration, impact.impulse];
    let printed = |i: usize| 0.5 * 10f64.powi(-(DECIMALS[i] as i32)) / QUANTITIES[i].display_scale;
    let mut half = std::array::from_fn(|i| if impact.table_1 && given[i].is_none() { printed(i) } else { 0.0 });
    for (key, value) in &impact.half_unit {
        let Some(i) = QUANTITIES.iter().position(|quantity| quantity.key == key) else {
            return Err(format!("half_unit: {key} is unknown; expected {}", keys()));
        };
        if measured[i].is_none() || !(*value >= 0.0 && value.is_finite()) {
            return Err(format!(
                "half_unit: {key} = {value} is refused: expected 0 or more, of a number that was measured"
            ));
        }
        half[i] = *value;
    }
    Ok(half)
}

/// Digest of the numbers of a trace.
fn digest_of(trace: &Series) -> String {
    let numbers = [trace.start, trace.interval].into_iter().chain(trace.force.iter().copied());
    folder::digest(&numbers.flat_map(f64::to_le_bytes).collect::<Vec<_>>())
}

fn keys() -> String {
    QUANTITIES.iter().map(|quantity| quantity.key).collect::<Vec<_>>().join(", ")
}

/// Impacts from a CSV file whose header names the keys of [`Impact`], those that it needs.
///
/// # Errors
/// What cannot be read, with its line.
pub fn read_impacts(path: &Path) -> Result<Vec<Impact>, String> {
    let mut reader = csv::ReaderBuilder::new()
        .trim(csv::Trim::All)
        .from_path(path)
        .map_err(|error| format!("{} cannot be read: {error}", path.display()))?;
    let rows = reader.deserialize::<Row>();
    let impacts = rows.map(|row| row.map(Impact::from)).collect::<Result<Vec<_>, _>>();
    impacts.map_err(|error| format!("{}: {error}", path.display()))
}

/// A line of such a file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    energy: f64,
    peak_force: Option<f64>,
    max_deformation: Option<f64>,
    impact_duration: Option<f64>,
    impulse: Option<f64>,
    trace: Option<String>,
    predict: Option<bool>,
}

impl From<Row> for Impact {
    fn from(row: Row) -> Self {
        Self {
            energy: row.energy,
            peak_force: row.peak_force,
            max_deformation: row.max_deformation,
            impact_duration: row.impact_duration,
            impulse: row.impulse,
            trace: row.trace.map(TraceFile::Name),
            predict: row.predict.unwrap_or(false),
            ..Self::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scenario() -> Scenario {
        (crate::presets::parse("study").unwrap().scenario)()
    }

    #[test]
    fn a_line_of_the_table_counts_but_for_what_is_ignored() {
        let ignore = vec!["max_deformation".to_string()];
        let impact = Impact { energy: 9.8, table_1: true, ignore, ..Impact::default() };
        let target = Target::new(&impact, &scenario(), Path::new("."), None).unwrap();
        assert_eq!(target.measured, [Some(4071.0), Some(3.5e-3), Some(8.1e-3), Some(13.0)]);
        assert_eq!(target.counts, [true, false, true, true]);
        let rounded = [0.5, 0.05e-3, 0.05e-3, 0.5];
        assert!(target.half_unit.iter().zip(rounded).all(|(a, b)| (a - b).abs() < 1e-12), "{:?}", target.half_unit);
        let target = Target::new(&Impact { predict: true, ..impact }, &scenario(), Path::new("."), None).unwrap();
        assert_eq!(target.counts, [false; COUNT]);
    }

    #[test]
    fn what_is_wrong_in_the_table_of_a_trace_is_named() {
        let refused = |trace: &str| toml_edit::de::from_str::<Impact>(&format!("energy = 5\n{trace}")).unwrap_err();
        for (trace, message) in [
            (
                "trace = { file = \"x.csv\", mass = 5 }",
                "trace.mass = 5 is refused: expected a text in quotation marks, such as \"5 kg\"",
            ),
            ("trace = { file = \"x.csv\", weight = 5 }", "trace.weight is unknown: expected file, time, force"),
            ("trace = { mass = \"5 kg\" }", "expected a key file with the name of the file"),
            ("trace = { file = \"x.csv\", impact = -1 }", "trace.impact = -1 is refused: expected a whole number"),
            ("trace = { file = \"x.csv\", offset = \"1\" }", "trace.offset = \"1\" is refused: expected a number"),
            ("trace = 3", "trace = 3 is refused: expected the name of a file, or a table"),
        ] {
            let error = refused(trace).to_string();
            assert!(error.contains(message), "{trace}: {error}");
        }
    }

    #[test]
    fn an_impact_without_measurements_is_refused() {
        let refused = |impact: Impact| Target::new(&impact, &scenario(), Path::new("."), None).err().unwrap();
        assert!(refused(Impact { energy: 5.0, ..Impact::default() }).contains("nothing was measured"));
        assert!(refused(Impact { energy: 5.0, table_1: true, ..Impact::default() }).contains("14.7, 9.8 and 4.9"));
        assert!(refused(Impact { energy: 5.0, impulse: Some(-1.0), ..Impact::default() }).contains("above 0"));
        let ignore = vec!["peak".to_string()];
        assert!(
            refused(Impact { energy: 9.8, table_1: true, ignore, ..Impact::default() }).contains("peak is unknown")
        );
    }
}
