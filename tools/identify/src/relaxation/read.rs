//! Time and load of a relaxation test from a file.

use super::history::History;
use super::prony::Relaxation;
use crate::data::ReadError;
use crate::data::column::{Column, Kind, Measure};
use crate::data::number::Decimal;
use crate::data::series::{Series, Table};
use crate::data::sheet;

/// What the file leaves open.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Titles instead of the file's.
    pub columns: Option<Vec<String>>,
    /// Decimal sign of the numbers.
    pub decimal: Option<Decimal>,
    /// Cross-section of the specimen, m2.
    pub area: Option<f64>,
    /// Length of the specimen, m.
    pub height: Option<f64>,
    /// Time in which the strain was applied, s; 0 for a step.
    pub ramp_time: Option<f64>,
    /// Reading of the file's clock when loading began, s.
    pub start: Option<f64>,
    /// Held engineering strain, negative in compression, if no column tells.
    pub strain: Option<f64>,
}

/// What the loads are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Load {
    /// Nominal stress, Pa.
    Stress,
    /// Modulus, Pa.
    Modulus,
    /// Force of a specimen of unknown cross-section, N.
    Force,
}

/// A relaxation test.
#[derive(Clone, Debug)]
pub struct Test {
    /// Load over time; positive.
    pub relaxation: Relaxation,
    /// What the loads are.
    pub load: Load,
    /// Held stretch, if known.
    pub stretch: Option<f64>,
    /// How the file was understood where it left a choice.
    pub notes: Vec<String>,
}

/// Above this number, points are averaged in bins that are even over the logarithm of time, so that the last decade does
/// not outvote the others.
const MOST_POINTS: usize = 1000;
/// Bins in a decade.
const PER_DECADE: f64 = 100.0;

/// Reads the relaxation in `bytes`. `elastic` gives the elastic stress at a stretch, up to a factor; without it the stress
/// is taken as proportional to the strain during loading.
///
/// # Errors
/// What cannot be understood, or in two ways.
pub fn read(bytes: &[u8], options: &Options, elastic: Option<&dyn Fn(f64) -> f64>) -> Result<Test, ReadError> {
    let table = Table::new(sheet::parse(bytes, options.decimal)?, options.columns.as_deref())?;
    let [series] = table.series.as_slice() else {
        return Err(ReadError::file(format!(
            "{} specimens in one file: legal is one relaxation test",
            table.series.len()
        )));
    };
    let mut notes = Vec::new();
    let mut rows = rows(&table, series, options, &mut notes)?;
    let start = options.start.unwrap_or(0.0);
    rows.iter_mut().for_each(|row| row.time -= start);
    let sign = if rows.iter().map(|row| row.load).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
    rows.iter_mut().for_each(|row| row.load *= sign);
    let (history, stretch) = history(&rows, options, elastic, &mut notes)?;
    let load = rows.first().map_or(Load::Stress, |row| row.kind);
    let (times, loads) = thinned(&rows, &mut notes);
    Ok(Test { relaxation: Relaxation { times, loads, history }, load, stretch, notes })
}

/// A row of the file in SI units.
struct Row {
    line: usize,
    time: f64,
    load: f64,
    kind: Load,
    /// Engineering strain, negative in compression.
    strain: Option<f64>,
}

fn one(table: &Table, kind: Kind) -> Result<Option<&Column>, ReadError> {
    let found: Vec<&Column> = table.of(kind).collect();
    // Of the same quantity in two measures the engineering one counts.
    let engineering = found.iter().copied().filter(|column| column.measure != Some(Measure::True));
    match (found.as_slice(), engineering.collect::<Vec<_>>().as_slice()) {
        ([], _) => Ok(None),
        ([only], _) | (_, [only]) => Ok(Some(only)),
        _ => Err(ReadError::file(format!(
            "{} columns of {}: name one with --relaxation-columns, \"-\" for the others",
            found.len(),
            kind.example().0
        ))),
    }
}

