//! Units of measurement as test machines write them.
//!
//! Factors are exact by the definitions of the units; a unit that is a quotient, such as N/mm2, is made of its parts.

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
    /// Acceleration.
    Acceleration,
    /// Mass.
    Mass,
    /// Frequency, or samples in a time.
    Frequency,
}

impl Dimension {
    /// The SI unit.
    pub fn si(self) -> &'static str {
        match self {
            Self::Ratio => "1",
            Self::Stress => "Pa",
            Self::Force => "N",
            Self::Length => "m",
            Self::Area => "m2",
            Self::Time => "s",
            Self::Acceleration => "m/s2",
            Self::Mass => "kg",
            Self::Frequency => "Hz",
        }
    }
}

/// A unit: what it measures, and how many SI units it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// What it measures.
    pub dimension: Dimension,
    /// SI units in one of it.
    pub si: f64,
}

/// Standard gravity, m/s2, by definition.
pub const GRAVITY: f64 = 9.806_65;
/// The pound, kg, by definition.
const POUND: f64 = 0.453_592_37;
const POUND_FORCE: f64 = POUND * GRAVITY;
/// The inch, m, by definition.
const INCH: f64 = 25.4e-3;
const PSI: f64 = POUND_FORCE / (INCH * INCH);

/// Dimension, SI units in one, and the spellings in lower case without blanks, powers as plain digits.
///
/// Of a spelling with two meanings the first stands for both, unless the column tells: g is a gram-force or the
/// acceleration of gravity, kg a force or a mass.
const UNITS: &[(Dimension, f64, &[&str])] = &[
    (Dimension::Ratio, 1.0, &["1", "-", "ratio", "abs", "dimensionless", "unitless"]),
    (Dimension::Ratio, 1e-2, &["%", "percent", "pct", "prozent", "pourcent", "porcentaje"]),
    (Dimension::Ratio, 1e-6, &["microstrain", "ustrain", "µstrain", "με", "µε", "um/m"]),
    (Dimension::Stress, 1.0, &["pa", "pascal", "nm-2", "па"]),
    (Dimension::Stress, 1e3, &["kpa", "kilopascal", "кпа"]),
    (Dimension::Stress, 1e6, &["mpa", "megapascal", "nmm-2", "мпа"]),
    (Dimension::Stress, 1e9, &["gpa"]),
    (Dimension::Stress, 1e2, &["hpa", "mbar"]),
    (Dimension::Stress, 1e5, &["bar"]),
    (Dimension::Stress, PSI, &["psi", "lbs/in2"]),
    (Dimension::Stress, 1e3 * PSI, &["ksi"]),
    (Dimension::Force, 1.0, &["n", "newton", "newtons", "н"]),
    (Dimension::Force, 1e3, &["kn", "kilonewton", "kilonewtons", "кн"]),
    (Dimension::Force, 10.0, &["dan"]),
    (Dimension::Force, 1e-2, &["cn"]),
    (Dimension::Force, 1e-3, &["mn", "millinewton"]),
    (Dimension::Force, 1e-6, &["µn", "un"]),
    (Dimension::Force, 1e-5, &["dyn", "dyne"]),
    (Dimension::Force, POUND_FORCE, &["lbf", "lb", "lbs", "poundforce"]),
    (Dimension::Force, 1e3 * POUND_FORCE, &["klbf", "kip", "kips", "klb"]),
    (Dimension::Force, GRAVITY, &["kgf", "kg", "kp"]),
    (Dimension::Force, 1e-3 * GRAVITY, &["gf", "g"]),
    (Dimension::Length, 1.0, &["m", "meter", "metre"]),
    (Dimension::Length, 1e-3, &["mm", "millimeter", "millimetre", "millimeters", "мм", "毫米"]),
    (Dimension::Length, 1e-2, &["cm"]),
    (Dimension::Length, 1e-6, &["um", "µm", "micron", "microns"]),
    (Dimension::Length, INCH, &["in", "inch", "inches", "zoll", "\""]),
    (Dimension::Length, 1e-3 * INCH, &["mil", "mils", "thou"]),
    (Dimension::Length, 12.0 * INCH, &["ft", "feet"]),
    (Dimension::Area, 1.0, &["m2"]),
    (Dimension::Area, 1e-4, &["cm2"]),
    (Dimension::Area, 1e-6, &["mm2"]),
    (Dimension::Area, INCH * INCH, &["in2", "sqin"]),
    (
        Dimension::Time,
        1.0,
        &["s", "sec", "secs", "second", "seconds", "sek", "sekunden", "secondes", "segundos", "с", "秒"],
    ),
    (Dimension::Time, 1e-3, &["ms", "msec", "millisecond", "milliseconds", "millisekunden", "мс"]),
    (Dimension::Time, 1e-6, &["us", "µs", "usec", "µsec", "microsecond", "microseconds", "mikrosekunden"]),
    (Dimension::Time, 1e-9, &["ns", "nsec", "nanosecond", "nanoseconds"]),
    (Dimension::Time, 60.0, &["min", "minute", "minutes"]),
    (Dimension::Time, 3600.0, &["h", "hr", "hour", "hours"]),
    (Dimension::Acceleration, 1.0, &["ms-2"]),
    (Dimension::Acceleration, GRAVITY, &["g", "gs", "g's", "gn", "g0", "gee", "gees", "g-force"]),
    (Dimension::Acceleration, 1e-2, &["gal"]),
    (Dimension::Mass, 1.0, &["kg", "kilogram", "kilograms"]),
    (Dimension::Mass, 1e-3, &["g", "gram", "grams"]),
    (Dimension::Mass, 1e3, &["tonne", "tonnes"]),
    (Dimension::Mass, POUND, &["lb", "lbs", "lbm", "pound", "pounds"]),
    (Dimension::Frequency, 1.0, &["hz", "hertz", "1/s", "s-1", "/s", "sps", "s/s", "sa/s", "samples/s", "samples/sec"]),
    (Dimension::Frequency, 1e3, &["khz", "ksps", "ks/s", "ksa/s"]),
    (Dimension::Frequency, 1e6, &["mhz", "msps", "ms/s", "msa/s"]),
];

