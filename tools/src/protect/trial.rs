//! The drops on several pads and on the bare anvil, all at once on all cores.

use std::path::Path;

use rayon::prelude::*;
use softanvil_kernel::{Changes, Scenario};

use super::numbers::Numbers;
use super::padding;
use super::standard::{self, Standard};
use super::verdict::Verdict;
use super::watch::Watch;
use crate::failure::Failure;
use crate::output::subject::Subject;
use crate::run::{Drop, Run, RunError};
use crate::scenario_file::{self, names};
use crate::section::Animation;
use crate::{progress, run};

/// A drop that is to be simulated.
#[derive(Clone, Debug)]
pub struct Case {
    /// What it is called, by its file, or "pad".
    pub name: String,
    /// Its scenario.
    pub scenario: Scenario,
}

/// A drop that was simulated.
pub struct Outcome {
    /// The run.
    pub run: Run,
    /// The section, if it was to be shown.
    pub animation: Option<Animation>,
    /// Its numbers.
    pub numbers: Numbers,
    /// What is said of it.
    pub verdict: Verdict,
}

/// Several pads, simulated.
pub struct Trial {
    /// Which drop it is.
    pub subject: Subject,
    /// The standard whose set-up the preset is.
    pub standard: Option<&'static Standard>,
    /// The bare anvil; none where a rigid one is left.
    pub bare: Option<Outcome>,
    /// The pads, in the order of the options; of those that could not be simulated, why.
    pub pads: Vec<(Case, Result<Outcome, String>)>,
}

/// The cases of `files`, each laid over the drop of `subject`, with each of the pad's `thicknesses`, m; of no files the drop
/// itself, of no thicknesses its own.
///
/// # Errors
/// A file or a thickness that is refused, or a file that changes the anvil or the impactor.
pub fn cases(subject: &Subject, files: &[impl AsRef<Path>], thicknesses: &[f64]) -> Result<Vec<Case>, Failure> {
    let mut pads = Vec::new();
    for path in files.iter().map(AsRef::as_ref) {
        let scenario = scenario_file::read(path, &subject.scenario)?;
        if rest(&scenario) != rest(&subject.scenario) {
            let legal = "expected a file of the pad alone, so that the drops differ by nothing else";
            return Err(Failure::Input(format!("{} changes the anvil or the impactor: {legal}", path.display())));
        }
        pads.push(Case { name: name(path), scenario });
    }
    if pads.is_empty() {
        pads.push(Case { name: padding::PAD.into(), scenario: subject.scenario.clone() });
    }
    let mut cases = Vec::new();
    for case in pads {
        if thicknesses.is_empty() {
            cases.push(case);
            continue;
        }
        for thickness in thicknesses {
            cases.push(Case { scenario: of_thickness(&case.scenario, *thickness)?, ..case.clone() });
        }
    }
    Ok(cases)
}

/// What a pad of the file at `path` is called: by its folder, where the file has the name that `softanvil fit` gives each.
fn name(path: &Path) -> String {
    const OF_FIT: [&str; 2] = ["material", "scenario"];
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().and_then(Path::file_name).map(|folder| folder.to_string_lossy().into_owned());
    folder.filter(|_| OF_FIT.contains(&stem.as_str())).unwrap_or(stem)
}

/// What a scenario says of all but the pad and of how it is simulated; the layers left are those under the pad.
fn rest(scenario: &Scenario) -> Scenario {
    let own = softanvil_kernel::preset::study();
    let mut rest = Scenario { mesh: own.mesh, time: own.time, measurement: own.measurement, ..scenario.clone() };
    rest.layers.truncate(padding::place(scenario));
    rest
}

/// `scenario` with a pad whose lowest layer has this thickness, m.
fn of_thickness(scenario: &Scenario, thickness: f64) -> Result<Scenario, Failure> {
    let refuse = |error: &dyn std::fmt::Display| Failure::Input(format!("--thickness {} mm: {error}", 1e3 * thickness));
    let mut changes = Changes::of(scenario);
    let name = format!("layers[{}].thickness", padding::place(scenario));
    let parameter = names::find(changes.values(), &name).map_err(|error| refuse(&error))?;
    changes.set(parameter, thickness).map_err(|error| refuse(&error))?;
    changes.apply().map_err(|error| refuse(&error))
}

