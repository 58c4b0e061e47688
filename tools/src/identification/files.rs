//! Curves from the files of a test machine.

use std::path::{Path, PathBuf};

use softanvil_identify::data::curve;
use softanvil_identify::data::cycles::{self, Selection};
use softanvil_identify::data::point::Point;
use softanvil_identify::data::repeats::{self, Repeats};
use softanvil_identify::data::thinned::thinned;
use softanvil_identify::law::{DataSet, Mode};
use softanvil_records::ReadError;

use crate::failure::Failure;

/// A file as it is.
pub struct Source {
    /// Its path.
    pub path: PathBuf,
    /// Its content.
    pub bytes: Vec<u8>,
}

impl Source {
    /// Reads the file.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn read(path: &Path) -> Result<Self, Failure> {
        let bytes = std::fs::read(path).map_err(|error| Failure::Input(format!("{}: {error}", path.display())))?;
        Ok(Self { path: path.into(), bytes })
    }

    /// The failure that `error` in this file is.
    pub fn refused(&self, error: &ReadError) -> Failure {
        Failure::Input(format!("{}: {error}", self.path.display()))
    }

    /// Its name without folders.
    pub fn name(&self) -> String {
        self.path.file_name().unwrap_or_default().to_string_lossy().into_owned()
    }
}

/// The data of one kind of test.
pub struct Curves {
    /// What is fitted.
    pub data: DataSet,
    /// Names of the files.
    pub files: Vec<String>,
    /// Number of specimens.
    pub n_specimen: usize,
    /// (stretch, volume over that at rest) of states in which the files tell the volume.
    pub volumes: Vec<(f64, f64)>,
    /// Names of the files, and what they say beside numbers.
    pub words: String,
    /// How the files were understood where they left a choice.
    pub notes: Vec<String>,
    /// What speaks against their numbers.
    pub warnings: Vec<String>,
}

/// How files become curves.
pub struct Reading {
    /// What the files leave open.
    pub curve: curve::Options,
    /// Which part of a cyclic test to use.
    pub selection: Selection,
    /// How several specimens count.
    pub repeats: Repeats,
}

impl Curves {
    /// The data of `mode` in `paths`.
    ///
    /// # Errors
    /// A file that cannot be read or understood.
    pub fn read(mode: Mode, paths: &[PathBuf], reading: &Reading) -> Result<Self, Failure> {
        let mut notes: Vec<String> = Vec::new();
        let mut files = Vec::new();
        let mut specimens: Vec<Vec<Point>> = Vec::new();
        let (mut volumes, mut words, mut warnings) = (Vec::new(), String::new(), Vec::new());
        for path in paths {
            let source = Source::read(path)?;
            let name = source.name();
            let options = curve::Options { shear: mode == Mode::SimpleShear, ..reading.curve.clone() };
            let curve = curve::read(&name, &source.bytes, &options).map_err(|error| source.refused(&error))?;
            let mut say = |note: &str| notes.push(format!("{name}: {note}"));
            curve.notes.iter().for_each(|note| say(note));
            warnings.extend(curve.warnings.iter().map(|warning| format!("{name}: {warning}")));
            for repeat in &curve.repeats {
                let label = if repeat.name.is_empty() { String::new() } else { format!("specimen {}: ", repeat.name) };
                let mut own = Vec::new();
                let points = cycles::select(&repeat.points, reading.selection, &mut own)
                    .map_err(|reason| Failure::Input(format!("{}: {label}{reason}", path.display())))?;
                let points = thinned(points, &mut own);
                own.iter().for_each(|note| say(&format!("{label}{note}")));
                specimens.push(points);
            }
            volumes.extend(curve.volumes);
            words += &format!("{name}\n{}\n", curve.words);
            files.push(name);
        }
        let n_specimen = specimens.len();
        let points = match reading.repeats {
            Repeats::Median => medians(mode, specimens, &mut notes)
                .map_err(|reason| Failure::Input(format!("--{}: {reason}", mode.name())))?,
            Repeats::All => specimens.concat(),
        };
        // Of a shear the stretch is 1 more than the amount.
        let rest = if mode == Mode::SimpleShear { 1.0 } else { 0.0 };
        let points = points.iter().map(|point| (point.stretch - rest, point.stress)).collect();
        Ok(Self { data: DataSet { mode, points }, files, n_specimen, volumes, words, notes, warnings })
    }
}

/// The median curve of the specimens in tension and that of those in compression; of those in shear together.
fn medians(mode: Mode, specimens: Vec<Vec<Point>>, notes: &mut Vec<String>) -> Result<Vec<Point>, String> {
    let compressed = |points: &Vec<Point>| {
        mode != Mode::SimpleShear && points.iter().map(|point| point.stretch).sum::<f64>() < points.len() as f64
    };
    let (compression, tension): (Vec<_>, Vec<_>) = specimens.into_iter().partition(compressed);
    let mut points = Vec::new();
    for group in [compression, tension] {
        match group.as_slice() {
            [] => {}
            [only] => points.extend_from_slice(only),
            several => {
                notes.push(format!("median curve of {} specimens; --repeats all uses every point", several.len()));
                points.extend(repeats::median(several)?);
            }
        }
    }
    Ok(points)
}