/// Units of columns that nothing needs, in lower case.
const OTHERS: &[&str] = &[
    "rad/s", "°c", "°f", "degc", "degf", "c", "k", "v", "volt", "volts", "mv", "mv/v", "deg", "°", "rad", "j", "mj",
    "mm/min", "mm/s", "m/s", "in/min", "in/s", "n/tex", "cn/tex", "gf/tex", "gf/den", "n/mm", "n/m", "nm", "n*m",
    "n·m", "lbf/in", "pc", "a", "ma", "w", "db", "rpm", "mm3", "cm3", "mm4", "min-1", "n·mm", "nmm",
];

/// Whether `text` spells a unit, if only one of a column that nothing needs.
pub fn is_unit(text: &str) -> bool {
    Unit::parse(text).is_some() || OTHERS.contains(&text.trim().to_lowercase().as_str())
}

impl Unit {
    /// The unit that `text` spells, in any case and with powers in any notation; of two meanings the first.
    ///
    /// mN is read as a millinewton and MN as a meganewton; all other spellings ignore case (Mpa is a megapascal).
    pub fn parse(text: &str) -> Option<Self> {
        Self::meanings(text).into_iter().next()
    }

    /// The unit of `dimension` that `text` spells.
    pub fn of(dimension: Dimension, text: &str) -> Option<Self> {
        Self::meanings(text).into_iter().find(|unit| unit.dimension == dimension)
    }

    /// Every unit that `text` spells.
    pub fn meanings(text: &str) -> Vec<Self> {
        match text.trim() {
            "MN" => return vec![Self { dimension: Dimension::Force, si: 1e6 }],
            "G" => return vec![Self { dimension: Dimension::Acceleration, si: GRAVITY }],
            _ => {}
        }
        if let Some(area) = text.trim().strip_prefix("MN/").and_then(|area| Self::of(Dimension::Area, area)) {
            return vec![Self { dimension: Dimension::Stress, si: 1e6 / area.si }];
        }
        let spelling: String = plain(text).collect();
        let mut found = listed(&spelling);
        found.extend(quotient(&spelling));
        found
    }
}

