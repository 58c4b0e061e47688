//! From a table to stretches and nominal stresses.

use softanvil_records::ReadError;
use softanvil_records::column::{Column, Kind, Measure};
use softanvil_records::series::{Series, Table};
use softanvil_records::sheet::{self, Layout};

use super::point::{Point, Repeat};
use super::specimen::{Specimen, at_rest, displacement_at_rest};
use super::{shear, touch, volume};

/// Which way the specimen was loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Made longer: positive strain and stress.
    Tension,
    /// Made shorter, whatever signs the file uses.
    Compression,
}

/// What the file leaves open.
///
/// ```
/// use softanvil_identify::data::curve::{self, Direction, Options};
/// use softanvil_identify::data::specimen::Specimen;
///
/// // Travel and force of a test machine need the size of the specimen, and their signs a direction.
/// let specimen = Specimen { height: Some(10e-3), area: Some(1e-4) };
/// let options = Options { specimen, direction: Some(Direction::Compression), ..Options::default() };
/// let file = b"displacement [mm],force [N]\n1,2\n2,4\n3,6\n";
/// let curve = curve::read("press.csv", file, &options)?;
/// let third = curve.repeats[0].points[2];
/// assert!((third.stretch - 0.7).abs() < 1e-12 && (third.stress + 60e3).abs() < 1e-6);
/// # Ok::<(), softanvil_records::ReadError>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Titles instead of the file's.
    pub columns: Option<Vec<String>>,
    /// Layout of the file.
    pub layout: Layout,
    /// Size of the specimens.
    pub specimen: Specimen,
    /// Measure of strains whose title names none.
    pub strain_measure: Option<Measure>,
    /// Measure of stresses whose title names none.
    pub stress_measure: Option<Measure>,
    /// Which way the specimen was loaded.
    pub direction: Option<Direction>,
    /// Whether the test is one of simple shear: stretches are then 1 more than the amounts of shear.
    pub shear: bool,
}

/// What a file holds.
///
/// ```
/// use softanvil_identify::data::curve::{self, Options};
///
/// let file = b"strain [%];stress [kPa]\n10;20\n20;40\n30;60\n";
/// let curve = curve::read("tension.csv", file, &Options::default())?;
/// assert_eq!((curve.repeats.len(), curve.repeats[0].points.len()), (1, 3));
/// let first = curve.repeats[0].points[0];
/// assert!((first.line, first.stress) == (2, 20e3) && (first.stretch - 1.1).abs() < 1e-12);
/// assert!(curve.notes.iter().any(|note| note.contains("engineering strain")));
/// # Ok::<(), softanvil_records::ReadError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Curve {
    /// The specimens.
    pub repeats: Vec<Repeat>,
    /// (stretch of the loaded direction, volume over that at rest), as far as the file has lateral strains or the volume.
    pub volumes: Vec<(f64, f64)>,
    /// What else the file says, with its titles.
    pub words: String,
    /// How the file was understood where it left a choice.
    pub notes: Vec<String>,
    /// What speaks against its numbers: a way without load at the beginning, a load at rest.
    pub warnings: Vec<String>,
}

