//! Simulated impacts of a posterior, remembered in a file, so that one that was interrupted continues without them.

use std::collections::BTreeMap;
use std::fs::{File, OpenOptions};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};

use rayon::prelude::*;

use crate::calibration::objective::evaluate;
use crate::calibration::problem::Problem;
use crate::failure::Failure;
use crate::files::folder::Folder;
use crate::files::staging;
use crate::measurement::quantity::{COUNT, QUANTITIES};

/// Name of the file.
pub const NAME: &str = "uncertainty.csv";
/// Sets of values that are simulated before the file hears of them.
const CHUNK: usize = 16;

/// The four numbers of every impact; none of values that cannot be simulated.
pub type Numbers = Option<Vec<[f64; COUNT]>>;

/// Simulated impacts by the bits of their values.
pub struct Runs {
    path: PathBuf,
    digest: String,
    writer: csv::Writer<File>,
    known: BTreeMap<Vec<u64>, Numbers>,
}

impl Runs {
    /// Opens the file in `folder`; what it holds of another problem is left out.
    ///
    /// # Errors
    /// A file of others, or one that cannot be written.
    pub fn open(folder: &mut Folder, problem: &Problem) -> Result<Self, Failure> {
        let header = header(problem);
        let first = header.join(",") + "\n";
        let path = folder.take(NAME, &first)?;
        let digest = problem.digest();
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        let known = parse(&text, &header, problem, &digest);
        let failed = |error: &dyn std::fmt::Display| Failure::writing(&path, error);
        staging::write_files(&[(&path, first.into_bytes())]).map_err(|(_, error)| failed(&error))?;
        let file = OpenOptions::new().append(true).open(&path).map_err(|error| failed(&error))?;
        let writer = csv::WriterBuilder::new().from_writer(file);
        let mut runs = Self { path: path.clone(), digest, writer, known: BTreeMap::new() };
        for (bits, numbers) in known {
            runs.remember(bits, numbers)?;
        }
        runs.flush()?;
        Ok(runs)
    }

    /// The impacts of all `values`, as far as they are not known by simulation; none if `stop` was set meanwhile. `progress`
    /// hears of every chunk how many were simulated.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn simulate(
        &mut self,
        problem: &Problem,
        values: &[Vec<f64>],
        stop: &AtomicBool,
        progress: &dyn Fn(usize),
    ) -> Result<Option<Vec<Numbers>>, Failure> {
        for chunk in values.chunks(CHUNK) {
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
            let new: Vec<&Vec<f64>> = chunk.iter().filter(|values| !self.known.contains_key(&bits(values))).collect();
            let results: Vec<Numbers> = new.par_iter().map(|values| numbers(problem, values)).collect();
            for (values, numbers) in new.into_iter().zip(results) {
                self.remember(bits(values), numbers)?;
            }
            self.flush()?;
            progress(chunk.len());
        }
        Ok(Some(values.iter().map(|values| self.known[&bits(values)].clone()).collect()))
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.known.len()
    }

    fn remember(&mut self, bits: Vec<u64>, numbers: Numbers) -> Result<(), Failure> {
        if self.known.contains_key(&bits) {
            return Ok(());
        }
        let values = bits.iter().map(|bits| f64::from_bits(*bits).to_string());
        let results = numbers.iter().flatten().flatten().map(f64::to_string);
        let mut record: Vec<String> = [self.digest.clone()].into_iter().chain(values).chain(results).collect();
        if numbers.is_none() {
            record.push("refused".into());
        }
        self.writer.write_record(&record).map_err(|error| Failure::writing(&self.path, error))?;
        self.known.insert(bits, numbers);
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Failure> {
        self.writer.flush().map_err(|error| Failure::writing(&self.path, error))
    }
}

fn numbers(problem: &Problem, values: &[f64]) -> Numbers {
    let impacts = evaluate(problem, values).impacts;
    let whole = !impacts.is_empty() && impacts.iter().all(|impact| impact.values.iter().all(|value| *value > 0.0));
    whole.then(|| impacts.iter().map(|impact| impact.values).collect())
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

fn header(problem: &Problem) -> Vec<String> {
    let variables = problem.variables.iter().map(|variable| format!("{} [{}]", variable.name, variable.unit));
    let numbers = problem.targets.iter().flat_map(|target| {
        QUANTITIES.each_ref().map(|quantity| format!("{} J: {} [{}]", target.energy, quantity.key, quantity.unit()))
    });
    ["problem".to_string()].into_iter().chain(variables).chain(numbers).collect()
}

/// The lines that are whole and of this problem.
fn parse(text: &str, header: &[String], problem: &Problem, digest: &str) -> BTreeMap<Vec<u64>, Numbers> {
    let whole = text.rfind('\n').map_or("", |end| &text[..=end]);
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(whole.as_bytes());
    let n = problem.variables.len();
    let line = |record: csv::StringRecord| {
        if record.get(0) != Some(digest) {
            return None;
        }
        let number = |text: &str| text.parse::<f64>().ok();
        let values = record.iter().skip(1).take(n).map(number).collect::<Option<Vec<f64>>>()?;
        let rest: Vec<&str> = record.iter().skip(1 + n).collect();
        if rest == ["refused"] {
            return Some((bits(&values), None));
        }
        let numbers = rest.iter().map(|text| number(text)).collect::<Option<Vec<f64>>>()?;
        let complete = values.len() == n && record.len() == header.len();
        let impacts = numbers.chunks_exact(COUNT).map(|four| std::array::from_fn(|i| four[i])).collect();
        complete.then_some((bits(&values), Some(impacts)))
    };
    reader.records().filter_map(Result::ok).filter_map(line).collect()
}
