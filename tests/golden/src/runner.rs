//! The command line that the programs on hosts and microcontrollers share:
//!
//! * `check [--short] [SCENE...]` runs scenes against their traces, all unless named. One line each, then a summary line
//!   with the digests of all scenes.
//! * `trace SCENE` prints the trace of a scene, for a change of the results that is meant.
//! * `save SCENE RECORD FILE` runs a scene up to a record and saves it.
//! * `resume SCENE FILE [RECORD FILE]` takes over a saved state, goes on to the end, or up to a record and saves again,
//!   and compares every record on the way.

use core::fmt::{self, Arguments};

use softanvil_kernel::InstructionSet;
use softanvil_kernel::number::digest::Digest;

use crate::check::Checker;
use crate::memory::{Memory, SNAPSHOT};
use crate::record::{Header, Record};
use crate::run::{Failure, Run};
use crate::scenes::{SCENES, SHORT, Scene};

/// What a program offers to the commands.
pub trait Host {
    /// Prints a line.
    fn line(&mut self, text: Arguments<'_>);
    /// Reads a file; returns its length, or nothing if it cannot be read or is longer than the room.
    fn read(&mut self, name: &str, room: &mut [u8]) -> Option<usize>;
    /// Writes a file; returns whether it could.
    fn write(&mut self, name: &str, bytes: &[u8]) -> bool;
    /// What the steps are made with.
    fn instructions(&self) -> InstructionSet {
        InstructionSet::best()
    }
}

/// What the commands work in.
pub struct Room {
    memory: Memory,
    snapshot: [u8; SNAPSHOT],
}

impl Room {
    /// Room for one command after the other.
    pub const fn new() -> Self {
        Self { memory: Memory::new(), snapshot: [0; SNAPSHOT] }
    }
}

impl Default for Room {
    fn default() -> Self {
        Self::new()
    }
}

const USAGE: &str =
    "usage: check [--short] [SCENE...] | trace SCENE | save SCENE RECORD FILE | resume SCENE FILE [RECORD FILE]";

/// Carries out a command line without the name of the program; returns whether everything agrees.
pub fn execute<'w>(words: impl Iterator<Item = &'w str> + Clone, host: &mut dyn Host, room: &mut Room) -> bool {
    let mut arguments = words.clone().skip(1);
    let mut next = || arguments.next();
    let result = match words.clone().next() {
        Some("check") => return check(words.skip(1), host, room),
        Some("trace") => match next().and_then(Scene::find) {
            Some(scene) => trace(scene, host, room).map_err(Refusal::Run),
            None => Err(Refusal::Usage),
        },
        Some("save") => match (next().and_then(Scene::find), next().map(str::parse), next()) {
            (Some(scene), Some(Ok(record)), Some(file)) => save(scene, record, file, host, room),
            _ => Err(Refusal::Usage),
        },
        Some("resume") => match (next().and_then(Scene::find), next(), next().map(str::parse), next()) {
            (Some(scene), Some(from), Some(Ok(record)), Some(to)) => {
                resume(scene, from, Some((record, to)), host, room)
            }
            (Some(scene), Some(from), None, None) => resume(scene, from, None, host, room),
            _ => Err(Refusal::Usage),
        },
        _ => Err(Refusal::Usage),
    };
    match result {
        Ok(same) => same,
        Err(refusal) => {
            host.line(format_args!("{refusal}"));
            false
        }
    }
}

/// Why a command was not carried out.
enum Refusal<'w> {
    Usage,
    File(&'w str),
    Run(Failure),
}

impl fmt::Display for Refusal<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage => f.write_str(USAGE),
            Self::File(name) => write!(f, "{name} cannot be read or written"),
            Self::Run(failure) => failure.fmt(f),
        }
    }
}

fn check<'w>(words: impl Iterator<Item = &'w str> + Clone, host: &mut dyn Host, room: &mut Room) -> bool {
    let short = words.clone().any(|word| word == "--short");
    let names = words.filter(|word| *word != "--short");
    if let Some(unknown) = names.clone().find(|name| Scene::find(name).is_none()) {
        host.line(format_args!("no scene is called {unknown}"));
        return false;
    }
    let named = |scene: &&Scene| names.clone().next().is_none() || names.clone().any(|name| name == scene.name);
    let mut same = true;
    let mut summary = Summary { scenes: 0, short: Digest::new(), whole: Digest::new() };
    for scene in SCENES.iter().filter(named) {
        same &= check_scene(scene, short, host, &mut room.memory, &mut summary);
    }
    let Summary { scenes, short: until_short, whole } = summary;
    if short {
        host.line(format_args!("summary {scenes} {:016x} -", until_short.value()));
    } else {
        host.line(format_args!("summary {scenes} {:016x} {:016x}", until_short.value(), whole.value()));
    }
    same
}