/// Reads the curve in `bytes` of the file called `name`.
///
/// # Errors
/// What cannot be understood, or in two ways.
pub fn read(name: &str, bytes: &[u8], options: &Options) -> Result<Curve, ReadError> {
    let table = Table::new(sheet::parse(bytes, &options.layout)?, options.columns.as_deref())?;
    let (mut notes, mut warnings) = (table.notes.clone(), Vec::new());
    let pairs = pairs(&table, options)?;
    let (mut repeats, mut pair_of) = (Vec::new(), Vec::new());
    for series in &table.series {
        for (index, pair) in pairs.iter().enumerate() {
            let (points, warning) = points(&table, series, pair, options, &mut notes)?;
            let name = if pairs.len() > 1 { format!("{} {}", series.name, index + 1) } else { series.name.clone() };
            let name = name.trim().to_string();
            let label = if name.is_empty() { String::new() } else { format!("specimen {name}: ") };
            warnings.extend(warning.map(|warning| format!("{label}{warning}")));
            if !points.is_empty() {
                repeats.push(Repeat { name, points });
                pair_of.push(pair);
            }
        }
    }
    for (index, pair) in pairs.iter().enumerate() {
        // Pairs of other measures than all before.
        if pairs[..index].iter().all(|other| other.measures() != pair.measures()) {
            notes.push(format!("{} over {}, {}", pair.load.title, pair.deformation.title, pair.measures()));
        }
    }
    if repeats.iter().all(|repeat| repeat.points.len() < 3) {
        return Err(ReadError::file("fewer than three points with strain and stress"));
    }
    let unloaded = |value: fn(&Point) -> f64| repeats.iter().flat_map(|repeat| &repeat.points).all(|p| value(p) == 0.0);
    for (what, value) in [("strain", (|p| p.stretch) as fn(&Point) -> f64), ("stress", |p| p.stress)] {
        if unloaded(value) {
            return Err(ReadError::file(format!("every {what} is zero: expected points of a specimen under load")));
        }
    }
    if let Some(pair) = pairs.first().filter(|_| options.shear) {
        shear::orient(&pair.deformation, &mut repeats, &mut notes);
        return Ok(Curve { repeats, volumes: Vec::new(), words: table.words, notes, warnings });
    }
    let stretched = pairs.iter().any(|pair| pair.deformation.kind == Kind::Stretch);
    let words = if stretched { None } else { Some(format!("{name}\n{}", table.words)) };
    orient(words.as_deref(), options.direction, &mut repeats, &mut notes)?;
    to_stretch(&pair_of, &mut repeats)?;
    let volumes = volume::read(&table, &repeats, &mut notes)?;
    Ok(Curve { repeats, volumes, words: table.words, notes, warnings })
}

/// The column of the deformation and that of the load, with their measures.
struct Pair {
    deformation: Column,
    load: Column,
    strain_measure: Measure,
    stress_measure: Measure,
}

impl Pair {
    fn measures(&self) -> String {
        let stress = self.stress_measure.names().1;
        match self.deformation.kind {
            Kind::Stretch => format!("read as {stress} stress"),
            _ => format!("read as {} strain and {stress} stress", self.strain_measure.names().0),
        }
    }
}

fn pairs(table: &Table, options: &Options) -> Result<Vec<Pair>, ReadError> {
    let strains = candidates(table, &[Kind::Stretch, Kind::Strain], Kind::Displacement, options.strain_measure);
    let stresses = candidates(table, &[Kind::Stress], Kind::Force, options.stress_measure);
    let titles = |columns: &[Column]| {
        columns.iter().map(|column| format!("\"{}\"", column.title)).collect::<Vec<_>>().join(", ")
    };
    let missing = |what: &str| {
        ReadError::file(format!(
            "no column of {what} among {}: name the columns with --columns",
            titles(&table.columns)
        ))
    };
    if strains.is_empty() {
        return Err(missing("strain, stretch or displacement"));
    }
    if stresses.is_empty() {
        return Err(missing("stress or force"));
    }
    if strains.len() != 1 && strains.len() != stresses.len() {
        let (strains, stresses) = (titles(&strains), titles(&stresses));
        let reason =
            format!("{strains} and {stresses} make no pairs: name two columns with --columns, \"-\" for the others");
        return Err(ReadError::file(reason));
    }
    let pair = |(index, load): (usize, &Column)| {
        let deformation = strains[if strains.len() == 1 { 0 } else { index }].clone();
        let measure = |own: Option<Measure>, given: Option<Measure>| own.or(given).unwrap_or(Measure::Engineering);
        Pair {
            strain_measure: match deformation.kind {
                Kind::Strain => measure(deformation.measure, options.strain_measure),
                _ => Measure::Engineering,
            },
            stress_measure: match load.kind {
                Kind::Stress => measure(load.measure, options.stress_measure),
                _ => Measure::Engineering,
            },
            deformation,
            load: load.clone(),
        }
    };
    Ok(stresses.iter().enumerate().map(pair).collect())
}

