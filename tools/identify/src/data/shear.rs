//! What is particular to a simple shear test: its strains are amounts of shear, of either sign.

use softanvil_records::column::{Column, Kind};

use super::point::{Point, Repeat};

/// How near to 1 the value of an unloaded specimen is in a column that counts from 1.
const FROM_ONE: f64 = 0.02;

/// Gives every stress of `repeats` the sign of its amount of shear (1 less than their stretch), and stretches the 1 that they
/// count from.
///
/// A column of stretches may hold amounts of shear as they are, or more by 1; the smallest load tells.
pub fn orient(column: &Column, repeats: &mut [Repeat], notes: &mut Vec<String>) {
    let points = || repeats.iter().flat_map(|repeat| &repeat.points);
    // The reader has taken the 1 off a stretch.
    let rest = points().min_by(|a, b| a.stress.abs().total_cmp(&b.stress.abs())).map_or(0.0, |point| point.stretch);
    let shift = if column.kind == Kind::Stretch && (rest + 1.0).abs() < FROM_ONE { 1.0 } else { 0.0 };
    if column.kind == Kind::Stretch {
        let from = if shift == 0.0 { " from 1" } else { "" };
        notes.push(format!("{} read as amounts of shear{from}", column.title));
    }
    let work: f64 = points().map(|point| (point.stretch + shift) * point.stress).sum();
    if work < 0.0 {
        notes.push("stresses against the strains are read as with them".into());
    }
    let sign = if work < 0.0 { -1.0 } else { 1.0 };
    let settle = |point: &mut Point| {
        point.stretch += shift + 1.0;
        point.stress *= sign;
    };
    repeats.iter_mut().flat_map(|repeat| &mut repeat.points).for_each(settle);
}

#[cfg(test)]
mod tests {
    use crate::data::curve::{Options, read};
    use crate::data::specimen::Specimen;

    fn amounts(text: &str) -> Vec<(f64, f64)> {
        let specimen = Specimen { height: Some(10e-3), area: Some(1e-4) };
        let options = Options { shear: true, specimen, ..Options::default() };
        let curve = read("shear.csv", text.as_bytes(), &options).unwrap();
        let points = curve.repeats.iter().flat_map(|repeat| &repeat.points);
        points.map(|p| ((1e9 * (p.stretch - 1.0)).round() / 1e9, (1e6 * p.stress).round() / 1e6)).collect()
    }

    #[test]
    fn amounts_of_shear_come_in_many_columns() {
        let expected = [(-0.1, -2e3), (0.0, 0.0), (0.1, 2e3), (0.2, 5e3)];
        for text in [
            "lambda,P_MPa\n-0.1,-0.002\n0,0\n0.1,0.002\n0.2,0.005\n",
            "lambda,P_MPa\n0.9,-0.002\n1,0\n1.1,0.002\n1.2,0.005\n",
            "shear strain [%];shear stress [kPa]\n-10;2\n0;0\n10;-2\n20;-5\n",
            "gamma [-];tau [kPa]\n-0.1;-2\n0;0\n0.1;2\n0.2;5\n",
            "displacement [mm];force [N]\n-1;-0.2\n0;0\n1;0.2\n2;0.5\n",
        ] {
            assert_eq!(amounts(text), expected, "{text}");
        }
    }
}