/// `text` in lower case, without blanks, with powers as plain digits and one sign for each meaning.
fn plain(text: &str) -> impl Iterator<Item = char> + '_ {
    text.chars()
        .filter(|c| !matches!(c, ' ' | '^' | '·' | '.' | '*' | '\u{a0}' | '\t' | '\u{202f}'))
        .map(|c| match c {
            '²' => '2',
            '⁻' | '−' => '-',
            '¹' => '1',
            '\u{3bc}' => 'µ',
            other => other,
        })
        .flat_map(char::to_lowercase)
        // Greek small mu is what the lower case of the micro sign may become.
        .map(|c| if c == '\u{3bc}' { 'µ' } else { c })
}

fn listed(spelling: &str) -> Vec<Unit> {
    let spelled = |list: &&(Dimension, f64, &[&str])| list.2.iter().any(|known| plain(known).eq(spelling.chars()));
    UNITS.iter().filter(spelled).map(|&(dimension, si, _)| Unit { dimension, si }).collect()
}

/// A unit over another: a stress, a ratio of lengths, or an acceleration.
fn quotient(spelling: &str) -> Option<Unit> {
    let (above, below) = spelling.split_once('/')?;
    let below = below.trim_matches(['(', ')']);
    let of = |dimension: Dimension, text: &str| listed(text).into_iter().find(|unit| unit.dimension == dimension);
    if let (Some(force), Some(area)) = (of(Dimension::Force, above), of(Dimension::Area, below)) {
        return Some(Unit { dimension: Dimension::Stress, si: force.si / area.si });
    }
    let length = of(Dimension::Length, above)?;
    if let Some(other) = of(Dimension::Length, below) {
        return Some(Unit { dimension: Dimension::Ratio, si: length.si / other.si });
    }
    // s2, s*s (whose sign is dropped), s/s
    let time = ["s", "ms"].into_iter().find(|time| {
        below
            .strip_prefix(time)
            .is_some_and(|rest| rest == "2" || rest == *time || rest.strip_prefix('/') == Some(time))
    })?;
    let time = of(Dimension::Time, time)?;
    Some(Unit { dimension: Dimension::Acceleration, si: length.si / (time.si * time.si) })
}

/// The quantity of `dimension` that `text` states, such as `29 mm`, `6.6cm2` or `20 kHz`, in SI units.
///
/// # Errors
/// What would be legal.
pub fn parse_quantity(text: &str, dimension: Dimension) -> Result<f64, String> {
    let example = match dimension {
        Dimension::Area => "660mm2",
        Dimension::Mass => "5kg",
        Dimension::Frequency => "20kHz",
        Dimension::Force => "100N",
        Dimension::Time => "8ms",
        _ => "12.5mm",
    };
    let refuse = || format!("expected a positive number with its unit, such as {example}");
    let (number, unit) = number_and_rest(text).ok_or_else(refuse)?;
    match Unit::of(dimension, unit) {
        Some(unit) if number.is_finite() && number > 0.0 => Ok(number * unit.si),
        _ => Err(refuse()),
    }
}

