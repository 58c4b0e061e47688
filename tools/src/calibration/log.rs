//! Every evaluation of a search, one line of CSV each, written as soon as it is known.
//!
//! The log is also how a search continues: it starts anew with the same seed, and as long as it asks for what the log
//! holds, to the last bit, the answer comes from there. So no state of the optimiser is stored, and a search that was
//! interrupted, or given more evaluations, goes on as if nothing had happened.
//!
//! Every line carries the digest of the whole problem, and beside the log stands what it is the digest of: a log of another
//! problem is refused, and so is one whose scores this program does not give.

use std::fs::{File, OpenOptions};
use std::path::PathBuf;

use serde_json::{Map, Value};

use super::objective::{Evaluation, evaluate};
use super::problem::Problem;
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::files::staging;
use crate::measurement::quantity::QUANTITIES;

/// One evaluation as the log remembers it.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Number of the restart, from 0.
    pub restart: usize,
    /// The score.
    pub score: f64,
    /// Mean error of all measured numbers, %.
    pub mean_error: f64,
    /// The values of the variables.
    pub values: Vec<f64>,
}

/// The log of a search.
pub struct Log {
    path: PathBuf,
    digest: String,
    writer: csv::Writer<File>,
    /// What it holds.
    pub entries: Vec<Entry>,
}

/// Name of the log.
pub const NAME: &str = "evaluations.csv";
/// Name of the file with the problem that the log belongs to.
pub const PROBLEM: &str = "problem.json";

/// Columns before the values.
const LEADING: [&str; 4] = ["evaluation", "restart", "score [1]", "mean_error [%]"];

/// Relative difference of scores that two machines may have: the prior takes logarithms from the system.
const SAME_SCORE: f64 = 1e-9;

impl Log {
    /// Opens the log in `folder`; one that stands there is continued, or with `anew` replaced if it is of another problem.
    ///
    /// # Errors
    /// A log of another problem or program, or a file that cannot be read or written.
    pub fn open(folder: &mut Folder, problem: &Problem, anew: bool) -> Result<Self, Failure> {
        let path = folder.path().join(NAME);
        let old = match std::fs::read_to_string(&path) {
            Ok(text) => complete_lines(&text).to_string(),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(Failure::Input(format!("{}: {error}", path.display()))),
        };
        let header = line(&header(problem))?;
        let (text, entries) = match (old.is_empty(), known(&old, problem, folder)) {
            (true, _) => (header.clone(), Vec::new()),
            (false, Ok(entries)) => (old, entries),
            (false, Err(_)) if anew => (header.clone(), Vec::new()),
            (false, Err(reason)) => return Err(Failure::Input(format!("{}: {reason}", path.display()))),
        };
        folder.take(NAME, &header)?;
        staging::write_files(&[(&path, text.into_bytes())]).map_err(|(path, error)| Failure::writing(&path, error))?;
        folder.write(&[(PROBLEM.into(), crate::output::json::text(&problem.inputs()).into_bytes())])?;
        let file = OpenOptions::new().append(true).open(&path).map_err(|error| Failure::writing(&path, error))?;
        Ok(Self { path, digest: problem.digest(), writer: csv::Writer::from_writer(file), entries })
    }

    /// Adds evaluations, in order, and sees that they are on the disk's side of this program.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn append(
        &mut self,
        problem: &Problem,
        restart: usize,
        values: &[Vec<f64>],
        results: &[Evaluation],
    ) -> Result<(), Failure> {
        for (values, result) in values.iter().zip(results) {
            let mut record = record(problem, self.entries.len(), restart, values, result);
            record.push(self.digest.clone());
            self.writer.write_record(&record).map_err(|error| Failure::writing(&self.path, error))?;
            self.entries.push(Entry {
                restart,
                score: result.score,
                mean_error: result.mean_error,
                values: values.clone(),
            });
        }
        self.writer.flush().map_err(|error| Failure::writing(&self.path, error))
    }
}

/// The text without a last line that was cut off.
fn complete_lines(text: &str) -> &str {
    text.rfind('\n').map_or("", |end| &text[..=end])
}

fn header(problem: &Problem) -> Vec<String> {
    let mut header: Vec<String> = LEADING.iter().map(|name| (*name).into()).collect();
    header.extend(problem.variables.iter().map(|variable| format!("{} [{}]", variable.name, variable.unit)));
    for target in &problem.targets {
        let energy = target.energy;
        header.extend(QUANTITIES.iter().map(|quantity| format!("{energy} J: {} [{}]", quantity.key, quantity.unit())));
        header.push(format!("{energy} J: ending"));
    }
    header.extend(["refusal", "problem"].map(String::from));
    header
}