/// Digests over the last records of all scenes.
struct Summary {
    scenes: u64,
    short: Digest,
    whole: Digest,
}

fn check_scene(
    scene: &'static Scene,
    short: bool,
    host: &mut dyn Host,
    memory: &mut Memory,
    summary: &mut Summary,
) -> bool {
    let last = if short { SHORT } else { u64::MAX };
    let mut at_short = None;
    let played = Run::new(scene, memory).and_then(|mut run| {
        run.instructions = host.instructions();
        play(&mut run, scene, last, host, |number, record| {
            if number == SHORT {
                at_short = Some(record.state);
            }
        })
    });
    let name = scene.name;
    match played {
        Ok(Played { record, same }) => {
            summary.scenes += 1;
            summary.short.word(at_short.unwrap_or_default());
            summary.whole.word(record.state);
            let verdict = if same { "same" } else { "DIFFERENT" };
            host.line(format_args!("{name:<16} {:>6} {:016x} {verdict}", record.step, record.state));
            same
        }
        Err(failure) => {
            host.line(format_args!("{name:<16} FAILED: {failure}"));
            false
        }
    }
}

/// How far a scene came.
struct Played {
    record: Record,
    same: bool,
}

/// Runs up to record `last`, or to the end, and compares on the way; tells the first difference.
fn play(
    run: &mut Run,
    scene: &'static Scene,
    last: u64,
    host: &mut dyn Host,
    mut seen: impl FnMut(u64, &Record),
) -> Result<Played, Failure> {
    let mut checker = Checker::new(scene.trace);
    let mut record = run.record();
    let mut number = record.step.checked_div(run.stride()).unwrap_or_default();
    checker.skip_to(record.step);
    let mut same = true;
    loop {
        if same && let Err(difference) = checker.check(&record) {
            host.line(format_args!("{}: {difference}", scene.name));
            same = false;
        }
        seen(number, &record);
        if number >= last {
            break;
        }
        match run.advance()? {
            Some(next) => record = next,
            None => break,
        }
        number += 1;
    }
    if same && last == u64::MAX && checker.has_more() {
        host.line(format_args!("{}: the trace goes on after step {}", scene.name, record.step));
        same = false;
    }
    Ok(Played { record, same })
}

fn trace(scene: &'static Scene, host: &mut dyn Host, room: &mut Room) -> Result<bool, Failure> {
    let mut run = Run::new(scene, &mut room.memory)?;
    host.line(format_args!("{}", Header::new(scene, &run.model)));
    host.line(format_args!("{}", run.record()));
    while let Some(record) = run.advance()? {
        host.line(format_args!("{record}"));
    }
    Ok(true)
}

fn save<'w>(
    scene: &'static Scene,
    last: u64,
    file: &'w str,
    host: &mut dyn Host,
    room: &mut Room,
) -> Result<bool, Refusal<'w>> {
    let mut run = Run::new(scene, &mut room.memory).map_err(Refusal::Run)?;
    run.instructions = host.instructions();
    finish(&mut run, scene, Some((last, file)), host, &mut room.snapshot)
}

fn resume<'w>(
    scene: &'static Scene,
    from: &'w str,
    to: Option<(u64, &'w str)>,
    host: &mut dyn Host,
    room: &mut Room,
) -> Result<bool, Refusal<'w>> {
    let mut run = Run::new(scene, &mut room.memory).map_err(Refusal::Run)?;
    run.instructions = host.instructions();
    let length = host.read(from, &mut room.snapshot).ok_or(Refusal::File(from))?;
    run.restore(room.snapshot.get(..length).unwrap_or_default()).map_err(Refusal::Run)?;
    host.line(format_args!("{} taken over at step {}", scene.name, run.state.scalars.step_index));
    finish(&mut run, scene, to, host, &mut room.snapshot)
}

/// Plays to the end, or up to a record that is saved.
fn finish<'w>(
    run: &mut Run,
    scene: &'static Scene,
    to: Option<(u64, &'w str)>,
    host: &mut dyn Host,
    snapshot: &mut [u8],
) -> Result<bool, Refusal<'w>> {
    let last = to.map_or(u64::MAX, |(record, _)| record);
    let Played { record, same } = play(run, scene, last, host, |_, _| ()).map_err(Refusal::Run)?;
    if let Some((_, file)) = to {
        let bytes = run.save(snapshot).map_err(Refusal::Run)?;
        if !host.write(file, bytes) {
            return Err(Refusal::File(file));
        }
    }
    let verdict = if same { "same" } else { "DIFFERENT" };
    host.line(format_args!("{:<16} {:>6} {:016x} {verdict}", scene.name, record.step, record.state));
    Ok(same)
}
