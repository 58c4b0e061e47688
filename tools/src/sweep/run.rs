//! All cases of a sweep, on all cores, the longest first; the results do not depend on how many there are.

use std::cmp::Reverse;
use std::fs::File;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use indicatif::ProgressBar;
use itertools::Itertools;
use rayon::prelude::*;

use super::Sweep;
use super::case::{Case, Outcome};
use super::columns;
use super::results::Results;
use crate::failure::Failure;
use crate::output::subject::Subject;
use crate::progress;
use crate::run::{Drop, Until};

/// The file of a running sweep: a line as soon as a case is done, in the order in which they end.
pub struct Journal<'a> {
    path: &'a Path,
    csv: csv::Writer<File>,
}

impl<'a> Journal<'a> {
    /// Begins the file.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn new(path: &'a Path, sweep: &Sweep) -> Result<Self, Failure> {
        let csv = csv::Writer::from_path(path).map_err(|error| Failure::writing(path, error))?;
        let mut journal = Self { path, csv };
        journal.add(&columns::header(sweep))?;
        Ok(journal)
    }

    fn add(&mut self, record: &[String]) -> Result<(), Failure> {
        let written = self.csv.write_record(record);
        written.map_err(|error| Failure::writing(self.path, error))?;
        self.csv.flush().map_err(|error| Failure::writing(self.path, error))
    }
}

/// What the threads share.
struct Shared<'a> {
    until: Until,
    stop: &'a AtomicBool,
    bar: ProgressBar,
    done: AtomicUsize,
    journal: Mutex<Option<Journal<'a>>>,
}

/// Simulates the `cases` of `sweep`, changes of the drop of `subject`, until `stop`; what is done by then is in the results.
///
/// # Errors
/// A journal that cannot be written.
pub fn run(
    sweep: Sweep,
    subject: &Subject,
    cases: Vec<Case>,
    stop: &AtomicBool,
    journal: Option<Journal>,
) -> Result<Results, Failure> {
    let bar = progress::sweep(cases.iter().map(|case| case.work).sum());
    bar.set_prefix(sweep.name.clone());
    bar.set_message(format!("0 of {}", cases.len()));
    let shared = Shared { until: subject.until, stop, bar, done: AtomicUsize::new(0), journal: Mutex::new(journal) };
    // A bridge hands them out in this order.
    let order = cases.iter().enumerate().sorted_by_key(|(_, case)| Reverse(case.work));
    let done: Vec<_> = order
        .par_bridge()
        .map(|(number, case)| Ok((number, shared.simulate(number, case, cases.len())?)))
        .collect::<Result<_, Failure>>()?;
    shared.bar.finish_and_clear();
    let outcomes = done.into_iter().sorted_by_key(|(number, _)| *number).map(|(_, outcome)| outcome).collect();
    Ok(Results { sweep, scenario: subject.scenario.clone(), cases, outcomes })
}

impl Shared<'_> {
    /// Simulates a case; nothing if it was stopped.
    fn simulate(&self, number: usize, case: &Case, all: usize) -> Result<Option<Result<Outcome, String>>, Failure> {
        let go_on = || !self.stop.load(Ordering::Relaxed);
        if !go_on() {
            return Ok(None);
        }
        let run = Drop::until(&case.scenario, self.until).and_then(|drop| {
            let share = case.work as f64 / drop.steps().max(1) as f64;
            drop.run_while(|steps| {
                self.bar.inc((share * steps as f64) as u64);
                go_on()
            })
        });
        let outcome = run.map(|run| run.map(Outcome::new)).map_err(|error| error.to_string());
        let Some(outcome) = outcome.transpose() else { return Ok(None) };
        if let Some(journal) = self.journal.lock().unwrap_or_else(PoisonError::into_inner).as_mut() {
            journal.add(&columns::record(number, &case.settings, &outcome))?;
        }
        self.bar.set_message(format!("{} of {all}", self.done.fetch_add(1, Ordering::Relaxed) + 1));
        Ok(Some(outcome))
    }
}