/// The columns of the best class there is: engineering (or what is asked for), no measure told, another, the machine's.
fn candidates(table: &Table, kinds: &[Kind], machine: Kind, wanted: Option<Measure>) -> Vec<Column> {
    let wanted = wanted.unwrap_or(Measure::Engineering);
    let of = |accept: &dyn Fn(&Column) -> bool| -> Vec<Column> {
        // A strain and a stretch say the same: the first kind that is there counts.
        let found = kinds.iter().map(|kind| table.of(*kind).filter(|c| accept(c)).cloned().collect::<Vec<_>>());
        found.into_iter().find(|columns| !columns.is_empty()).unwrap_or_default()
    };
    let classes = [
        of(&|column| column.measure == Some(wanted)),
        of(&|column| column.measure.is_none()),
        of(&|_| true),
        table.of(machine).cloned().collect(),
    ];
    classes.into_iter().find(|columns| !columns.is_empty()).unwrap_or_default()
}

/// Strain as the file has it (in `stretch`) and stress in Pa, from where the specimen bears load; and what speaks against them.
fn points(
    table: &Table,
    series: &Series,
    pair: &Pair,
    options: &Options,
    notes: &mut Vec<String>,
) -> Result<(Vec<Point>, Option<String>), ReadError> {
    let strain_factor = options.specimen.strain_per_unit(table, series, &pair.deformation, notes)?;
    let stress_factor = options.specimen.stress_per_unit(table, &pair.load)?;
    let cycle = table.of(Kind::Cycle).next();
    let start = displacement_at_rest(table, series, (&pair.deformation, &pair.load), notes)?;
    let mut points = Vec::new();
    for row in &series.rows {
        let values = (table.value(&pair.deformation, row)?, table.value(&pair.load, row)?);
        if let (Some(strain), Some(load)) = values {
            let cycle = cycle.map(|column| table.value(column, row)).transpose()?.flatten();
            let stretch = (strain - start) * strain_factor - at_rest(pair.deformation.kind);
            points.push(Point { line: row.line, cycle, stretch, stress: load * stress_factor });
        }
    }
    if pair.deformation.kind == Kind::Strain && strain_factor == 1.0 && !options.shear {
        refuse_stretches(&pair.deformation, &points)?;
    }
    let warning = begin_at_the_touch(&mut points, pair, (strain_factor, stress_factor));
    Ok((points, warning))
}

/// Takes a way without load off the beginning of `points`, where it can be taken off, and says so; or that there is a load at
/// rest. `factors` make strains and stresses of the columns' numbers.
fn begin_at_the_touch(points: &mut Vec<Point>, pair: &Pair, factors: (f64, f64)) -> Option<String> {
    let (deformation, load) = (&pair.deformation.title, &pair.load.title);
    let Some(touch) = touch::find(points) else {
        let rest = touch::offset(points)?;
        let largest = points.iter().map(|point| point.stress.abs()).fold(0.0, f64::max);
        return Some(format!(
            "\"{load}\" is {:.4} ({:.1} % of the largest) where the specimen is at rest: an offset of the load cell, or a preload \
             from which the deformation counts, goes into the law as it is; take it off the column",
            rest / factors.1,
            100.0 * rest.abs() / largest
        ));
    };
    let way = (touch.strain - points.first().map_or(0.0, |point| point.stretch)).abs() / factors.0;
    let found = format!(
        "\"{deformation}\" moves by {way:.4} ({:.1} % of its way) before \"{load}\" rises, as with a gap before the touch or slack",
        100.0 * touch.part
    );
    if pair.strain_measure != Measure::Engineering {
        let measure = pair.strain_measure.names().0;
        return Some(format!("{found}; it is not taken off a {measure} strain, and makes the modulus too small"));
    }
    touch::take_off(points, &touch);
    let level = touch.stress / factors.1;
    Some(format!("{found}: the curve begins there, and its load counts from {level:.4}"))
}

