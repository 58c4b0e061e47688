//! The golden traces on this machine: run, compared, written.

use std::fmt::{Display, Write};
use std::path::Path;

use rayon::prelude::*;
use softanvil_golden::run::Failure as RunFailure;
use softanvil_golden::scenes::digest;
use softanvil_golden::{Checker, Header, Memory, Record, Run, SCENES, Scene};

use crate::failure::Failure;

/// A scene that was run to its end.
pub struct Played {
    /// The scene.
    pub scene: &'static Scene,
    /// A record per stride, the start included.
    pub records: Vec<Record>,
    header: Header,
}

impl Played {
    fn new(scene: &'static Scene) -> Result<Self, RunFailure> {
        let mut memory = Box::new(Memory::new());
        let mut run = Run::new(scene, &mut memory)?;
        let mut records = vec![run.record()];
        while let Some(record) = run.advance()? {
            records.push(record);
        }
        Ok(Self { scene, records, header: Header::new(scene, &run.model) })
    }

    /// The last record.
    pub fn end(&self) -> &Record {
        &self.records[self.records.len() - 1]
    }

    /// The first difference from the trace, in words; none if there is none.
    pub fn difference(&self) -> Option<String> {
        let mut checker = Checker::new(self.scene.trace);
        for record in &self.records {
            if let Err(difference) = checker.check(record) {
                return Some(difference.to_string());
            }
        }
        checker.has_more().then(|| format!("the trace goes on after step {}", self.end().step))
    }

    /// The trace file.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n", self.header);
        for record in &self.records {
            let _ = writeln!(text, "{record}");
        }
        text
    }
}

/// The kernel digest that these runs have; none unless they are all scenes.
pub fn kernel_digest(played: &[Played]) -> Option<u64> {
    (played.len() == SCENES.len()).then(|| digest(played.iter().map(|played| played.end().state)))
}

/// Whether the file at `path` is a trace of `scene`.
pub fn is_trace(path: &Path, scene: &Scene) -> bool {
    let text = std::fs::read_to_string(path).unwrap_or_default();
    text.starts_with(&format!("# {}: ", scene.name)) && text.contains("contact_force_N")
}

/// The scenes called `names`, all if there are none.
///
/// # Errors
/// A name that no scene has.
pub fn scenes(names: &[String]) -> Result<Vec<&'static Scene>, Failure> {
    if names.is_empty() {
        return Ok(SCENES.iter().collect());
    }
    let find = |name: &String| {
        Scene::find(name).ok_or_else(|| {
            let known: Vec<_> = SCENES.iter().map(|scene| scene.name).collect();
            Failure::Input(format!("scene {name} is unknown: expected {}", known.join(", ")))
        })
    };
    names.iter().map(find).collect()
}

/// Runs scenes on as many threads as the machine has cores.
///
/// # Errors
/// A scene that cannot be simulated.
pub fn play(scenes: &[&'static Scene]) -> Result<Vec<Played>, Failure> {
    let failed = |scene: &Scene, error: &dyn Display| Failure::Failed(format!("scene {}: {error}", scene.name));
    let play = |scene: &&'static Scene| Played::new(scene).map_err(|error| failed(scene, &error));
    scenes.par_iter().map(play).collect()
}