fn rows(table: &Table, series: &Series, options: &Options, notes: &mut Vec<String>) -> Result<Vec<Row>, ReadError> {
    let time = one(table, Kind::Time)?
        .ok_or_else(|| ReadError::file("no column of time: name it with --relaxation-columns, such as \"time [s]\""))?;
    if time.si.is_none() {
        notes.push(format!("{} has no unit, read in seconds", time.title));
    }
    let (load, kind) = match (one(table, Kind::Modulus)?, one(table, Kind::Stress)?, one(table, Kind::Force)?) {
        (Some(modulus), ..) => (modulus, Load::Modulus),
        (None, Some(stress), _) => (stress, Load::Stress),
        (None, None, Some(force)) => (force, if options.area.is_some() { Load::Stress } else { Load::Force }),
        _ => return Err(ReadError::file("no column of modulus, stress or force: name it with --relaxation-columns")),
    };
    // Only the shape over time matters for a series; without a unit its size is unknown.
    let unit = match load.kind {
        Kind::Force => load.si.unwrap_or(1.0) / options.area.unwrap_or(1.0),
        _ => table.si(load)?,
    };
    let strain = match (one(table, Kind::Strain)?, one(table, Kind::Stretch)?, one(table, Kind::Displacement)?) {
        (Some(strain), ..) => Some((strain, strain.si.unwrap_or(1.0), 0.0)),
        (None, Some(stretch), _) => Some((stretch, 1.0, 1.0)),
        (None, None, Some(moved)) => match options.height {
            Some(height) => Some((moved, table.si(moved)? / height, 0.0)),
            None => None,
        },
        _ => None,
    };
    let mut rows = Vec::new();
    for row in &series.rows {
        let (Some(seconds), Some(value)) = (table.value(time, row)?, table.value(load, row)?) else { continue };
        let strain = match strain {
            Some((column, factor, offset)) => table.value(column, row)?.map(|strain| strain * factor - offset),
            None => None,
        };
        rows.push(Row { line: row.line, time: seconds * time.si.unwrap_or(1.0), load: value * unit, kind, strain });
    }
    if let Some(pair) = rows.windows(2).find(|pair| pair[1].time < pair[0].time) {
        let reason = format!("time {} s is before that of the line above: legal is time that rises", pair[1].time);
        return Err(ReadError::line(pair[1].line, reason));
    }
    rows.dedup_by(|a, b| a.time == b.time);
    if rows.len() < 5 {
        return Err(ReadError::file("fewer than five points with time and load"));
    }
    Ok(rows)
}

/// What the load relaxes from, and the held stretch.
fn history(
    rows: &[Row],
    options: &Options,
    elastic: Option<&dyn Fn(f64) -> f64>,
    notes: &mut Vec<String>,
) -> Result<(History, Option<f64>), ReadError> {
    if options.ramp_time.is_none() && rows.iter().all(|row| row.strain.is_some()) {
        return measured(rows, options, elastic, notes);
    }
    let stretch = options.strain.map(|strain| 1.0 + strain);
    let peak = rows.iter().enumerate().max_by(|a, b| a.1.load.total_cmp(&b.1.load)).map_or(0, |(index, _)| index);
    let ramp = options.ramp_time.unwrap_or_else(|| {
        if peak == 0 {
            notes.push("no rise of the load in the data: an ideal step; --ramp-time says otherwise".into());
            return 0.0;
        }
        notes.push(format!("ramp time {} s, from the peak of the load; --ramp-time says otherwise", rows[peak].time));
        rows[peak].time.max(0.0)
    });
    let shape = elastic.zip(stretch);
    if ramp > 0.0 {
        notes.push(match shape {
            Some(_) => "the ramp's elastic stress follows the chosen law".into(),
            None => "the ramp's elastic stress is taken as proportional to the strain".to_string(),
        });
    }
    let history = History::ramp(0.0, ramp, |part| match shape {
        Some((law, stretch)) => law(1.0 + part * (stretch - 1.0)) / law(stretch),
        None => part,
    });
    if rows.iter().all(|row| row.time < 0.0) {
        return Err(ReadError::file("all times are before --relaxation-start"));
    }
    Ok((history, stretch))
}

