//! From columns of deformation and load to strains and nominal stresses: units, the specimen's size, and measures.

use softanvil_records::ReadError;
use softanvil_records::column::{Column, Kind, Measure};
use softanvil_records::series::{Series, Table};

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

/// What a column of displacement shows of a specimen at rest, in its unit; 0 for other columns.
///
/// A machine counts its way from anywhere. The record begins at rest if its first load is a smaller part of the largest than
/// its first displacement is of the largest; otherwise it begins under load, on a way that counts from 0.
///
/// # Errors
/// A cell that is no number.
pub fn displacement_at_rest(
    table: &Table,
    series: &Series,
    (deformation, load): (&Column, &Column),
    notes: &mut Vec<String>,
) -> Result<f64, ReadError> {
    if deformation.kind != Kind::Displacement {
        return Ok(0.0);
    }
    let (mut first, mut way, mut travel, mut largest) = (None, 0.0_f64, 0.0_f64, 0.0_f64);
    for row in &series.rows {
        if let (Some(moved), Some(load)) = (table.value(deformation, row)?, table.value(load, row)?) {
            let (start, _) = *first.get_or_insert((moved, load));
            way = way.max(moved.abs());
            travel = travel.max((moved - start).abs());
            largest = largest.max(load.abs());
        }
    }
    let (start, load) = first.unwrap_or_default();
    let under_load = load.abs() * way >= 0.5 * start.abs() * largest;
    if start.abs() <= SMALL_START * travel || under_load {
        return Ok(0.0);
    }
    notes.push(format!("{} counts from {start}, where the record begins", deformation.title));
    Ok(start)
}

/// A first displacement up to this part of the travel is noise around 0.
const SMALL_START: f64 = 2e-3;