/// Strains that are 1 at no load, and nowhere near 0, are stretches.
fn refuse_stretches(column: &Column, points: &[Point]) -> Result<(), ReadError> {
    let largest = points.iter().map(|point| point.stress.abs()).fold(0.0, f64::max);
    let unloaded =
        points.iter().find(|point| point.stress.abs() <= UNLOADED * largest && (point.stretch - 1.0).abs() < UNLOADED);
    match unloaded {
        Some(point) if points.iter().all(|point| point.stretch.abs() > 0.1) => {
            let reason = format!(
                "\"{}\" is {} where there is no load, as a stretch is and no strain: name the columns with --columns, as in \
                 \"stretch, stress [kPa]\" (of a relaxation --relaxation-columns), or write \"strain [%]\" if it is a percentage",
                column.title, point.stretch
            );
            Err(ReadError::line(point.line, reason))
        }
        _ => Ok(()),
    }
}

/// Part of the largest load that is none, and how near to 1 a stretch at rest is.
const UNLOADED: f64 = 0.02;

/// Gives compression negative signs. Without `words` (a column of stretches) the signs of the strains are sure.
fn orient(
    words: Option<&str>,
    given: Option<Direction>,
    repeats: &mut [Repeat],
    notes: &mut Vec<String>,
) -> Result<(), ReadError> {
    let points = || repeats.iter().flat_map(|repeat| &repeat.points);
    let sign = |value: fn(&Point) -> f64| {
        let (low, high) = points().map(value).fold((0.0_f64, 0.0_f64), |(l, h), v| (l.min(v), h.max(v)));
        // A preload or noise around zero is no direction.
        match (high > 0.05 * (high - low), -low > 0.05 * (high - low)) {
            (true, true) => 0.0,
            (false, true) => -1.0,
            _ => 1.0,
        }
    };
    let (strain, stress) = (sign(|point| point.stretch), sign(|point| point.stress));
    let direction = match (given, strain < 0.0, words.and_then(hinted)) {
        (Some(Direction::Tension), true, _) => {
            return Err(ReadError::file(
                "the strains are negative, which is no tension: expected --direction compression",
            ));
        }
        (Some(Direction::Compression), false, _) if words.is_none() && strain > 0.0 => {
            return Err(ReadError::file(
                "the stretches are above 1, which is no compression: expected --direction tension",
            ));
        }
        (Some(direction), ..) => direction,
        (None, true, _) => Direction::Compression,
        (None, false, _) if strain == 0.0 || words.is_none() => Direction::Tension,
        (None, false, Some(direction)) => {
            if direction == Direction::Compression {
                notes
                    .push("positive strains read as compression, which the file's name, titles or remarks name".into());
            }
            direction
        }
        (None, false, None) if stress < 0.0 => {
            notes.push("positive strains read as compression, because the stresses are negative".into());
            Direction::Compression
        }
        (None, false, None) => {
            notes.push("positive strains read as tension; --direction compression says otherwise".into());
            Direction::Tension
        }
    };
    let work = || points().map(|point| point.stretch * point.stress).sum::<f64>();
    if strain == 0.0 && given.is_none() && work() < 0.0 {
        return Err(ReadError::file(
            "tension and compression with stresses against the strains: expected one sign for tension in both columns",
        ));
    }
    let negative = direction == Direction::Compression;
    let flip = |sign: f64| if negative && sign > 0.0 { -1.0 } else { 1.0 };
    let (strain_flip, mut stress_flip) = (flip(strain), flip(stress));
    if !negative && strain > 0.0 && stress < 0.0 {
        return Err(ReadError::file(
            "positive strains with negative stresses are no tension: expected --direction compression",
        ));
    }
    if negative && stress == 0.0 {
        // Loading and unloading with some tension at the end: the work of the loading tells the sign.
        stress_flip = if strain_flip * work() < 0.0 { -1.0 } else { 1.0 };
    }
    for point in repeats.iter_mut().flat_map(|repeat| &mut repeat.points) {
        point.stretch *= strain_flip;
        point.stress *= stress_flip;
    }
    Ok(())
}

