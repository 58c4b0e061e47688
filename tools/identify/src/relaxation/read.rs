//! Time and load of a relaxation test from a file.

use softanvil_records::ReadError;
use softanvil_records::column::{self, Column, Kind, Measure};
use softanvil_records::robust::median;
use softanvil_records::series::{DYNAMIC, Series, Table};
use softanvil_records::sheet::{self, Layout};

use super::history::History;
use super::prony::Relaxation;
use super::ramp;
use crate::data::curve::{Direction, hinted};
use crate::data::specimen::{Specimen, at_rest, displacement_at_rest};

/// What the file leaves open.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Titles instead of the file's.
    pub columns: Option<Vec<String>>,
    /// Layout of the file.
    pub layout: Layout,
    /// Size of the specimen.
    pub specimen: Specimen,
    /// Measure of strains whose title names none.
    pub strain_measure: Option<Measure>,
    /// Measure of stresses whose title names none.
    pub stress_measure: Option<Measure>,
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
    /// A load over another, without a unit.
    Normalised,
}

/// A relaxation test.
///
/// ```
/// use softanvil_identify::relaxation::read::{self, Load, Options};
///
/// let file = b"time [s],stress [kPa]\n0,100\n1,80\n10,60\n100,55\n1000,55\n";
/// let options = Options { start: Some(0.0), ramp_time: Some(0.0), ..Options::default() };
/// let test = read::read(file, &options, None)?;
/// assert_eq!(test.load, Load::Stress);
/// assert_eq!((test.relaxation.times.last(), test.relaxation.loads.last()), (Some(&1000.0), Some(&55e3)));
/// # Ok::<(), softanvil_records::ReadError>(())
/// ```
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

/// Above this number, points are averaged in bins that are even over the logarithm of time, which costs nothing: a series
/// hardly changes within a bin, and a mean counts as its number of points.
const MAX_POINTS: usize = 1000;
/// Bins in a decade.
const PER_DECADE: f64 = 100.0;

/// Reads the relaxation in `bytes`. `elastic` gives the elastic stress at a stretch, up to a factor; without it the stress
/// is taken as proportional to the strain during loading.
///
/// # Errors
/// What cannot be understood, or in two ways.
pub fn read(bytes: &[u8], options: &Options, elastic: Option<&dyn Fn(f64) -> f64>) -> Result<Test, ReadError> {
    let table = Table::new(sheet::parse(bytes, &options.layout)?, options.columns.as_deref())?;
    let [series] = table.series.as_slice() else {
        return Err(ReadError::file(format!(
            "{} specimens in one file: expected one relaxation test",
            table.series.len()
        )));
    };
    let mut notes = Vec::new();
    let mut rows = rows(&table, series, options, &mut notes)?;
    if let Some(load) = touch(&rows) {
        let share = 100.0 * (load / rows[peak(&rows)].load).abs();
        notes.push(format!("a load of {share:.1} % of the largest that stood there before the rise is taken off"));
        rows.iter_mut().for_each(|row| row.load -= load);
    }
    let start = options.start.unwrap_or_else(|| beginning(&rows, &mut notes));
    rows.iter_mut().for_each(|row| row.time -= start);
    if rows.iter().all(|row| row.load == 0.0) {
        return Err(ReadError::file("every load is zero: expected points of a specimen under load"));
    }
    let sign = if rows.iter().map(|row| row.load).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
    rows.iter_mut().for_each(|row| row.load *= sign);
    let compressed = sign < 0.0 || hinted(&table.words) == Some(Direction::Compression);
    let Loading { history, loaded, stretch } = history(&mut rows, options, elastic, compressed, &mut notes)?;
    let load = rows.first().map_or(Load::Stress, |row| row.kind);
    let means = thinned(&rows, loaded, &mut notes);
    let relaxation = Relaxation {
        times: means.iter().map(|mean| mean.time).collect(),
        loads: means.iter().map(|mean| mean.value).collect(),
        counts: means.iter().map(|mean| mean.count).collect(),
        loaded,
        history,
    };
    notes.extend(table.notes);
    Ok(Test { relaxation, load, stretch, notes })
}

/// A row of the file in SI units.
struct Row {
    line: usize,
    time: f64,
    load: f64,
    kind: Load,
    /// Measure of the load.
    stress: Measure,
    /// Strain as the file has it, and its measure.
    strain: Option<(f64, Measure)>,
}

