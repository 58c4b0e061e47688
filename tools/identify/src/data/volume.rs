//! The volume of a specimen from its lateral strains, or as a file has it.

use std::collections::HashMap;

use softanvil_records::ReadError;
use softanvil_records::column::{Column, Kind, Measure};
use softanvil_records::series::{Series, Table};

use super::point::Repeat;

/// Title words of ratios, which are 1 at rest, unlike strains and changes.
const RATIOS: [&str; 5] = ["stretch", "streckung", "lambda", "λ", "ratio"];

/// (stretch of the loaded direction, volume over that at rest) of the states in `repeats`, by the first column of lateral
/// strain, or else of volume; nothing if there is none. Two free directions are taken as alike.
///
/// # Errors
/// A cell that is no number, or one that no specimen has.
pub fn read(table: &Table, repeats: &[Repeat], notes: &mut Vec<String>) -> Result<Vec<(f64, f64)>, ReadError> {
    let Some(column) = table.of(Kind::Lateral).next().or_else(|| table.of(Kind::Volume).next()) else {
        return Ok(Vec::new());
    };
    let mut stretches = HashMap::new();
    for point in repeats.iter().flat_map(|repeat| &repeat.points) {
        // Of several pairs of columns the first tells the stretch of a line.
        stretches.entry(point.line).or_insert(point.stretch);
    }
    let mut states = Vec::new();
    for row in table.series.iter().flat_map(|series: &Series| &series.rows) {
        let (Some(stretch), Some(value)) = (stretches.get(&row.line).copied(), table.value(column, row)?) else {
            continue;
        };
        let volume = volume(column, stretch, value * column.si.unwrap_or(1.0));
        if !(volume > 0.01 && volume < 100.0) {
            let legal = "expected what makes the volume 0.01 to 100 times that at rest; is the unit in the title?";
            return Err(ReadError::line(row.line, format!("{} = {value} is refused: {legal}", column.title)));
        }
        states.push((stretch, volume));
    }
    notes.push(format!("volume of the specimen from {}", column.title));
    Ok(states)
}

/// The volume over that at rest, of a specimen at `stretch` where `column` has `value`.
fn volume(column: &Column, stretch: f64, value: f64) -> f64 {
    let title = column.title.to_lowercase();
    let is_ratio = RATIOS.iter().any(|word| title.contains(word));
    if column.kind == Kind::Volume {
        return if is_ratio { value } else { 1.0 + value };
    }
    // A free direction grows where the loaded one shrinks, whatever signs the file has.
    let away = if stretch < 1.0 { 1.0 } else { -1.0 };
    let lateral = match column.measure {
        _ if is_ratio => value,
        Some(Measure::True) => (away * value.abs()).exp(),
        Some(Measure::Lagrange) => (1.0 + 2.0 * away * value.abs()).max(0.0).sqrt(),
        _ => 1.0 + away * value.abs(),
    };
    stretch * lateral * lateral
}

#[cfg(test)]
mod tests {
    use crate::data::curve::{Options, read};

    #[test]
    fn lateral_strains_and_volumes_say_the_same() {
        for text in [
            "strain [%],lateral strain [%],stress [kPa]\n-10,2,-10\n-20,4,-20\n-30,6,-30\n",
            "compressive strain [%],transverse strain [-],stress [kPa]\n10,-0.02,10\n20,-0.04,20\n30,-0.06,30\n",
            "stretch;lateral stretch;stress [kPa]\n0.9;1.02;10\n0.8;1.04;20\n0.7;1.06;30\n",
            "stretch;volume ratio;stress [kPa]\n0.9;0.93636;10\n0.8;0.86528;20\n0.7;0.78652;30\n",
            "stretch;volume change [%];stress [kPa]\n0.9;-6.364;10\n0.8;-13.472;20\n0.7;-21.348;30\n",
        ] {
            let curve = read("foam.csv", text.as_bytes(), &Options::default()).unwrap();
            let expected = [(0.9, 0.93636), (0.8, 0.86528), (0.7, 0.78652)];
            assert_eq!(curve.volumes.len(), 3, "{text}");
            for (found, expected) in curve.volumes.iter().zip(expected) {
                let error = (found.0 - expected.0).abs() + (found.1 - expected.1).abs();
                assert!(error < 1e-9, "{text}: {:?}", curve.volumes);
            }
        }
    }

    /// A line finds its stretch at once: with a search through all of them these took half a minute.
    #[test]
    fn every_line_has_its_volume() {
        let row = |k: i32| format!("{},0.02,{}\n", -1e-6 * f64::from(k), -f64::from(k));
        let text: String = (1..=100_000).map(row).collect();
        let text = format!("strain [-],lateral strain [-],stress [Pa]\n{text}");
        let curve = read("x.csv", text.as_bytes(), &Options::default()).unwrap();
        assert_eq!(curve.volumes.len(), 100_000);
    }

    #[test]
    fn a_volume_that_no_specimen_has_is_refused_with_its_line() {
        let text = "stretch,volume change,stress [kPa]\n0.9,-6.4,10\n0.8,-13.5,20\n0.7,-21,30\n";
        let error = read("x.csv", text.as_bytes(), &Options::default()).unwrap_err().to_string();
        assert!(error.starts_with("line 2: volume change = -6.4 is refused"), "{error}");
    }
}