/// The number that `text` begins with, and what follows it.
pub fn number_and_rest(text: &str) -> Option<(f64, &str)> {
    let trimmed = text.trim();
    // The longest beginning that is a number; an exponent is one, the e of another word is not.
    let most = trimmed.find(|c: char| !matches!(c, '0'..='9' | '.' | '-' | '+' | 'e' | 'E')).unwrap_or(trimmed.len());
    let number = |end: usize| trimmed[..end].parse::<f64>().ok().map(|number| (number, &trimmed[end..]));
    (1..=most).rev().find_map(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spellings_of_a_unit_mean_the_same() {
        for (spellings, dimension, si) in [
            (&["MPa", "mpa", "N/mm²", "N/mm^2", "N mm^-2", "N·mm⁻²", "N/mm2", "MN/m2"][..], Dimension::Stress, 1e6),
            (&["%", "percent", "pct"], Dimension::Ratio, 0.01),
            (&["mm/mm", "-", "1", "in/in"], Dimension::Ratio, 1.0),
            (&["s", "sec", "Seconds", "с", "秒"], Dimension::Time, 1.0),
            (&["кН", "kN"], Dimension::Force, 1e3),
            (&["µs", "μs", "us"], Dimension::Time, 1e-6),
            (&["m/s2", "m/s^2", "m/s²", "m/(s*s)", "m/s/s", "m s-2", "m·s⁻²"], Dimension::Acceleration, 1.0),
            (&["microstrain", "µε", "με", "um/m", "µm/m"], Dimension::Ratio, 1e-6),
        ] {
            for spelling in spellings {
                let found = Unit::parse(spelling).unwrap_or_else(|| panic!("{spelling}"));
                assert_eq!(found.dimension, dimension, "{spelling}");
                assert!((found.si / si - 1.0).abs() < 1e-14, "{spelling}: {}", found.si);
            }
        }
        assert_eq!(Unit::parse("MN").unwrap().si, 1e6);
        assert_eq!(Unit::parse("mN").unwrap().si, 1e-3);
        assert_eq!(Unit::parse("furlong"), None);
    }

    #[test]
    fn a_spelling_of_two_meanings_has_both() {
        assert_eq!(Unit::of(Dimension::Acceleration, "g").unwrap().si, GRAVITY);
        assert_eq!(Unit::of(Dimension::Force, "g").unwrap().si, 1e-3 * GRAVITY);
        assert_eq!(Unit::of(Dimension::Mass, "kg").unwrap().si, 1.0);
        assert_eq!(Unit::of(Dimension::Force, "kg").unwrap().si, GRAVITY);
    }

    /// NIST Special Publication 811 (2008), appendix B.8 and table 6: factors with seven digits, those that are exact in full.
    #[test]
    fn factors_are_those_of_nist() {
        for (spelling, factor) in [
            ("psi", 6.894757e3),
            ("ksi", 6.894757e6),
            ("bar", 1e5),
            ("mbar", 1e2),
            ("MPa", 1e6),
            ("kPa", 1e3),
            ("kgf/cm2", 9.80665e4),
            ("gf/cm2", 9.80665e1),
            ("dyn/cm2", 0.1),
            ("N/mm2", 1e6),
            ("N", 1.0),
            ("kN", 1e3),
            ("dyn", 1e-5),
            ("lbf", 4.448222),
            ("kip", 4.448222e3),
            ("kgf", 9.80665),
            ("kp", 9.80665),
            ("mm", 1e-3),
            ("micron", 1e-6),
            ("in", 2.54e-2),
            ("ft", 3.048e-1),
            ("mil", 2.54e-5),
            ("ms", 1e-3),
            ("us", 1e-6),
            ("min", 60.0),
            ("h", 3600.0),
            ("m/s2", 1.0),
            ("mm/s2", 1e-3),
            ("ft/s2", 3.048e-1),
            ("in/s2", 2.54e-2),
            ("gal", 1e-2),
            ("G", 9.80665),
            ("lbm", 4.535924e-1),
            ("tonne", 1e3),
            ("in2", 6.4516e-4),
            ("cm2", 1e-4),
            ("kHz", 1e3),
            ("%", 1e-2),
            ("microstrain", 1e-6),
        ] {
            let si = Unit::parse(spelling).unwrap_or_else(|| panic!("{spelling}")).si;
            assert!((si / factor - 1.0).abs() < 2e-7, "{spelling}: {si} and {factor}");
        }
    }

    #[test]
    fn quantities_need_their_unit() {
        assert!((parse_quantity("29mm", Dimension::Length).unwrap() - 0.029).abs() < 1e-15);
        assert!((parse_quantity(" 6.6 cm^2 ", Dimension::Area).unwrap() - 6.6e-4).abs() < 1e-15);
        assert!((parse_quantity("1e-2m", Dimension::Length).unwrap() - 0.01).abs() < 1e-15);
        assert_eq!(parse_quantity("5 kg", Dimension::Mass).unwrap(), 5.0);
        assert_eq!(parse_quantity("20kHz", Dimension::Frequency).unwrap(), 2e4);
        for wrong in ["29", "mm", "-3mm", "29s", "0mm", "infmm", ""] {
            assert!(parse_quantity(wrong, Dimension::Length).is_err(), "{wrong}");
        }
    }
}