fn one(table: &Table, kind: Kind) -> Result<Option<&Column>, ReadError> {
    let found: Vec<&Column> = table.of(kind).collect();
    // Of the same quantity in two measures the engineering one counts.
    let engineering =
        found.iter().copied().filter(|column| column.measure.is_none_or(|measure| measure == Measure::Engineering));
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
    let time = one(table, Kind::Time)?.ok_or_else(|| {
        ReadError::file(match column::are_dynamic(table.words.lines()) {
            true => DYNAMIC,
            false => "no column of time: name it with --relaxation-columns, such as \"time [s]\"",
        })
    })?;
    if time.si.is_none() {
        notes.push(format!("{} has no unit, read in seconds", time.title));
    }
    let normalised = one(table, Kind::Normalised)?;
    let (load, kind) = match (one(table, Kind::Modulus)?, one(table, Kind::Stress)?, one(table, Kind::Force)?) {
        (Some(modulus), ..) => (modulus, Load::Modulus),
        (None, Some(stress), _) => (stress, Load::Stress),
        (None, None, Some(force)) if options.specimen.area.is_none() => (force, Load::Force),
        (None, None, Some(force)) => (force, Load::Stress),
        _ if normalised.is_some() => (normalised.unwrap_or(time), Load::Normalised),
        _ => return Err(ReadError::file("no column of modulus, stress or force: name it with --relaxation-columns")),
    };
    // Only the shape over time matters for a series; without a unit its size is unknown.
    let unit = match kind {
        Load::Force | Load::Normalised => load.si.unwrap_or(1.0),
        _ => options.specimen.stress_per_unit(table, load)?,
    };
    let measure = |own: Option<Measure>, given: Option<Measure>| own.or(given).unwrap_or(Measure::Engineering);
    let stress =
        if load.kind == Kind::Stress { measure(load.measure, options.stress_measure) } else { Measure::Engineering };
    // A displacement without the specimen's length is passed over: the load's shape over time is enough.
    let moved = one(table, Kind::Displacement)?.filter(|_| options.specimen.height.is_some());
    let deformation = one(table, Kind::Strain)?.or(one(table, Kind::Stretch)?).or(moved);
    let strained = match deformation {
        Some(column) => Some((column, options.specimen.strain_per_unit(table, series, column, notes)?)),
        None => None,
    };
    let origin = match deformation {
        Some(column) => displacement_at_rest(table, series, (column, load), notes)?,
        None => 0.0,
    };
    if let (None, Some(column)) = (deformation, one(table, Kind::Displacement)?) {
        notes.push(format!(
            "{} is passed over: with --height, the specimen's length, it gives the strain",
            column.title
        ));
    }
    let mut rows = Vec::new();
    for row in &series.rows {
        let (Some(seconds), Some(value)) = (table.value(time, row)?, table.value(load, row)?) else { continue };
        let strain = match strained {
            Some((column, factor)) => table.value(column, row)?.map(|strain| {
                let own = if column.kind == Kind::Strain { column.measure } else { Some(Measure::Engineering) };
                ((strain - origin) * factor - at_rest(column.kind), measure(own, options.strain_measure))
            }),
            None => None,
        };
        let time = seconds * time.si.unwrap_or(1.0);
        rows.push(Row { line: row.line, time, load: value * unit, kind, stress, strain });
    }
    if let Some(pair) = rows.windows(2).find(|pair| pair[1].time < pair[0].time) {
        let reason = format!("time {} s is before that of the line above: expected time that rises", pair[1].time);
        return Err(ReadError::line(pair[1].line, reason));
    }
    rows.dedup_by(|a, b| a.time == b.time);
    if rows.len() < 5 {
        return Err(ReadError::file("fewer than five points with time and load"));
    }
    Ok(rows)
}

/// Points of a load that relaxes, from its peak on, at least.
const AFTER_PEAK: usize = 4;
/// Part of the peak below which a specimen is not loaded yet.
const UNLOADED: f64 = 0.05;

/// Index of the largest load, whatever its sign; the first of several.
fn peak(rows: &[Row]) -> usize {
    let larger = |best: usize, index: usize| if rows[index].load.abs() > rows[best].load.abs() { index } else { best };
    (0..rows.len()).fold(0, larger)
}

