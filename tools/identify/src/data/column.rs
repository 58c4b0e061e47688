//! What a column of a table is, by its title.

use super::unit::{Dimension, Unit};

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Change of length over length.
    Strain,
    /// Length over original length.
    Stretch,
    /// Force over area.
    Stress,
    /// Force of the machine.
    Force,
    /// Change of length.
    Displacement,
    /// Strain or stretch of a free direction.
    Lateral,
    /// Change of the volume over that at rest, or their ratio.
    Volume,
    /// Time.
    Time,
    /// Stress over strain.
    Modulus,
    /// A load over its first or largest value.
    Normalised,
    /// Which specimen or repeat.
    Specimen,
    /// Which load cycle.
    Cycle,
}

/// What strain and stress refer to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// The original length and cross-section (nominal).
    Engineering,
    /// The current ones: logarithmic strain, Cauchy (of these specimens also Kirchhoff) stress.
    True,
    /// Green and Lagrange's strain (l^2 - 1) / 2, the second Piola-Kirchhoff stress.
    Lagrange,
}

/// A column that is understood.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Index in the table.
    pub index: usize,
    /// Title as it stands there.
    pub title: String,
    /// What it holds.
    pub kind: Kind,
    /// SI units in one of its units, if the title tells.
    pub si: Option<f64>,
    /// Its measure, if the title tells.
    pub measure: Option<Measure>,
}

impl Kind {
    /// What it measures; none for names and counts.
    pub fn dimension(self) -> Option<Dimension> {
        match self {
            Self::Strain | Self::Stretch | Self::Normalised | Self::Lateral | Self::Volume => Some(Dimension::Ratio),
            Self::Stress | Self::Modulus => Some(Dimension::Stress),
            Self::Force => Some(Dimension::Force),
            Self::Displacement => Some(Dimension::Length),
            Self::Time => Some(Dimension::Time),
            Self::Specimen | Self::Cycle => None,
        }
    }

    /// Name in messages, and a title that would be understood.
    pub fn example(self) -> (&'static str, &'static str) {
        match self {
            Self::Strain => ("strain", "strain [%]"),
            Self::Stretch => ("stretch", "stretch"),
            Self::Stress => ("stress", "stress [kPa]"),
            Self::Force => ("force", "force [N]"),
            Self::Displacement => ("displacement", "displacement [mm]"),
            Self::Lateral => ("lateral strain", "lateral strain [%]"),
            Self::Volume => ("volume change", "volume change [%]"),
            Self::Time => ("time", "time [s]"),
            Self::Modulus => ("modulus", "modulus [kPa]"),
            Self::Normalised => ("normalised load", "normalised load [-]"),
            Self::Specimen => ("specimen", "specimen"),
            Self::Cycle => ("cycle", "cycle"),
        }
    }
}

impl Column {
    /// The column with `title` at `index`; none if it is nothing that a fit needs.
    ///
    /// # Errors
    /// A title with two meanings, a measure that is not supported, or a unit that does not belong to it.
    pub fn recognise(index: usize, title: &str) -> Result<Option<Self>, String> {
        let (name, unit, bracket) = split_unit(title);
        let words: Vec<String> = name
            .to_lowercase()
            .split(|c: char| !c.is_alphanumeric() && c != 'ε' && c != 'σ' && c != 'λ')
            .filter(|word| !word.is_empty())
            .map(String::from)
            .collect();
        let Some(kind) = kind_of(&words, unit).map_err(|reason| format!("column \"{title}\" {reason}"))? else {
            return Ok(None);
        };
        let measure = measure_of(&words).map_err(|reason| format!("column \"{title}\" {reason}"))?;
        let unit = unit.filter(|unit| Some(unit.dimension) == kind.dimension());
        if let (Some(bracket), None, Some(_)) = (&bracket, unit, kind.dimension()) {
            let known = Unit::parse(bracket).is_some() || bracket.contains(['/', '%']);
            if known {
                let (name, example) = kind.example();
                return Err(format!("column \"{title}\" has no unit of {name}: expected such as \"{example}\""));
            }
        }
        Ok(Some(Self { index, title: title.trim().into(), kind, si: unit.map(|unit| unit.si), measure }))
    }
}