/// The direction that words name; none if they name both or neither.
pub(crate) fn hinted(words: &str) -> Option<Direction> {
    let text = words.to_lowercase();
    let has = |parts: &[&str]| parts.iter().any(|part| text.contains(part));
    match (has(&["compress", "stauch", "druckversuch"]), has(&["tension", "tensile", "zugversuch", "pull"])) {
        (true, false) => Some(Direction::Compression),
        (false, true) => Some(Direction::Tension),
        _ => None,
    }
}

/// From strains and stresses of any measure to stretches and nominal stresses.
///
/// Every one of `repeats` has the measures of its own pair of columns.
fn to_stretch(pairs: &[&Pair], repeats: &mut [Repeat]) -> Result<(), ReadError> {
    for (repeat, pair) in repeats.iter_mut().zip(pairs) {
        for point in &mut repeat.points {
            point.stretch = pair.strain_measure.stretch(point.stretch, point.line)?;
            point.stress = pair.stress_measure.nominal(point.stress, point.stretch);
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(name: &str, text: &str, options: &Options) -> Result<Curve, ReadError> {
        read(name, text.as_bytes(), options)
    }

    fn pairs_of(text: &str) -> Vec<(f64, f64)> {
        let curve = curve("x.csv", text, &Options::default()).unwrap();
        curve.repeats.iter().flat_map(|r| &r.points).map(|p| (p.stretch, p.stress)).collect()
    }

    fn close(found: &[(f64, f64)], expected: &[(f64, f64)]) {
        assert_eq!(found.len(), expected.len(), "{found:?}");
        for (a, b) in found.iter().zip(expected) {
            assert!((a.0 - b.0).abs() < 1e-9 && (a.1 - b.1).abs() < 1e-6 * b.1.abs().max(1.0), "{found:?}");
        }
    }

    #[test]
    fn true_strains_tell_the_unit_of_engineering_ones() {
        for (factor, true_factor, word) in
            [(1.0, 1.0, "ratio"), (100.0, 100.0, "percentage"), (100.0, 1.0, "percentage")]
        {
            let unit = if true_factor == factor { "" } else { " [-]" };
            let rows: String = (1..=12)
                .map(f64::from)
                .map(|e| format!("{};{};{}\n", true_factor * e.ln_1p(), factor * e, 0.1 * e))
                .collect();
            let text = format!("True strain{unit};Engineering strain;Engineering stress [MPa]\n{rows}");
            let curve = curve("x.csv", &text, &Options::default()).unwrap();
            assert!(curve.notes.iter().any(|note| note.contains(word)), "{:?}", curve.notes);
            assert!((curve.repeats[0].points[11].stretch - 13.0).abs() < 1e-9, "{text}");
        }
    }

    #[test]
    fn the_same_curve_in_many_notations() {
        let expected = [(1.1, 2e4), (1.2, 4e4), (1.3, 6e4)];
        for text in [
            "strain,stress [MPa]\n0.1,0.02\n0.2,0.04\n0.3,0.06\n",
            "stretch;stress (kPa)\n1,1;20\n1,2;40\n1,3;60\n",
            "stress(MPa)\tstrain(%)\n0.02\t10\n0.04\t20\n0.06\t30\n",
            "Time (s);True Strain;True Stress (MPa);Engineering Strain;Engineering Stress (MPa)\n\
             1;.09;.1;0.1;0.02\n2;.1;.1;0.2;0.04\n3;.1;.1;0.3;0.06\n",
            "Green strain,2nd Piola-Kirchhoff stress [Pa]\n0.105,18181.8181818182\n0.22,33333.3333333333\n0.345,46153.8461538462\n",
            "true strain,true stress [Pa]\n0.0953101798043249,22000\n0.182321556793955,48000\n0.262364264467491,78000\n",
        ] {
            close(&pairs_of(text), &expected);
        }
    }

    #[test]
    fn compression_has_negative_signs_whatever_the_file_has() {
        let expected = [(0.9, -2e4), (0.8, -4e4), (0.7, -6e4)];
        for text in [
            "strain,stress [kPa]\n-0.1,-20\n-0.2,-40\n-0.3,-60\n",
            "strain,stress [kPa]\n-0.1,20\n-0.2,40\n-0.3,60\n",
            "strain,stress [kPa]\n0.1,-20\n0.2,-40\n0.3,-60\n",
            "compressive strain,stress [kPa]\n0.1,20\n0.2,40\n0.3,60\n",
            "# compression of a cylinder\nstrain,stress [kPa]\n0.1,20\n0.2,40\n0.3,60\n",
            "stretch,stress [kPa]\n0.9,-20\n0.8,-40\n0.7,-60\n",
            "stretch,stress [kPa]\n0.9,20\n0.8,40\n0.7,60\n",
        ] {
            close(&pairs_of(text), &expected);
        }
    }

    #[test]
    fn force_and_displacement_need_the_specimen() {
        let text = "Weg [mm];Kraft [N]\n-1;-2\n-2;-4\n-3;-6\n";
        let error = curve("x", text, &Options::default()).unwrap_err().to_string();
        assert!(error.contains("--height"), "{error}");
        let specimen = Specimen { height: Some(0.01), area: Some(1e-4) };
        let options = Options { specimen, ..Options::default() };
        let curve = curve("x", text, &options).unwrap();
        let points: Vec<_> = curve.repeats[0].points.iter().map(|p| (p.stretch, p.stress)).collect();
        close(&points, &[(0.9, -2e4), (0.8, -4e4), (0.7, -6e4)]);
    }

    /// The same test as Green strain with second Piola-Kirchhoff stress, and as true ones.
    #[test]
    fn every_pair_of_columns_has_its_own_measures() {
        let (e, row) = ([0.1, 0.2, 0.3], |e: &f64| {
            let l = 1.0 + e;
            let stress = 2e5 * e;
            format!("{},{},{},{}\n", 0.5 * (l * l - 1.0), stress / l, l.ln(), stress * l)
        });
        let text: String = e.iter().map(row).collect();
        let titles = "green strain,2nd Piola-Kirchhoff stress [Pa],true strain,true stress [Pa]\n";
        let expected = [(1.1, 2e4), (1.2, 4e4), (1.3, 6e4)];
        close(&pairs_of(&format!("{titles}{text}")), &[expected, expected].concat());
    }

    #[test]
    fn a_way_counts_from_where_the_record_begins() {
        let text = "displacement [mm];force [N]\n-21.2;0.01\n-11.2;2\n-1.2;4\n";
        let specimen = Specimen { height: Some(0.1), area: Some(1e-4) };
        let options = Options { specimen, ..Options::default() };
        let curve = curve("x", text, &options).unwrap();
        let points: Vec<_> = curve.repeats[0].points.iter().map(|p| (p.stretch, p.stress)).collect();
        close(&points, &[(1.0, 100.0), (1.1, 2e4), (1.2, 4e4)]);
        assert!(curve.notes.iter().any(|note| note.contains("counts from -21.2")), "{:?}", curve.notes);
    }

    #[test]
    fn a_fit_beside_the_data_is_no_specimen() {
        let text = "lambda,sigma_c_data_MPa,sigma_c_fit_MPa\n1.1,0.11,9\n1.2,0.24,9\n1.5,0.6,9\n";
        close(&pairs_of(text), &[(1.1, 1e5), (1.2, 2e5), (1.5, 4e5)]);
        let notes = curve("x", text, &Options::default()).unwrap().notes.join("\n");
        assert!(
            notes.contains("\"sigma_c_fit_MPa\" is passed over") && notes.contains("read as true stress"),
            "{notes}"
        );
    }

    #[test]
    fn columns_without_values_hide_no_others() {
        let expected = [(1.1, 1e4), (1.2, 2e4), (1.3, 3e4)];
        close(&pairs_of("strain,engineering stress [kPa],stress [kPa]\n0.1,,10\n0.2,,20\n0.3,,30\n"), &expected);
        close(&pairs_of("strain,true strain,stress [kPa]\n0.1,N/A,10\n0.2,N/A,20\n0.3,N/A,30\n"), &expected);
        close(&pairs_of("应变,应力\n-,kPa\n0.1,10\n0.2,20\n0.3,30\n"), &expected);
        close(&pairs_of("Деформация [%];Напряжение [кПа];Stress [kPa]\n10;1;10\n20;2;20\n30;3;30\n"), &expected);
    }

    #[test]
    fn what_has_two_meanings_is_refused_with_the_option_that_settles_it() {
        for (text, part) in [
            ("0.1 0.2\n0.2 0.3\n0.3 0.4\n", "--columns"),
            ("strain,stress\n0.1,0.2\n0.2,0.3\n0.3,0.4\n", "has no unit"),
            ("strain,stress [kPa]\n10,1\n25,2\n50,3\n", "line 3: strain = 25 has no unit"),
            ("strain,stress [kPa]\n0.1,1\n0.2,x2\n0.3,3\n", "line 3: stress [kPa] = \"x2\""),
            ("strain [%],stress [kPa]\n-50,1\n-99,2\n-120,3\n", "line 4: strain -1.2"),
            ("strain,force [N]\n0.1,1\n0.2,2\n0.3,3\n", "--area"),
            ("a,b\n1,2\n3,4\n", "no two columns understood"),
            ("strain,stress [Pa]\n0.1,0\n0.2,0\n0.3,0\n", "every stress is zero"),
            ("strain,stress [Pa]\n0,1\n0,2\n0,3\n", "every strain is zero"),
            ("strain,stress [Pa]\n-0.2,1\n0,0\n0.2,-1\n", "against the strains"),
            ("elongation,stress [Pa]\n1,2\n3,4\n5,6\n", "% or mm"),
            ("mean_strain,stress [kPa]\n1,-0\n0.9,10\n0.8,20\n", "line 2: \"mean_strain\" is 1 where there is no load"),
            ("strain,strain,stress [Pa],stress [Pa],stress [Pa]\n1,1,1,1,1\n2,2,2,2,2\n3,3,3,3,3\n", "make no pairs"),
        ] {
            let error = curve("x", text, &Options::default()).unwrap_err().to_string();
            assert!(error.contains(part), "{text}: {error}");
        }
    }

    #[test]
    fn specimens_are_told_apart() {
        let names = |text: &str| -> Vec<(String, usize)> {
            let curve = curve("x", text, &Options::default()).unwrap();
            curve.repeats.into_iter().map(|repeat| (repeat.name, repeat.points.len())).collect()
        };
        let rows = "0.1,1\n0.2,2\n0.3,3\n";
        let stacked = format!("strain,stress [Pa]\n{rows}strain,stress [Pa]\n{rows}");
        assert_eq!(names(&stacked), [("1".into(), 3), ("2".into(), 3)]);
        let wide = "strain1,stress1 [Pa],strain2,stress2 [Pa]\n0.1,1,0.1,2\n0.2,2,0.2,3\n0.3,3,,\n";
        assert_eq!(names(wide), [("1".into(), 3), ("2".into(), 2)]);
        let named = "specimen,strain,stress [Pa]\nA,0.1,1\nA,0.2,2\nA,0.3,2\nB,0.1,1\n";
        assert_eq!(names(named), [("A".into(), 3), ("B".into(), 1)]);
    }
}
