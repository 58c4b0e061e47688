//! All cases of a study, on all cores, the longest first; the results do not depend on how many there are.

use std::fs::File;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use softanvil_kernel::Scenario;

use super::case::{Case, Outcome};
use super::columns;
use super::results::{Results, Study};
use crate::failure::Failure;
use crate::output::subject::Subject;
use crate::progress;

/// The file of a running study: a line as soon as a case is done, in the order in which they end.
pub struct Journal<'a> {
    path: &'a Path,
    study: &'static Study,
    csv: csv::Writer<File>,
}

impl<'a> Journal<'a> {
    /// Begins the file.
    ///
    /// # Errors
    /// A file that cannot be written.
    pub fn new(path: &'a Path, study: &'static Study) -> Result<Self, Failure> {
        let failed = |error: &dyn std::fmt::Display| Failure::writing(path, error);
        let mut csv = csv::Writer::from_path(path).map_err(|error| failed(&error))?;
        csv.write_record(columns::header(study)).map_err(|error| failed(&error))?;
        csv.flush().map_err(|error| failed(&error))?;
        Ok(Self { path, study, csv })
    }

    fn add(&mut self, number: usize, case: &Case, outcome: &Result<Outcome, String>) -> Result<(), Failure> {
        let written = self.csv.write_record(columns::record(self.study, number, &case.settings, outcome));
        written.map_err(|error| Failure::writing(self.path, error))?;
        self.csv.flush().map_err(|error| Failure::writing(self.path, error))
    }
}

/// Simulates the cases of `study`, changes of the drop of `subject`, until `stop`; what is done by then is in the results.
///
/// # Errors
/// A journal that cannot be written.
pub fn sweep(
    study: &'static Study,
    subject: &Subject,
    cases: Vec<Case>,
    stop: &AtomicBool,
    journal: Option<Journal>,
) -> Result<Results, Failure> {
    let work: Vec<u64> = cases.iter().map(Case::work).collect();
    let mut order: Vec<usize> = (0..cases.len()).collect();
    order.sort_by_key(|index| std::cmp::Reverse(work[*index]));
    let bar = progress::sweep(work.iter().sum());
    bar.set_prefix(study.name);
    bar.set_message(format!("0 of {}", cases.len()));
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let journal = Mutex::new((journal, None));
    let outcomes: Vec<Mutex<Option<Result<Outcome, String>>>> = cases.iter().map(|_| Mutex::new(None)).collect();
    rayon::broadcast(|_| {
        while let Some(&index) = order.get(next.fetch_add(1, Ordering::Relaxed)) {
            let case = &cases[index];
            let elements = case.scenario.as_ref().map_or(0, elements);
            let outcome = case.simulate(subject.until, |steps| {
                bar.inc(steps * elements);
                !stop.load(Ordering::Relaxed)
            });
            let Some(outcome) = outcome.transpose() else { return };
            record(&journal, index, case, &outcome);
            *lock(&outcomes[index]) = Some(outcome);
            bar.set_message(format!("{} of {}", done.fetch_add(1, Ordering::Relaxed) + 1, cases.len()));
        }
    });
    bar.finish_and_clear();
    if let (_, Some(failure)) = journal.into_inner().unwrap_or_else(|poisoned| poisoned.into_inner()) {
        return Err(failure);
    }
    let outcomes = outcomes.into_iter().map(|outcome| outcome.into_inner().unwrap_or(None)).collect();
    Ok(Results { study, scenario: subject.scenario.clone(), preset: subject.preset, cases, outcomes })
}

fn elements(scenario: &Scenario) -> u64 {
    softanvil_kernel::mesh::Grid::new(scenario).map_or(0, |grid| grid.n_elem() as u64)
}

/// Adds a line to the journal; the first failure is kept.
fn record(
    journal: &Mutex<(Option<Journal>, Option<Failure>)>,
    index: usize,
    case: &Case,
    outcome: &Result<Outcome, String>,
) {
    let (journal, failure) = &mut *lock(journal);
    if let Some(Err(error)) = journal.as_mut().map(|journal| journal.add(index, case, outcome)) {
        failure.get_or_insert(error);
    }
}

/// The content; a thread that panicked leaves it as it was.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}