/// The history from a column of strain.
fn measured(
    rows: &[Row],
    options: &Options,
    elastic: Option<&dyn Fn(f64) -> f64>,
    notes: &mut Vec<String>,
) -> Result<(History, Option<f64>), ReadError> {
    let strains: Vec<f64> = rows.iter().filter_map(|row| row.strain).collect();
    let largest = strains.iter().fold(0.0, |a: f64, b| if b.abs() > a.abs() { *b } else { a });
    // A positive strain may be one of compression; the option tells.
    let sign = options.strain.map_or(1.0, |strain| (strain * largest).signum());
    let stretch = 1.0 + sign * largest;
    if largest == 0.0 || stretch <= 0.0 {
        return Err(ReadError::file(format!("the held strain is {largest}: legal is above -1 and not 0")));
    }
    notes.push(format!("loading as measured, held at the engineering strain {:.4}", sign * largest));
    let response = |strain: f64| match elastic {
        Some(law) => law(1.0 + sign * strain) / law(stretch),
        None => strain / largest,
    };
    let knots = rows.iter().zip(&strains).map(|(row, strain)| (row.time, response(*strain))).collect();
    Ok((History::measured(knots), Some(stretch)))
}

/// The points, or their means in bins of the logarithm of time if there are many.
fn thinned(rows: &[Row], notes: &mut Vec<String>) -> (Vec<f64>, Vec<f64>) {
    let rows: Vec<&Row> = rows.iter().filter(|row| row.time >= 0.0).collect();
    if rows.len() <= MOST_POINTS {
        return rows.iter().map(|row| (row.time, row.load)).unzip();
    }
    let bin = |row: &Row| if row.time > 0.0 { (row.time.log10() * PER_DECADE).floor() as i64 } else { i64::MIN };
    let means = rows.chunk_by(|a, b| bin(a) == bin(b)).map(|rows| {
        let mean = |value: fn(&Row) -> f64| rows.iter().map(|row| value(row)).sum::<f64>() / rows.len() as f64;
        (mean(|row| row.time), mean(|row| row.load))
    });
    let (times, loads): (Vec<f64>, Vec<f64>) = means.unzip();
    notes.push(format!("{} points averaged to {}, {PER_DECADE} a decade", rows.len(), times.len()));
    (times, loads)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn test(text: &str, options: &Options) -> Result<Test, ReadError> {
        read(text.as_bytes(), options, None)
    }

    #[test]
    fn loads_of_every_kind_are_read() {
        for (text, load, first) in [
            ("time [s],stress [kPa]\n0,100\n1,80\n2,70\n3,65\n4,62\n", Load::Stress, 1e5),
            ("t;G(t) [MPa]\n0;0,6\n1;0,5\n2;0,4\n3;0,35\n4;0,33\n", Load::Modulus, 6e5),
            ("Zeit [s]\tKraft [N]\n0\t-20\n1\t-15\n2\t-12\n3\t-11\n4\t-10\n", Load::Force, 20.0),
        ] {
            let found = test(text, &Options::default()).unwrap();
            assert_eq!((found.load, found.relaxation.loads[0]), (load, first), "{text}");
            assert_eq!(found.relaxation.history, History::step(0.0), "{text}");
        }
    }

    #[test]
    fn a_rise_of_the_load_is_a_ramp() {
        let text = "time [s],force [N]\n0,0\n0.1,10\n0.2,20\n1,15\n2,12\n";
        let found = test(text, &Options::default()).unwrap();
        assert_eq!(found.relaxation.history.elastic(&[0.1, 0.2, 5.0]), [0.5, 1.0, 1.0]);
        let given = test(text, &Options { ramp_time: Some(0.0), ..Options::default() }).unwrap();
        assert_eq!(given.relaxation.history, History::step(0.0));
    }

    #[test]
    fn a_measured_strain_is_the_history() {
        let text = "time [s],strain [%],stress [kPa]\n0,0,0\n0.1,-25,-10\n0.2,-50,-20\n1,-50,-15\n2,-50,-12\n";
        let found = test(text, &Options::default()).unwrap();
        assert_eq!(found.relaxation.history.elastic(&[0.1, 1.0]), [0.5, 1.0]);
        assert_eq!(found.stretch, Some(0.5));
        assert!(found.relaxation.loads.iter().all(|load| *load >= 0.0));
    }

    #[test]
    fn a_clock_that_runs_back_is_refused() {
        let text = "time [s],force [N]\n0,10\n2,9\n1,8\n3,7\n4,6\n";
        let error = test(text, &Options::default()).unwrap_err().to_string();
        assert!(error.starts_with("line 4: time 1 s"), "{error}");
    }
}