fn record(problem: &Problem, number: usize, restart: usize, values: &[f64], result: &Evaluation) -> Vec<String> {
    let mut record =
        vec![number.to_string(), restart.to_string(), result.score.to_string(), result.mean_error.to_string()];
    record.extend(values.iter().map(f64::to_string));
    for index in 0..problem.targets.len() {
        let simulated = result.impacts.get(index);
        record.extend((0..QUANTITIES.len()).map(|i| simulated.map_or(String::new(), |s| s.values[i].to_string())));
        record.push(simulated.map_or(String::new(), |s| s.ending.key().into()));
    }
    record.push(result.refusal.clone().unwrap_or_default());
    record
}

fn line(record: &[String]) -> Result<String, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let failed = |error: &dyn std::fmt::Display| Failure::Failed(format!("the log cannot be written: {error}"));
    writer.write_record(record).map_err(|error| failed(&error))?;
    let bytes = writer.into_inner().map_err(|error| failed(&error))?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// What is told of a log that is not continued.
const REFUSED: &str = "choose another folder by --out, remove it, or start anew with --overwrite";

/// The evaluations in `text`, a log that stands in `folder`, if it is of `problem` and this program gives its scores.
fn known(text: &str, problem: &Problem, folder: &Folder) -> Result<Vec<Entry>, String> {
    let entries = parse(text, &header(problem), problem.variables.len(), &problem.digest()).map_err(|error| {
        let difference = || {
            let old = std::fs::read_to_string(folder.path().join(PROBLEM)).ok()?;
            difference(&serde_json::from_str(&old).ok()?, &problem.inputs(), "")
        };
        let why = difference().map_or(String::new(), |difference| format!(" ({difference})"));
        format!("{error}{why}; {REFUSED}")
    })?;
    if let Some(first) = entries.first() {
        let now = evaluate(problem, &first.values).score;
        if (now - first.score).abs() > SAME_SCORE * first.score.abs() {
            return Err(format!(
                "this program gives the first evaluation a score of {now}, the log one of {}: it is of another version; \
                 {REFUSED}",
                first.score
            ));
        }
    }
    Ok(entries)
}

fn parse(text: &str, header: &[String], n_variable: usize, digest: &str) -> Result<Vec<Entry>, String> {
    let other = || "this is the log of another problem".to_string();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let found = reader.headers().map_err(|error| error.to_string())?;
    if !found.iter().eq(header.iter()) {
        return Err(other());
    }
    let mut entries = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let record = record.map_err(|error| error.to_string())?;
        if record.get(header.len() - 1) != Some(digest) {
            return Err(other());
        }
        let refuse = || format!("line {} is no evaluation", index + 2);
        let number = |column: usize| record.get(column).and_then(|text| text.parse::<f64>().ok()).ok_or_else(refuse);
        entries.push(Entry {
            restart: number(1)? as usize,
            score: number(2)?,
            mean_error: number(3)?,
            values: (0..n_variable).map(|i| number(LEADING.len() + i)).collect::<Result<_, _>>()?,
        });
    }
    Ok(entries)
}

/// The first difference of two problems, in words; `path` is where they stand.
fn difference(old: &Value, new: &Value, path: &str) -> Option<String> {
    let below = |key: &str| if path.is_empty() { key.to_string() } else { format!("{path}.{key}") };
    match (old, new) {
        (Value::Object(a), Value::Object(b)) => {
            let keys = b.keys().chain(a.keys().filter(|key| !b.contains_key(*key)));
            let none = Value::Null;
            let of = |map: &Map<String, Value>, key: &String| map.get(key).cloned().unwrap_or(none.clone());
            keys.into_iter().find_map(|key| difference(&of(a, key), &of(b, key), &below(key)))
        }
        (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
            let pairs = a.iter().zip(b).enumerate();
            pairs.into_iter().find_map(|(i, (a, b))| difference(a, b, &format!("{path}[{i}]")))
        }
        _ if old == new => None,
        (Value::Array(_) | Value::Object(_), _) | (_, Value::Array(_) | Value::Object(_)) => {
            Some(format!("{path} is another"))
        }
        _ => Some(format!("{path} was {old} and is {new}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn the_first_difference_of_two_problems_is_named_with_both_values() {
        let old = json!({ "a": 1, "impacts": [{ "peak_force": 4071.0 }, { "peak_force": 1.0 }], "prior": null });
        let with = |pointer: &str, value: Value| {
            let mut new = old.clone();
            *new.pointer_mut(pointer).unwrap() = value;
            difference(&old, &new, "")
        };
        assert_eq!(difference(&old, &old, ""), None);
        let peak = with("/impacts/0/peak_force", 3000.0.into());
        assert_eq!(peak.unwrap(), "impacts[0].peak_force was 4071.0 and is 3000.0");
        assert_eq!(with("/impacts", json!([1])).unwrap(), "impacts is another");
        assert_eq!(with("/prior", json!({ "weight": 1 })).unwrap(), "prior is another");
    }
}