/// The title without its unit, the unit, and what stands in its brackets.
fn split_unit(title: &str) -> (String, Option<Unit>, Option<String>) {
    let title = title.trim().trim_matches('"');
    for (open, close) in [('[', ']'), ('(', ')'), ('<', '>'), ('{', '}')] {
        if let Some((start, end)) = title.rfind(open).zip(title.rfind(close)).filter(|(start, end)| start < end) {
            let inside = &title[start + 1..end];
            let rest = format!("{} {}", &title[..start], &title[end + 1..]);
            if let Some(unit) = Unit::parse(inside) {
                return (rest, Some(unit), Some(inside.into()));
            }
            // "stress (engineering, MPa)"
            if let (name, Some(unit), None) = split_unit(inside) {
                return (format!("{rest} {name}"), Some(unit), Some(inside.into()));
            }
            let (name, unit, _) = split_unit(&rest);
            return (format!("{name} {inside}"), unit, Some(inside.into()));
        }
    }
    // "stress, MPa", "stress/MPa", "stress in N/mm2", "stress_MPa", "stress MPa": the longest end that is a unit.
    for (at, separator) in title.match_indices([',', '/', '_', ' ', ':', '-']) {
        let (name, tail) = (&title[..at], &title[at + separator.len()..]);
        // Without brackets a 1 or a dash is a number or a sign, and the ratio of "extension ratio" a word of its name.
        let spelled =
            tail.contains(|c: char| c.is_alphabetic() || c == '%') && !tail.trim().eq_ignore_ascii_case("ratio");
        if let Some(unit) = Unit::parse(tail).filter(|_| spelled && !name.trim().is_empty()) {
            return (name.into(), Some(unit), None);
        }
    }
    // "StressMPa", "Strain%".
    for suffix in ["MPa", "kPa", "KPa", "Pa", "%", "Percent"] {
        if let Some(name) = title.strip_suffix(suffix).filter(|name| name.ends_with(|c: char| c.is_lowercase())) {
            return (name.into(), Unit::parse(suffix), None);
        }
    }
    (title.into(), None, None)
}

fn kind_of(words: &[String], unit: Option<Unit>) -> Result<Option<Kind>, &'static str> {
    let has = |parts: &[&str]| words.iter().any(|word| parts.iter().any(|part| word.contains(part)));
    let is = |names: &[&str]| matches!(words, [only] if names.contains(&only.as_str()));
    let joined = words.join(" ");
    let dimension = unit.map(|unit| unit.dimension);
    let of = |wanted: Dimension| dimension == Some(wanted);
    let ratio = dimension.is_none() || of(Dimension::Ratio);
    let free = has(&["lateral", "transverse", "querdehnung", "querstreckung", "transversal"]);
    if ratio && free && has(&["strain", "stretch", "dehnung", "streckung", "déformation", "deformación", "ε", "λ"])
    {
        return Ok(Some(Kind::Lateral));
    }
    if ratio && has(&["volum"]) && has(&["change", "ratio", "strain", "änderung", "variation", "dilat"]) {
        return Ok(Some(Kind::Volume));
    }
    let rate = has(&["rate", "speed", "velocity", "energy", "work", "poisson", "lateral", "transverse", "temperature"])
        || is_dynamic(words);
    if rate || words.is_empty() {
        return Ok(None);
    }
    if has(&["time", "zeit", "temps", "elapsed"]) || is(&["t"]) && !of(Dimension::Stress) {
        return Ok(Some(Kind::Time));
    }
    if has(&["normali"]) && !of(Dimension::Stress) && !of(Dimension::Force) {
        return Ok(Some(Kind::Normalised));
    }
    let relaxing = words.len() == 2 && ["e", "g"].contains(&words[0].as_str()) && words[1].starts_with("rel");
    if has(&["modulus", "modul"])
        || relaxing && (of(Dimension::Stress) || dimension.is_none())
        || matches!(joined.as_str(), "g" | "g t" | "e t" | "gt")
        || is(&["e"]) && of(Dimension::Stress)
    {
        return Ok(Some(Kind::Modulus));
    }
    let ratio = ["extension ratio", "elongation ratio", "draw ratio", "l l0"].iter().any(|name| joined.contains(name));
    if has(&["stretch", "lambda", "λ", "streckung"]) || ratio || is(&["lam"]) {
        return Ok(Some(Kind::Stretch));
    }
    if has(&["stress", "spannung", "contrainte", "sigma", "σ", "piola"])
        || has_word(words, &["p", "s", "pk"]) && !of(Dimension::Time) && !of(Dimension::Force)
    {
        return Ok(Some(Kind::Stress));
    }
    // What may be a force or a deformation as well is a stress by its unit.
    let loaded = has(&["force", "kraft", "load", "traction", "tension", "tensión", "sforzo", "esfuerzo"]);
    if of(Dimension::Stress) && (loaded || is(&["t", "f", "n"]) || joined == "f a" || joined == "f a0") {
        return Ok(Some(Kind::Stress));
    }
    let strained = has(&["strain", "dehnung", "stauchung", "epsilon", "ε"]) || has_word(words, &["eps"]) || is(&["e"]);
    let lengthened = has(&["elongation", "deform", "compression", "déform", "verformung"]);
    let moved = has(&[
        "displacement",
        "extension",
        "position",
        "crosshead",
        "travel",
        "stroke",
        "weg",
        "deflection",
        "längung",
    ]) || has_word(words, &["disp", "u", "x", "dl"]);
    if strained || lengthened || moved {
        return match dimension {
            Some(Dimension::Length) => Ok(Some(Kind::Displacement)),
            Some(Dimension::Ratio) => Ok(Some(Kind::Strain)),
            _ if strained => Ok(Some(Kind::Strain)),
            _ if moved => Ok(Some(Kind::Displacement)),
            _ => Err("may be a strain or a displacement: expected a unit in its title, % or mm"),
        };
    }
    if has(&["force", "kraft", "load"]) || is(&["f"]) {
        return Ok(Some(Kind::Force));
    }
    if has_word(words, &["cycle", "zyklus", "loop"]) {
        return Ok(Some(Kind::Cycle));
    }
    let named = has_word(words, &["specimen", "sample", "repeat", "replicate", "probe", "run", "test"]);
    Ok((named && dimension.is_none()).then_some(Kind::Specimen))
}