impl Trial {
    /// Simulates `cases` and the bare anvil; with `sections` they are recorded to be shown.
    ///
    /// # Errors
    /// A bare anvil that cannot be simulated, or no pad that can.
    pub fn new(subject: Subject, cases: Vec<Case>, sections: bool) -> Result<Self, Failure> {
        let standard = standard::find(subject.preset.name);
        let preset = (subject.preset.scenario)();
        let bare = padding::bare(&subject.scenario).map(|scenario| Case { name: "bare".into(), scenario });
        let all: Vec<&Case> = bare.iter().chain(&cases).collect();
        // All at once, for the number of their steps: a section takes some hundred kilobytes.
        let ready: Vec<Result<Drop, RunError>> =
            progress::set_up(|| all.par_iter().map(|case| Drop::until(&case.scenario, subject.until)).collect());
        let bar = progress::bar(ready.iter().flatten().map(Drop::steps).sum());
        bar.set_message(format!("{} drops", all.len()));
        let simulate = |(case, drop): (&&Case, Result<Drop, RunError>)| {
            let outcome = simulate(drop?, sections, |steps| bar.inc(steps));
            let judged = |outcome: Outcome| {
                let verdict = Verdict::new(&outcome.numbers, standard, &case.scenario, &preset);
                Outcome { verdict, ..outcome }
            };
            outcome.map(judged)
        };
        let mut outcomes: Vec<Result<Outcome, Failure>> = all.par_iter().zip(ready).map(simulate).collect();
        bar.finish_and_clear();
        let bare_anvil = usize::from(bare.is_some());
        let pads = outcomes.split_off(bare_anvil);
        if let (true, Some(Err(_))) = (pads.iter().all(Result::is_err), pads.first()) {
            return Err(pads.into_iter().find_map(Result::err).unwrap_or(Failure::Failed("no pad".into())));
        }
        let pads = cases.into_iter().zip(pads.into_iter().map(|pad| pad.map_err(|error| error.to_string())));
        // A bare anvil is no pad to be judged.
        let unjudged = |bare: Outcome| Outcome { verdict: Verdict::NoStandard, ..bare };
        Ok(Self { bare: outcomes.pop().transpose()?.map(unjudged), pads: pads.collect(), subject, standard })
    }

    /// The pads that were simulated.
    pub fn done(&self) -> impl Iterator<Item = (&Case, &Outcome)> {
        self.pads.iter().filter_map(|(case, outcome)| Some((case, outcome.as_ref().ok()?)))
    }

    /// What tells a case from the others.
    pub fn label(&self, case: &Case) -> String {
        let names = self.pads.iter().any(|(other, _)| other.name != case.name);
        let thicknesses = self.pads.iter().any(|(other, _)| {
            other.name == case.name && padding::thickness(&other.scenario) != padding::thickness(&case.scenario)
        });
        let thickness = format!("{} mm", crate::text::number::short(1e3 * padding::thickness(&case.scenario)));
        match (names, thicknesses) {
            (true, true) => format!("{}, {thickness}", case.name),
            (false, true) => thickness,
            _ => case.name.clone(),
        }
    }

    /// What a reader has to know of the ends of the runs, in lines.
    pub fn remarks(&self) -> String {
        let of = |name: &str, outcome: &Outcome| {
            let remark = run::remark(&outcome.run);
            if remark.is_empty() { remark } else { format!("{name}: {remark}") }
        };
        let bare = self.bare.iter().map(|outcome| of("bare", outcome));
        bare.chain(self.done().map(|(case, outcome)| of(&self.label(case), outcome))).collect()
    }
}

fn simulate(drop: Drop, sections: bool, progress: impl Fn(u64)) -> Result<Outcome, Failure> {
    let (mut watch, mut animation) = (Watch::default(), sections.then(Animation::default));
    let run = drop.run_watched(|steps, simulation| {
        progress(steps);
        if let Some(animation) = &mut animation {
            animation.take(simulation)?;
        }
        watch.take(simulation)
    })?;
    let numbers = Numbers::new(&run, watch.layers());
    Ok(Outcome { run, animation, numbers, verdict: Verdict::NoStandard })
}
