//! Every evaluation of a search, one line of CSV each, written as soon as it is known.
//!
//! The log is also how a search continues: it starts anew with the same seed, and as long as it asks for what the log
//! holds, to the last bit, the answer comes from there. So no state of the optimiser is stored, and a search that was
//! interrupted, or given more evaluations, goes on as if nothing had happened.

use std::fs::{File, OpenOptions};
use std::path::{Path, PathBuf};

use super::objective::Evaluation;
use super::problem::Problem;
use crate::failure::Failure;
use crate::quantity::QUANTITIES;
use crate::staging;

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
    writer: csv::Writer<File>,
    /// What it holds.
    pub entries: Vec<Entry>,
}

/// Columns before the values.
const LEADING: [&str; 4] = ["evaluation", "restart", "score", "mean_error [%]"];

impl Log {
    /// Opens the log at `path`; one that stands there is continued.
    ///
    /// # Errors
    /// A log of another problem, or a file that cannot be read or written.
    pub fn open(path: &Path, problem: &Problem) -> Result<Self, Failure> {
        let header = header(problem);
        let old = match std::fs::read_to_string(path) {
            Ok(text) => complete_lines(&text).to_string(),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => String::new(),
            Err(error) => return Err(Failure::Input(format!("{}: {error}", path.display()))),
        };
        let (text, entries) = if old.is_empty() {
            (line(&header)?, Vec::new())
        } else {
            let entries = parse(&old, &header, problem.variables.len())
                .map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
            (old, entries)
        };
        staging::write_files(&[(path, text.into_bytes())]).map_err(|(path, error)| Failure::writing(&path, error))?;
        let file = OpenOptions::new().append(true).open(path).map_err(|error| Failure::writing(path, error))?;
        Ok(Self { path: path.into(), writer: csv::Writer::from_writer(file), entries })
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
            let record = record(problem, self.entries.len(), restart, values, result);
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
        header.extend(QUANTITIES.iter().map(|quantity| format!("{} J: {}", target.energy, quantity.key)));
    }
    header.push("refusal".into());
    header
}

fn record(problem: &Problem, number: usize, restart: usize, values: &[f64], result: &Evaluation) -> Vec<String> {
    let mut record =
        vec![number.to_string(), restart.to_string(), result.score.to_string(), result.mean_error.to_string()];
    record.extend(values.iter().map(f64::to_string));
    for index in 0..problem.targets.len() {
        let simulated = result.impacts.get(index);
        record.extend((0..QUANTITIES.len()).map(|i| simulated.map_or(String::new(), |s| s.values[i].to_string())));
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

fn parse(text: &str, header: &[String], n_variable: usize) -> Result<Vec<Entry>, String> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let found = reader.headers().map_err(|error| error.to_string())?;
    if !found.iter().eq(header.iter()) {
        return Err("this is the log of another problem; choose another folder by --out, or remove it".into());
    }
    let mut entries = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let record = record.map_err(|error| error.to_string())?;
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