/// Rows before the rise that tell a load which stood there, at least.
const STANDING: usize = 3;
/// Parts of the peak between which such a load is one: less is nothing, and more may be a load that was there at once.
const TOUCH: (f64, f64) = (5e-3, 0.5);

/// The load that stood at the specimen before it was loaded, by which a machine holds it or which its load cell shows; none of a
/// record that does not begin with one.
fn touch(rows: &[Row]) -> Option<f64> {
    let top = peak(rows);
    let (first, largest) = (rows.first()?.load, rows[top].load);
    let alike = |row: &Row| (row.load - first).abs() < UNLOADED * (largest - first).abs();
    let last = rows[..top].iter().rposition(alike)?;
    let standing = &rows[..=risen_from(rows, last)];
    let load = median(standing.iter().map(|row| row.load).collect());
    let part = (load / largest).abs();
    let stands = standing.len() >= STANDING && standing.iter().all(alike);
    (stands && (TOUCH.0..TOUCH.1).contains(&part)).then_some(load)
}

/// When loading began on the file's clock: at 0, or where a load that was nothing begins to rise; says so if it is later.
fn beginning(rows: &[Row], notes: &mut Vec<String>) -> f64 {
    let peak = peak(rows);
    let unloaded = |row: &Row| row.load.abs() < UNLOADED * rows[peak].load.abs();
    match rows[..peak].iter().rposition(unloaded) {
        Some(last) if unloaded(&rows[0]) && rows[risen_from(rows, last)].time != 0.0 => {
            let time = rows[risen_from(rows, last)].time;
            notes.push(format!("loading begins at {time} s, where the load rises; --relaxation-start says otherwise"));
            time
        }
        _ => 0.0,
    }
}

/// From where the load rises without a break to the row `last`.
fn risen_from(rows: &[Row], last: usize) -> usize {
    let falls = |index: &usize| rows[*index].load.abs() >= rows[index + 1].load.abs();
    (0..last).rev().find(falls).map_or(0, |index| index + 1)
}

/// What the load relaxes from.
struct Loading {
    history: History,
    /// When the strain was reached, s.
    loaded: f64,
    /// The held stretch, if it is known.
    stretch: Option<f64>,
}

