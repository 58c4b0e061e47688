//! Numbers with units, such as `"14.7 J"`, in SI.

use softanvil_records::unit::{Dimension, Unit, number_and_rest};

/// The number of SI units `si` that `text` states, which may leave its unit out only of a ratio; nothing if it states none.
pub fn parse(text: &str, si: &str) -> Option<f64> {
    let (number, unit) = number_and_rest(text)?;
    Some(number * factor(unit.trim(), si)?)
}

/// How many `si` a `unit` is.
fn factor(unit: &str, si: &str) -> Option<f64> {
    if si == "1" && unit.is_empty() || unit == si {
        return Some(1.0);
    }
    let of = |dimension, unit: &str| Unit::of(dimension, unit).map(|unit| unit.si);
    match si {
        "1" => of(Dimension::Ratio, unit),
        "m" => of(Dimension::Length, unit),
        "s" => of(Dimension::Time, unit),
        "kg" => of(Dimension::Mass, unit),
        "N" => of(Dimension::Force, unit),
        "Pa" => of(Dimension::Stress, unit),
        "m/s2" => of(Dimension::Acceleration, unit),
        "Hz" | "1/s" => of(Dimension::Frequency, unit),
        "J" => energy(unit),
        "m/s" => speed(unit),
        "kg/m3" => density(unit),
        "N.s/m" => damping(unit),
        _ => None,
    }
}

/// Joules, or a force times a length: N m, ft lbf.
fn energy(unit: &str) -> Option<f64> {
    match unit {
        "mJ" => return Some(1e-3),
        "kJ" => return Some(1e3),
        _ => {}
    }
    let (first, second) = unit.split_once([' ', '*', '.', '·', '-'])?;
    let product = |force, length| Some(Unit::of(Dimension::Force, force)?.si * Unit::of(Dimension::Length, length)?.si);
    product(first, second).or_else(|| product(second, first))
}

fn speed(unit: &str) -> Option<f64> {
    match unit {
        "kph" => return Some(1.0 / 3.6),
        "mph" => return Some(0.447_04),
        _ => {}
    }
    let (length, time) = unit.split_once('/')?;
    let length = if length == "km" { 1e3 } else { Unit::of(Dimension::Length, length)?.si };
    Some(length / Unit::of(Dimension::Time, time)?.si)
}

fn density(unit: &str) -> Option<f64> {
    let (mass, volume) = unit.split_once('/')?;
    let edge = volume.strip_suffix("^3").or_else(|| volume.strip_suffix(['3', '³']))?;
    Some(Unit::of(Dimension::Mass, mass)?.si / Unit::of(Dimension::Length, edge)?.si.powi(3))
}

/// A force over a speed, such as N s/m.
fn damping(unit: &str) -> Option<f64> {
    let (above, length) = unit.split_once('/')?;
    let (force, time) = above.split_once([' ', '*', '.', '·'])?;
    let [force, time, length] =
        [(Dimension::Force, force), (Dimension::Time, time), (Dimension::Length, length)].map(|(d, u)| Unit::of(d, u));
    Some(force?.si * time?.si / length?.si)
}
