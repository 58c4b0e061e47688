//! From columns of deformation and load to strains and nominal stresses: units, the specimen's size, and measures.

use super::ReadError;
use super::column::{Column, Kind, Measure};
use super::series::{Series, Table};

/// Size of a specimen at rest.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Specimen {
    /// Cross-section that a force acts on, m2.
    pub area: Option<f64>,
    /// Length or height that a displacement changes, m.
    pub height: Option<f64>,
}

/// A strain above this without a unit may be meant in percent: few silicones tear beyond 10 (1000 %).
const LARGEST_RATIO: f64 = 10.0;

impl Specimen {
    /// Pa of nominal (or true) stress in one unit of `load`.
    ///
    /// # Errors
    /// A column without a unit, or a force without a cross-section.
    pub fn stress_per_unit(&self, table: &Table, load: &Column) -> Result<f64, ReadError> {
        match (load.kind, self.area) {
            (Kind::Force, Some(area)) => Ok(table.si(load)? / area),
            (Kind::Force, None) => Err(needs(load, "--area or --diameter of the specimen")),
            _ => table.si(load),
        }
    }

    /// Strain in one unit of `deformation`; says in `notes` if that is a guess.
    ///
    /// # Errors
    /// A displacement without a unit or a length, or numbers without a unit that may be percentages.
    pub fn strain_per_unit(
        &self,
        table: &Table,
        series: &Series,
        deformation: &Column,
        notes: &mut Vec<String>,
    ) -> Result<f64, ReadError> {
        if deformation.kind == Kind::Displacement {
            let height = self
                .height
                .ok_or_else(|| needs(deformation, "--height, the specimen's length in the loaded direction"))?;
            return Ok(table.si(deformation)? / height);
        }
        if let Some(si) = deformation.si {
            return Ok(si);
        }
        let title = &deformation.title;
        if let Some(factor) = told_by_true_strains(table, series, deformation)? {
            let note = format!("{title} has no unit, read as {}: the true strains say so", words(factor));
            if !notes.contains(&note) {
                notes.push(note);
            }
            return Ok(factor);
        }
        let mut largest: f64 = 0.0;
        for row in &series.rows {
            let value = table.value(deformation, row)?.unwrap_or_default();
            if value.abs() > LARGEST_RATIO {
                let reason = format!(
                    "{title} = {value} has no unit and may be a ratio or a percentage: write the unit in the title or name \
                     it with --columns (of a relaxation --relaxation-columns), such as \"strain [%]\" or \"stretch [-]\""
                );
                return Err(ReadError::line(row.line, reason));
            }
            largest = largest.max(value.abs());
        }
        if deformation.kind == Kind::Strain {
            let note = format!("{title} has no unit, read as a ratio: up to {:.4} %", 100.0 * largest);
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        Ok(1.0)
    }
}

/// A ratio and a percentage.
const FACTORS: [f64; 2] = [1.0, 0.01];
/// Part of the true strains by which ln(1 + e) may miss them: the digits that a file leaves off.
const ROUNDED: f64 = 0.02;

fn words(factor: f64) -> &'static str {
    if factor == 1.0 { "a ratio" } else { "a percentage" }
}

/// The factor of engineering strains without a unit that makes them those of a column of true strains; none if there is no
/// such column, or both factors do, or neither.
fn told_by_true_strains(table: &Table, series: &Series, strain: &Column) -> Result<Option<f64>, ReadError> {
    let is_true = |column: &&Column| column.measure == Some(Measure::True);
    let engineering = strain.kind == Kind::Strain && strain.measure.is_none_or(|m| m == Measure::Engineering);
    let Some(other) = table.of(Kind::Strain).find(is_true).filter(|_| engineering) else { return Ok(None) };
    let mut rows = Vec::new();
    for row in &series.rows {
        rows.extend(table.value(strain, row)?.zip(table.value(other, row)?));
    }
    let size: f64 = rows.iter().map(|row| row.1.abs()).sum();
    let fits = |factor: &f64| {
        let (factor, other) = (*factor, other.si.unwrap_or(*factor));
        let error: f64 = rows.iter().map(|row| ((factor * row.0).ln_1p() - other * row.1).abs()).sum();
        error < ROUNDED * other * size
    };
    let mut fitting = FACTORS.into_iter().filter(fits);
    Ok(fitting.next().filter(|_| fitting.next().is_none()))
}

fn needs(column: &Column, option: &str) -> ReadError {
    ReadError::file(format!("column \"{}\" needs {option}", column.title))
}

/// What is 0 at rest in a column of this kind, in strains: a stretch is an engineering strain more than 1.
pub fn at_rest(kind: Kind) -> f64 {
    if kind == Kind::Stretch { 1.0 } else { 0.0 }
}

/// Stretches that are read: beyond them powers of the stretch leave the range of numbers.
const LEGAL: std::ops::RangeInclusive<f64> = 0.01..=100.0;

impl Measure {
    /// The stretch at a `strain` of this measure in `line`.
    ///
    /// # Errors
    /// A strain that no specimen can have.
    pub fn stretch(self, strain: f64, line: usize) -> Result<f64, ReadError> {
        let stretch = match self {
            Self::Engineering => 1.0 + strain,
            Self::True => strain.exp(),
            Self::Lagrange => (1.0 + 2.0 * strain).max(0.0).sqrt(),
        };
        if LEGAL.contains(&stretch) {
            return Ok(stretch);
        }
        let reason = format!(
            "strain {strain} is refused: expected a stretch of {} to {}, an engineering strain above -1 (is it in percent, or \
             a stretch?)",
            LEGAL.start(),
            LEGAL.end()
        );
        Err(ReadError::line(line, reason))
    }

    /// The nominal stress that is `stress` of this measure at `stretch`: P = sigma / l = S l in all three tests, because
    /// the volume stays.
    pub fn nominal(self, stress: f64, stretch: f64) -> f64 {
        match self {
            Self::Engineering => stress,
            Self::True => stress / stretch,
            Self::Lagrange => stress * stretch,
        }
    }

    /// Words for a strain and a stress of it.
    pub fn names(self) -> (&'static str, &'static str) {
        match self {
            Self::Engineering => ("engineering", "engineering"),
            Self::True => ("true", "true"),
            Self::Lagrange => ("Green", "second Piola-Kirchhoff"),
        }
    }
}