fn history(
    rows: &mut [Row],
    options: &Options,
    elastic: Option<&dyn Fn(f64) -> f64>,
    compressed: bool,
    notes: &mut Vec<String>,
) -> Result<Loading, ReadError> {
    if options.ramp_time.is_none() && rows.iter().all(|row| row.strain.is_some()) {
        return measured(rows, options, elastic, compressed, notes);
    }
    let stretch = options.strain.map(|strain| 1.0 + strain);
    if let Some(stretch) = stretch {
        rows.iter_mut().for_each(|row| row.load = row.stress.nominal(row.load, stretch));
    }
    let peak = peak(rows);
    if options.ramp_time.is_none() && peak + AFTER_PEAK > rows.len() {
        let reason = format!(
            "the load is largest here, at {} s, with fewer than {AFTER_PEAK} points from it on: expected a load that relaxes, or \
             --ramp-time",
            rows[peak].time
        );
        return Err(ReadError::line(rows[peak].line, reason));
    }
    let ramp = options.ramp_time.unwrap_or_else(|| {
        let points: Vec<(f64, f64)> = rows.iter().map(|row| (row.time, row.load.abs())).collect();
        let Some(end) = ramp::end(&points) else {
            notes.push("no rise of the load beyond its scatter: an ideal step; --ramp-time says otherwise".into());
            return 0.0;
        };
        notes.push(format!("ramp time {end:.6} s, from the rise of the load to its peak; --ramp-time says otherwise"));
        end
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
    Ok(Loading { history, loaded: ramp, stretch })
}

/// Part of the held strain that counts as reached.
const REACHED: f64 = 0.99;

/// The history from a column of strain; makes the loads nominal with it.
fn measured(
    rows: &mut [Row],
    options: &Options,
    elastic: Option<&dyn Fn(f64) -> f64>,
    compressed: bool,
    notes: &mut Vec<String>,
) -> Result<Loading, ReadError> {
    let strains = || rows.iter().filter_map(|row| row.strain);
    let largest = strains().fold(0.0, |a: f64, (b, _)| if b.abs() > a.abs() { b } else { a });
    if largest == 0.0 {
        return Err(ReadError::file("every strain is zero: expected a column of the strain that was held"));
    }
    // A positive strain may be one of compression; the option tells, or the load's sign, or words.
    let sign = match options.strain {
        Some(strain) => (strain * largest).signum(),
        None if compressed && largest > 0.0 => -1.0,
        None => 1.0,
    };
    let mut stretches = Vec::with_capacity(rows.len());
    for row in rows.iter_mut() {
        let stretch = row.strain.map_or(Ok(1.0), |(strain, measure)| measure.stretch(sign * strain, row.line))?;
        row.load = row.stress.nominal(row.load, stretch);
        stretches.push(stretch);
    }
    let held = stretches.iter().fold(1.0, |a: f64, b| if (b - 1.0).abs() > (a - 1.0).abs() { *b } else { a });
    notes.push(format!("loading as measured, held at the engineering strain {:.4}", held - 1.0));
    let response = |stretch: f64| match elastic {
        Some(law) => law(stretch) / law(held),
        None => (stretch - 1.0) / (held - 1.0),
    };
    let knots: Vec<(f64, f64)> = rows.iter().zip(&stretches).map(|(row, l)| (row.time, response(*l))).collect();
    let reached = |l: &f64| (l - 1.0).abs() >= REACHED * (held - 1.0).abs();
    let loaded = rows.iter().zip(&stretches).find(|(_, l)| reached(l)).map_or(0.0, |(row, _)| row.time.max(0.0));
    let knots = means(&knots, loaded).iter().map(|mean| (mean.time, mean.value)).collect();
    Ok(Loading { history: History::measured(knots), loaded, stretch: Some(held) })
}

/// The points since loading began, or their means.
fn thinned(rows: &[Row], loaded: f64, notes: &mut Vec<String>) -> Vec<Mean> {
    let points: Vec<(f64, f64)> = rows.iter().filter(|row| row.time >= 0.0).map(|row| (row.time, row.load)).collect();
    let means = means(&points, loaded);
    if means.len() < points.len() {
        let (all, left) = (points.len(), means.len());
        notes.push(format!(
            "{all} points averaged to {left}, {PER_DECADE} a decade, that count as their numbers of points"
        ));
    }
    means
}

/// Points in one.
struct Mean {
    time: f64,
    value: f64,
    count: usize,
}

/// The `points` (time, value), or their means in bins of the logarithm of time if there are more than [`MAX_POINTS`]; none
/// has points before and after `loaded`, s.
fn means(points: &[(f64, f64)], loaded: f64) -> Vec<Mean> {
    let few = points.len() <= MAX_POINTS;
    let bin = |time: f64| if time > 0.0 { (time.log10() * PER_DECADE).floor() as i64 } else { i64::MIN };
    let mean = |points: &[(f64, f64)]| {
        let count = points.len();
        let sum = points.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0, sum.1 + point.1));
        Mean { time: sum.0 / count as f64, value: sum.1 / count as f64, count }
    };
    let together = |a: &(f64, f64), b: &(f64, f64)| !few && bin(a.0) == bin(b.0) && (a.0 < loaded) == (b.0 < loaded);
    points.chunk_by(together).map(mean).collect()
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
        let text = "time [s],force [N]\n0,0\n0.1,10\n0.2,20\n1,15\n2,12\n3,11\n";
        let found = test(text, &Options::default()).unwrap();
        assert_eq!(found.relaxation.history.elastic(&[0.1, 0.2, 5.0]), [0.5, 1.0, 1.0]);
        let given = test(text, &Options { ramp_time: Some(0.0), ..Options::default() }).unwrap();
        assert_eq!(given.relaxation.history, History::step(0.0));
    }

    #[test]
    fn a_clock_that_runs_before_loading_is_set_to_it() {
        let text = "time [s],force [N]\n10,0\n10.1,0\n10.2,20\n11,15\n12,12\n13,11\n";
        let found = test(text, &Options::default()).unwrap();
        assert!((found.relaxation.history.elastic(&[0.1])[0] - 1.0).abs() < 1e-9, "{:?}", found.relaxation);
        assert!(found.notes[0].contains("begins at 10.1 s"), "{:?}", found.notes);
    }

    /// 20 N hold the specimen for 5 s, then a step by 280 N relaxes to a third of that.
    #[test]
    fn a_load_that_stood_there_before_the_step_is_no_ramp() {
        let load = |t: f64| if t < 5.0 { 20.0 } else { 20.0 + 280.0 * (1.0 + 2.0 * (-(t - 5.0) / 2.0).exp()) / 3.0 };
        for (sign, noise) in [(1.0, 0.0), (-1.0, 0.3)] {
            let at = |k: i32| (0.1 * f64::from(k), noise * (f64::from(k) * 12.9898).sin());
            let row = |(t, error): (f64, f64)| format!("{t:.1},{}\n", sign * (load(t + 1e-9) + error));
            let text: String = (0..=600).map(at).map(row).collect();
            let found = test(&format!("time [s],force [N]\n{text}"), &Options::default()).unwrap();
            assert!(found.notes[0].starts_with("a load of 6.7 % of the largest that stood there"), "{:?}", found.notes);
            let choice = crate::relaxation::choice::Choice::new(&found.relaxation, Some(1)).unwrap();
            let (g, tau) = choice.prony().normalised()[0];
            assert!((g - 2.0 / 3.0).abs() < 0.02 && (tau / 2.0 - 1.0).abs() < 0.05, "{g} {tau}");
        }
    }

    #[test]
    fn a_slow_rise_begins_where_it_leaves_nothing() {
        let rise: String = (0..=50).map(|k| format!("{},{}\n", 0.01 * f64::from(k), 0.4 * f64::from(k))).collect();
        let found = test(&format!("time [s],force [N]\n{rise}1,15\n2,12\n3,11\n"), &Options::default()).unwrap();
        assert_eq!(found.relaxation.history, History::ramp(0.0, 0.5, |part| part), "{:?}", found.notes);
    }

    #[test]
    fn noise_on_a_load_that_was_there_at_once_is_no_ramp() {
        let text = "time [s],force [N]\n0,19.9\n0.01,20\n1,15\n2,12\n3,11\n";
        assert_eq!(test(text, &Options::default()).unwrap().relaxation.history, History::step(0.0));
    }

    #[test]
    fn oscillations_are_refused_by_name() {
        for text in [
            "f, E_stor, E_loss\nHz, MPa, MPa\n1,2,3\n2,3,4\n",
            "Frequency [Hz];Storage modulus [MPa];Loss modulus [MPa]\n1;2;3\n2;3;4\n",
        ] {
            let error = test(text, &Options::default()).unwrap_err().to_string();
            assert!(error.contains("oscillations"), "{error}");
        }
        let text = "t,E_relax\ns, MPa\n0.1,2\n0.2,1.8\n0.3,1.7\n1,1.5\n2,1.4\n";
        assert_eq!(test(text, &Options::default()).unwrap().load, Load::Modulus);
    }

    #[test]
    fn a_load_that_rises_to_the_end_is_refused() {
        let error = test("time [s],force [N]\n0,1\n1,2\n2,3\n3,4\n4,5\n", &Options::default()).unwrap_err();
        assert!(error.to_string().starts_with("line 6: the load is largest here"), "{error}");
    }

    #[test]
    fn a_measured_strain_is_the_history() {
        let text = "time [s],strain [%],stress [kPa]\n0,0,0\n0.1,-25,-10\n0.2,-50,-20\n1,-50,-15\n2,-50,-12\n";
        let found = test(text, &Options::default()).unwrap();
        assert_eq!(found.relaxation.history.elastic(&[0.1, 1.0]), [0.5, 1.0]);
        assert_eq!(found.stretch, Some(0.5));
        let unsigned = test(&text.replace('-', ""), &Options::default()).unwrap();
        assert_eq!(unsigned.stretch, Some(1.5));
        let compressed = test(&text.replace('-', "").replace("strain", "compression"), &Options::default()).unwrap();
        assert_eq!(compressed.stretch, Some(0.5));
        assert_eq!(compressed.relaxation.loads, found.relaxation.loads);
        assert!(found.relaxation.loads.iter().all(|load| *load >= 0.0));
    }

    #[test]
    fn a_clock_that_runs_back_is_refused() {
        let text = "time [s],force [N]\n0,10\n2,9\n1,8\n3,7\n4,6\n";
        let error = test(text, &Options::default()).unwrap_err().to_string();
        assert!(error.starts_with("line 4: time 1 s"), "{error}");
    }
}