/// Whether `words` are of a test with oscillations: storage and loss moduli, frequencies.
fn is_dynamic(words: &[String]) -> bool {
    words.iter().any(|word| word == "tan" || ["stor", "loss", "freq", "tand"].iter().any(|part| word.starts_with(part)))
}

/// Whether one of `titles` is that of a test with oscillations.
pub fn are_dynamic<'a>(titles: impl IntoIterator<Item = &'a str>) -> bool {
    titles.into_iter().any(|title| {
        let words = title.to_lowercase();
        let words: Vec<String> = words.split(|c: char| !c.is_alphanumeric()).map(String::from).collect();
        is_dynamic(&words)
    })
}

fn has_word(words: &[String], names: &[&str]) -> bool {
    words.iter().any(|word| names.contains(&word.trim_end_matches(|c: char| c.is_ascii_digit())))
}

fn measure_of(words: &[String]) -> Result<Option<Measure>, &'static str> {
    let has = |names: &[&str]| words.iter().any(|word| names.iter().any(|name| word.starts_with(name)));
    if has(&["almansi", "biot"]) {
        return Err(
            "is of a measure that is not read: expected engineering (nominal), true (logarithmic, Cauchy), Green or \
                    second Piola-Kirchhoff",
        );
    }
    let second = has(&["second", "2nd", "2pk", "pk2"]);
    let first = has(&["eng", "nominal", "nom", "techn", "pk1", "1pk", "conventional"]) || has(&["piola"]) && !second;
    let current = has(&["true", "log", "hencky", "cauchy", "wahr"]) && !has(&["green"])
        || has(&["kirchhoff"]) && !has(&["piola"]) && !second;
    let mut measures = Vec::new();
    measures.extend(first.then_some(Measure::Engineering));
    measures.extend(current.then_some(Measure::True));
    measures.extend((second || has(&["green", "lagrang"])).then_some(Measure::Lagrange));
    match measures.as_slice() {
        [] => Ok(None),
        [measure] => Ok(Some(*measure)),
        _ => Err("names two measures: expected one of engineering, true and Green or second Piola-Kirchhoff"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn titles_tell_kind_unit_and_measure() {
        use Kind::*;
        for (title, kind, si, measure) in [
            ("Strain", Strain, None, None),
            ("strain (%)", Strain, Some(0.01), None),
            ("Engineering Stress (MPa)", Stress, Some(1e6), Some(Measure::Engineering)),
            ("True Strain", Strain, None, Some(Measure::True)),
            ("stress_kPa", Stress, Some(1e3), None),
            ("stress, N/mm²", Stress, Some(1e6), None),
            ("Nominal stress / psi", Stress, Some(6894.757293168), Some(Measure::Engineering)),
            ("Standardkraft in N", Force, Some(1.0), None),
            ("Dehnung [%]", Strain, Some(0.01), None),
            ("Dehnung [mm]", Displacement, Some(1e-3), None),
            ("Compressive strain [mm/mm]", Strain, Some(1.0), None),
            ("Compression (mm)", Displacement, Some(1e-3), None),
            ("Extension (mm)", Displacement, Some(1e-3), None),
            ("Stress (engineering) [MPa]", Stress, Some(1e6), Some(Measure::Engineering)),
            ("Load (N)", Force, Some(1.0), None),
            ("λ", Stretch, None, None),
            ("stretch [-]", Stretch, Some(1.0), None),
            ("σ [kPa]", Stress, Some(1e3), None),
            ("P (MPa)", Stress, Some(1e6), None),
            ("Time (min)", Time, Some(60.0), None),
            ("t", Time, None, None),
            ("G(t) [kPa]", Modulus, Some(1e3), None),
            ("Relaxation modulus (MPa)", Modulus, Some(1e6), None),
            ("StressMPa", Stress, Some(1e6), None),
            ("strain_1", Strain, None, None),
            ("Stress 2 [Pa]", Stress, Some(1.0), None),
            ("Cauchy stress [Pa]", Stress, Some(1.0), Some(Measure::True)),
            ("Sample", Specimen, None, None),
            ("cycle", Cycle, None, None),
            ("Transverse strain (%)", Lateral, Some(0.01), None),
            ("Querdehnung [%]", Lateral, Some(0.01), None),
            ("Volume ratio [-]", Volume, Some(1.0), None),
            ("Volumenänderung [%]", Volume, Some(0.01), None),
            ("E_relax [MPa]", Modulus, Some(1e6), None),
            ("Normalized modulus [-]", Normalised, Some(1.0), None),
            ("Extension ratio", Stretch, None, None),
            ("L/L0 [-]", Stretch, Some(1.0), None),
            ("Strain (ratio)", Strain, Some(1.0), None),
            ("stress N/mm2", Stress, Some(1e6), None),
            ("Spannung in N/mm²", Stress, Some(1e6), None),
            ("sigma_eng / MPa", Stress, Some(1e6), Some(Measure::Engineering)),
            ("Stress (engineering, MPa)", Stress, Some(1e6), Some(Measure::Engineering)),
            ("S11 [kPa]", Stress, Some(1e3), None),
            ("Load/area (MPa)", Stress, Some(1e6), None),
            ("Verformung [mm]", Displacement, Some(1e-3), None),
            ("Green strain", Strain, None, Some(Measure::Lagrange)),
            ("Cauchy-Green strain", Strain, None, Some(Measure::Lagrange)),
            ("Kirchhoff stress [Pa]", Stress, Some(1.0), Some(Measure::True)),
            ("first Piola-Kirchhoff stress [Pa]", Stress, Some(1.0), Some(Measure::Engineering)),
            ("2nd Piola-Kirchhoff stress [Pa]", Stress, Some(1.0), Some(Measure::Lagrange)),
        ] {
            let column = Column::recognise(0, title).unwrap().unwrap_or_else(|| panic!("{title}"));
            assert_eq!((column.kind, column.measure), (kind, measure), "{title}");
            let close = |a: Option<f64>, b: Option<f64>| a.map(|a| (a * 1e9).round()) == b.map(|b| (b * 1e9).round());
            assert!(close(column.si, si), "{title}: {:?}", column.si);
        }
    }

    #[test]
    fn other_columns_are_passed_over_and_unclear_ones_refused() {
        for title in [
            "Temperature (C)",
            "strain rate (1/s)",
            "",
            "remarks",
            "Poisson's ratio",
            "E_stor [MPa]",
            "Loss modulus [MPa]",
        ] {
            assert_eq!(Column::recognise(0, title), Ok(None), "{title}");
        }
        for title in ["Elongation", "Almansi strain", "stress [mm]", "engineering true strain"] {
            assert!(Column::recognise(0, title).is_err(), "{title}");
        }
    }
}
