//! Units of measurement as test machines write them.

/// What a unit measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Strain or stretch.
    Ratio,
    /// Stress or modulus.
    Stress,
    /// Force.
    Force,
    /// Displacement.
    Length,
    /// Area of a cross-section.
    Area,
    /// Time.
    Time,
}

/// A unit: what it measures, and how many SI units it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// What it measures.
    pub dimension: Dimension,
    /// SI units in one of it.
    pub si: f64,
}

const PSI: f64 = 6_894.757_293_168;
const POUND_FORCE: f64 = 4.448_221_615_260_5;
const KILOGRAM_FORCE: f64 = 9.806_65;

/// Dimension, SI units in one, and the spellings in lower case without blanks, powers as plain digits.
const UNITS: &[(Dimension, f64, &[&str])] = &[
    (Dimension::Ratio, 1.0, &["1", "-", "mm/mm", "m/m", "in/in", "ratio", "abs", "dimensionless", "unitless"]),
    (Dimension::Ratio, 1e-2, &["%", "percent", "pct", "prozent"]),
    (Dimension::Ratio, 1e-6, &["microstrain", "µε", "με", "um/m", "µm/m"]),
    (Dimension::Stress, 1.0, &["pa", "n/m2", "nm-2"]),
    (Dimension::Stress, 1e3, &["kpa", "kn/m2"]),
    (Dimension::Stress, 1e6, &["mpa", "n/mm2", "nmm-2", "mn/m2"]),
    (Dimension::Stress, 1e9, &["gpa"]),
    (Dimension::Stress, 1e5, &["bar"]),
    (Dimension::Stress, 1e4, &["n/cm2"]),
    (Dimension::Stress, PSI, &["psi", "lbf/in2", "lb/in2"]),
    (Dimension::Stress, 1e3 * PSI, &["ksi"]),
    (Dimension::Stress, 1e4 * KILOGRAM_FORCE, &["kgf/cm2", "kg/cm2"]),
    (Dimension::Stress, 0.1, &["dyn/cm2", "dyne/cm2"]),
    (Dimension::Force, 1.0, &["n", "newton", "newtons"]),
    (Dimension::Force, 1e3, &["kn"]),
    (Dimension::Force, 1e-3, &["mn"]),
    (Dimension::Force, POUND_FORCE, &["lbf", "lb", "lbs"]),
    (Dimension::Force, KILOGRAM_FORCE, &["kgf", "kg"]),
    (Dimension::Force, 1e-3 * KILOGRAM_FORCE, &["gf", "g"]),
    (Dimension::Length, 1.0, &["m"]),
    (Dimension::Length, 1e-3, &["mm"]),
    (Dimension::Length, 1e-2, &["cm"]),
    (Dimension::Length, 1e-6, &["um", "µm", "μm"]),
    (Dimension::Length, 25.4e-3, &["in", "inch", "inches"]),
    (Dimension::Area, 1.0, &["m2"]),
    (Dimension::Area, 1e-4, &["cm2"]),
    (Dimension::Area, 1e-6, &["mm2"]),
    (Dimension::Area, 25.4e-3 * 25.4e-3, &["in2"]),
    (Dimension::Time, 1.0, &["s", "sec", "secs", "second", "seconds"]),
    (Dimension::Time, 1e-3, &["ms", "msec"]),
    (Dimension::Time, 60.0, &["min", "minute", "minutes"]),
    (Dimension::Time, 3600.0, &["h", "hr", "hour", "hours"]),
];

/// Units of columns that no fit needs, in lower case.
const OTHERS: &[&str] =
    &["hz", "rad/s", "1/s", "s-1", "°c", "°f", "degc", "c", "k", "v", "deg", "°", "j", "mm/min", "mm/s"];

/// Whether `text` spells a unit, if only one of a column that no fit needs.
pub fn is_unit(text: &str) -> bool {
    Unit::parse(text).is_some() || OTHERS.contains(&text.trim().to_lowercase().as_str())
}

impl Unit {
    /// The unit that `text` spells, in any case and with powers in any notation.
    ///
    /// mN is read as a millinewton and MN as a meganewton; all other spellings ignore case (Mpa is a megapascal).
    pub fn parse(text: &str) -> Option<Self> {
        if text.trim() == "MN" {
            return Some(Self { dimension: Dimension::Force, si: 1e6 });
        }
        let spelling: String = text
            .chars()
            .filter(|c| !matches!(c, ' ' | '^' | '·' | '*' | '.' | '\u{a0}'))
            .map(|c| match c {
                '²' => '2',
                '⁻' | '−' => '-',
                other => other,
            })
            .flat_map(char::to_lowercase)
            .collect();
        UNITS
            .iter()
            .find(|(_, _, spellings)| spellings.contains(&spelling.as_str()))
            .map(|&(dimension, si, _)| Self { dimension, si })
    }
}

/// The length or area that `text` states, such as `29 mm` or `6.6cm2`, in SI units.
///
/// # Errors
/// What would be legal.
pub fn parse_quantity(text: &str, dimension: Dimension) -> Result<f64, String> {
    let example = if dimension == Dimension::Area { "660mm2" } else { "12.5mm" };
    let refuse = || format!("expected a positive number with its unit, such as {example}");
    let trimmed = text.trim();
    // The longest beginning that is a number; an exponent is one, the e of another word is not.
    let (number, unit) = (1..=trimmed.len())
        .rev()
        .filter(|&end| trimmed.is_char_boundary(end))
        .find_map(|end| trimmed[..end].parse::<f64>().ok().map(|number| (number, &trimmed[end..])))
        .ok_or_else(refuse)?;
    match Unit::parse(unit) {
        Some(unit) if unit.dimension == dimension && number.is_finite() && number > 0.0 => Ok(number * unit.si),
        _ => Err(refuse()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spellings_of_a_unit_mean_the_same() {
        for (spellings, dimension, si) in [
            (&["MPa", "mpa", "N/mm²", "N/mm^2", "N mm^-2", "N·mm⁻²", "N/mm2"][..], Dimension::Stress, 1e6),
            (&["%", "percent", "pct"], Dimension::Ratio, 0.01),
            (&["mm/mm", "-", "1"], Dimension::Ratio, 1.0),
            (&["psi", "PSI"], Dimension::Stress, PSI),
            (&["s", "sec", "Seconds"], Dimension::Time, 1.0),
        ] {
            for spelling in spellings {
                assert_eq!(Unit::parse(spelling), Some(Unit { dimension, si }), "{spelling}");
            }
        }
        assert_eq!(Unit::parse("MN").unwrap().si, 1e6);
        assert_eq!(Unit::parse("mN").unwrap().si, 1e-3);
        assert_eq!(Unit::parse("furlong"), None);
    }

    #[test]
    fn quantities_need_their_unit() {
        assert!((parse_quantity("29mm", Dimension::Length).unwrap() - 0.029).abs() < 1e-15);
        assert!((parse_quantity(" 6.6 cm^2 ", Dimension::Area).unwrap() - 6.6e-4).abs() < 1e-15);
        assert!((parse_quantity("1e-2m", Dimension::Length).unwrap() - 0.01).abs() < 1e-15);
        for wrong in ["29", "mm", "-3mm", "29s", "0mm", "infmm", ""] {
            assert!(parse_quantity(wrong, Dimension::Length).is_err(), "{wrong}");
        }
    }
}
