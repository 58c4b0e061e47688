//! What a column of a table is, by its title.

use super::channel::{self, Filter};
pub use super::kind::Kind;
use super::unit::{self, Dimension, Unit};

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
    /// Its unit, if the title tells.
    pub unit: Option<String>,
    /// Its measure, if the title tells.
    pub measure: Option<Measure>,
    /// How it was filtered, if the title tells.
    pub filter: Option<Filter>,
}

impl Column {
    /// The column with `title` at `index`; none if it is nothing that is needed.
    ///
    /// # Errors
    /// A title with two meanings, a measure that is not supported, or a unit that does not belong to it.
    pub fn recognise(index: usize, title: &str) -> Result<Option<Self>, String> {
        let Spelled { name, unit, bracket } = split_unit(title);
        let words = words_of(&name);
        let first = unit.as_deref().and_then(Unit::parse);
        if is_of_another_test(title, &words) && !is_load(first) || is_computed(&words) {
            return Ok(None);
        }
        let refuse = |reason: &str| format!("column \"{title}\" {reason}");
        let kind = match channel::code(title) {
            Some(code) => code.kind,
            None => kind_of(&words, first, unit.as_deref()).map_err(refuse)?,
        };
        let Some(kind) = kind else { return Ok(None) };
        let measure = measure_of(&words).map_err(refuse)?;
        let of_kind = unit.as_deref().and_then(|text| Unit::of(kind.dimension()?, text));
        let other = split_unit(&name).unit.and_then(|text| Some((Unit::of(kind.dimension()?, &text)?, text)));
        if let (Some(unit), Some(one), Some((other, two))) = (&unit, of_kind, other)
            && one.si != other.si
        {
            return Err(refuse(&format!("has two units, {two} and {unit}: expected one")));
        }
        if let (Some(bracket), None, Some(_)) = (&bracket, of_kind, kind.dimension()) {
            let known = unit::is_unit(bracket) || bracket.contains(['/', '%']);
            if known {
                let (name, example) = kind.example();
                return Err(format!("column \"{title}\" has no unit of {name}: expected such as \"{example}\""));
            }
        }
        Ok(Some(Self {
            index,
            title: title.trim().into(),
            kind,
            si: of_kind.map(|unit| unit.si),
            unit: unit.filter(|_| of_kind.is_some()).map(|unit| unit.trim().into()),
            measure,
            filter: channel::filter(title),
        }))
    }

    /// The column of `kind` that an option names: its unit is that of `text`, if it states one, else of its title.
    ///
    /// # Errors
    /// A unit that is none of that kind.
    pub fn named(index: usize, title: &str, kind: Kind, unit: Option<&str>) -> Result<Self, String> {
        let own = split_unit(title);
        let stated = unit.map(String::from).or(own.unit);
        let of = |text: &str| kind.dimension().and_then(|dimension| Unit::of(dimension, text));
        let found = stated.as_deref().and_then(of);
        if let (Some(unit), None) = (unit, found) {
            let (name, example) = kind.example();
            return Err(format!("[{unit}] is no unit of {name}: expected such as \"{example}\""));
        }
        Ok(Self {
            index,
            title: title.trim().into(),
            kind,
            si: found.map(|unit| unit.si),
            unit: stated.filter(|_| found.is_some()),
            measure: None,
            filter: channel::filter(title),
        })
    }

    /// The column with a `title` that is not understood, by its unit: a unit of force, time or acceleration has one meaning;
    /// one of stress, ratio or length only under a title in another script than ours.
    pub fn by_unit(index: usize, title: &str) -> Option<Self> {
        let Spelled { name, unit, .. } = split_unit(title);
        let words = words_of(&name);
        let text = unit?;
        if is_of_another_test(title, &words) && !is_load(Unit::parse(&text)) || is_computed(&words) {
            return None;
        }
        let foreign = name.chars().any(|c| c.is_alphabetic() && c > '\u{3ff}');
        let meanings = Unit::meanings(&text);
        let [unit] = meanings.as_slice() else { return None };
        let kind = match unit.dimension {
            Dimension::Force => Kind::Force,
            Dimension::Time => Kind::Time,
            Dimension::Acceleration => Kind::Acceleration,
            Dimension::Stress if foreign => Kind::Stress,
            Dimension::Ratio if foreign => Kind::Strain,
            Dimension::Length if foreign => Kind::Displacement,
            _ => return None,
        };
        let si = Some(unit.si);
        let filter = channel::filter(title);
        Some(Self { index, title: title.trim().into(), kind, si, unit: Some(text), measure: None, filter })
    }
}

/// The words of a title, in lower case.
fn words_of(name: &str) -> Vec<String> {
    name.to_lowercase()
        .split(|c: char| !c.is_alphanumeric() && c != 'ε' && c != 'σ' && c != 'λ')
        .filter(|word| !word.is_empty())
        .map(String::from)
        .collect()
}

/// A title in its parts.
struct Spelled {
    name: String,
    unit: Option<String>,
    /// What stands in its brackets.
    bracket: Option<String>,
}

/// The title without its unit, and the unit.
fn split_unit(title: &str) -> Spelled {
    let title = title.trim().trim_matches('"');
    let known = |text: &str| Unit::parse(text).map(|_| text.to_string());
    for (open, close) in [('[', ']'), ('(', ')'), ('<', '>'), ('{', '}')] {
        if let Some((start, end)) = title.rfind(open).zip(title.rfind(close)).filter(|(start, end)| start < end) {
            let inside = &title[start + open.len_utf8()..end];
            let rest = format!("{} {}", &title[..start], &title[end + close.len_utf8()..]);
            if let Some(unit) = known(inside) {
                return Spelled { name: rest, unit: Some(unit), bracket: Some(inside.into()) };
            }
            // "stress (engineering, MPa)"
            if let Spelled { name, unit: Some(unit), bracket: None } = split_unit(inside) {
                let name = format!("{rest} {name}");
                return Spelled { name, unit: Some(unit), bracket: Some(inside.into()) };
            }
            let Spelled { name, unit, .. } = split_unit(&rest);
            return Spelled { name: format!("{name} {inside}"), unit, bracket: Some(inside.into()) };
        }
    }
    // "stress, MPa", "stress/MPa", "stress in N/mm2", "stress_MPa", "stress MPa": the longest end that is a unit.
    for (at, separator) in title.match_indices([',', '/', '_', ' ', ':', '-']) {
        let (name, tail) = (&title[..at], &title[at + separator.len()..]);
        // Without brackets a 1 or a dash is a number or a sign, and the ratio of "extension ratio" a word of its name.
        let spelled =
            tail.contains(|c: char| c.is_alphabetic() || c == '%') && !tail.trim().eq_ignore_ascii_case("ratio");
        if let Some(unit) = known(tail).filter(|_| spelled && !name.trim().is_empty()) {
            return Spelled { name: name.into(), unit: Some(unit), bracket: None };
        }
    }
    // "StressMPa", "Strain%".
    for suffix in ["MPa", "kPa", "KPa", "Pa", "%", "Percent"] {
        if let Some(name) = title.strip_suffix(suffix).filter(|name| name.ends_with(|c: char| c.is_lowercase())) {
            return Spelled { name: name.into(), unit: Some(suffix.into()), bracket: None };
        }
    }
    Spelled { name: title.into(), unit: None, bracket: None }
}

/// Whether a column is of the strain or stretch of a free direction.
fn is_lateral(words: &[String]) -> bool {
    let has = |parts: &[&str]| words.iter().any(|word| parts.iter().any(|part| word.contains(part)));
    has(&["lateral", "transvers", "querdehnung", "querstreckung"])
        && has(&["strain", "stretch", "dehnung", "streckung", "déformation", "deformación", "ε", "λ"])
}

/// Whether `unit` is one of the loads of an impact: under it a word such as "temperature" is of how the load was corrected.
fn is_load(unit: Option<Unit>) -> bool {
    unit.is_some_and(|unit| matches!(unit.dimension, Dimension::Force | Dimension::Acceleration))
}

/// Whether a column is of what no fit and no impact needs: rates, energies, lateral displacements, moduli of oscillations.
fn is_of_another_test(title: &str, words: &[String]) -> bool {
    const OTHERS: &[&str] = &[
        "rate",
        "rates",
        "strainrate",
        "speed",
        "velocity",
        "energy",
        "work",
        "poisson",
        "temperature",
        "angular",
        "torque",
    ];
    /// Ends of German words, which join several in one.
    const ENDS: &[&str] = &["geschwindigkeit", "temperatur"];
    const FREE: &[&str] = &["lateral", "transverse"];
    let has = |parts: &[&str]| words.iter().any(|word| parts.iter().any(|part| word.contains(part)));
    words.is_empty() && !title.contains(char::is_alphabetic)
        || words.iter().any(|word| OTHERS.contains(&word.as_str()) || ENDS.iter().any(|end| word.ends_with(end)))
        || has(FREE) && !is_lateral(words)
        || is_dynamic(title, words)
}

/// Words of a column that was computed: a fit, a model, a scatter.
const COMPUTED: &[&str] = &[
    "fit",
    "fits",
    "fitted",
    "fitting",
    "modelled",
    "modeled",
    "pred",
    "predicted",
    "prediction",
    "simulated",
    "simulation",
    "theory",
    "theoretical",
    "calculated",
    "analytical",
    "err",
    "error",
    "std",
    "stdev",
    "stddev",
    "deviation",
    "residual",
    "residuals",
    "uncertainty",
];

/// Words that say the same, or something else: the model or the letters of a sensor.
const PERHAPS_COMPUTED: &[&str] = &["model", "modell", "modelo", "sim", "fem", "fea", "fe", "calc", "sd", "sem", "ci"];

/// Words of a column beside a computed one.
const MEASURED: &[&str] = &[
    "data",
    "exp",
    "experiment",
    "experimental",
    "measured",
    "measurement",
    "test",
    "mean",
    "avg",
    "average",
    "raw",
    "observed",
    "gemessen",
];

/// Whether the column with `title` was computed, one of `titles`: by a word that says so, or by one that may say so where a
/// measured twin stands beside it.
pub fn is_of_a_model(title: &str, titles: &[String]) -> bool {
    let words = words_of(&split_unit(title).name);
    let bare = |words: &[String]| -> Vec<String> {
        let kept = |word: &&String| ![PERHAPS_COMPUTED, MEASURED].iter().any(|list| list.contains(&word.as_str()));
        words.iter().filter(kept).cloned().collect()
    };
    let is_twin = |other: &String| {
        let others = words_of(&split_unit(other).name);
        !is_computed(&others) && !may_be_computed(&others) && !others.is_empty() && bare(&others) == bare(&words)
    };
    is_computed(&words) || may_be_computed(&words) && titles.iter().any(is_twin)
}

/// Whether a word says that a column was computed.
fn is_computed(words: &[String]) -> bool {
    words.iter().any(|word| COMPUTED.contains(&word.as_str()))
}

fn may_be_computed(words: &[String]) -> bool {
    words.iter().any(|word| PERHAPS_COMPUTED.contains(&word.as_str()))
}

fn kind_of(words: &[String], unit: Option<Unit>, spelled: Option<&str>) -> Result<Option<Kind>, &'static str> {
    let has = |parts: &[&str]| words.iter().any(|word| parts.iter().any(|part| word.contains(part)));
    let is = |names: &[&str]| matches!(words, [only] if names.contains(&only.as_str()));
    let joined = words.join(" ");
    let dimension = unit.map(|unit| unit.dimension);
    let of = |wanted: Dimension| dimension == Some(wanted);
    let ratio = dimension.is_none() || of(Dimension::Ratio);
    if is_lateral(words) {
        return Ok(ratio.then_some(Kind::Lateral));
    }
    if ratio && has(&["volum"]) && has(&["change", "ratio", "strain", "änderung", "variation", "dilat"]) {
        return Ok(Some(Kind::Volume));
    }
    let may_be = |wanted: Dimension| spelled.is_some_and(|text| Unit::of(wanted, text).is_some());
    if words.is_empty() {
        return Ok(None);
    }
    if has(&["accel", "beschleunig", "accél", "acelera", "decel", "décél", "verzögerung"])
        || has_word(words, &["acc"])
        || has_word(words, &["a", "ax", "ay", "az"]) && may_be(Dimension::Acceleration)
    {
        return Ok(Some(Kind::Acceleration));
    }
    if has(&["time", "zeit", "temps", "tiempo", "elapsed"]) || is(&["t"]) && !of(Dimension::Stress) {
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
        || has_word(words, &["p", "s", "pk", "tau", "τ"]) && !of(Dimension::Time) && !of(Dimension::Force)
    {
        return Ok(Some(Kind::Stress));
    }
    // What may be a force or a deformation as well is a stress by its unit.
    let loaded =
        has(&["force", "kraft", "load", "traction", "tension", "tensión", "sforzo", "esfuerzo", "fuerza", "carga"]);
    if of(Dimension::Stress) && (loaded || is(&["t", "f", "n"]) || joined == "f a" || joined == "f a0") {
        return Ok(Some(Kind::Stress));
    }
    let strained = has(&["strain", "dehnung", "stauchung", "epsilon", "ε"])
        || has_word(words, &["eps", "gamma", "γ"])
        || is(&["e"]);
    let lengthened =
        has(&["elongation", "deform", "compression", "déform", "verformung", "allongement", "alargamiento"]);
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
        "déplacement",
        "deplacement",
        "desplazamiento",
        "spostamento",
        "traverse",
    ]) || has_word(words, &["disp", "u", "dl"])
        || has_word(words, &["x", "course", "carrera", "recorrido", "z", "d"]) && of(Dimension::Length);
    if strained || lengthened || moved {
        return match dimension {
            Some(Dimension::Length) => Ok(Some(Kind::Displacement)),
            Some(Dimension::Ratio) => Ok(Some(Kind::Strain)),
            _ if strained => Ok(Some(Kind::Strain)),
            _ if moved => Ok(Some(Kind::Displacement)),
            _ => Err("may be a strain or a displacement: expected a unit in its title, % or mm"),
        };
    }
    if has(&["force", "kraft", "load", "fuerza", "carga", "forza"])
        || has_word(words, &["f", "fx", "fy", "fz", "fn"])
        || has_word(words, &["last", "charge", "effort"]) && of(Dimension::Force)
    {
        return Ok(Some(Kind::Force));
    }
    if has_word(words, &["cycle", "zyklus", "loop"]) {
        return Ok(Some(Kind::Cycle));
    }
    let named = has_word(words, &["specimen", "sample", "repeat", "replicate", "probe", "run", "test"]);
    Ok((named && dimension.is_none()).then_some(Kind::Specimen))
}

/// Whether a column is of a test with oscillations: storage and loss moduli, E' and G'', frequencies.
fn is_dynamic(title: &str, words: &[String]) -> bool {
    let primed = |modulus: char| {
        let mut signs = title.trim_start_matches(['"', ' ']).chars();
        signs.next() == Some(modulus)
            && signs.next().is_some_and(|c| matches!(c, '\'' | '’' | '′' | '″' | '`' | '"' | '*'))
    };
    primed('E')
        || primed('G')
        || words.iter().any(|word| {
            ["tan", "omega", "ω"].contains(&word.as_str())
                || ["stor", "loss", "freq", "tand"].iter().any(|part| word.starts_with(part))
        })
}

/// Whether one of `titles` is that of a test with oscillations.
pub fn are_dynamic<'a>(titles: impl IntoIterator<Item = &'a str>) -> bool {
    titles.into_iter().any(|title| {
        let hertz = |text: &str| matches!(text.trim().to_lowercase().as_str(), "hz" | "rad/s");
        let bracket = title.find(['[', '(']).zip(title.rfind([']', ')'])).filter(|(start, end)| start < end);
        is_dynamic(title, &words_of(title)) || bracket.is_some_and(|(start, end)| hertz(&title[start + 1..end]))
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
    let sigma_c =
        words.first().is_some_and(|word| word == "sigma" || word == "σ") && words.get(1).is_some_and(|w| w == "c");
    let current = has(&["true", "log", "hencky", "cauchy", "wahr"]) && !has(&["green"])
        || sigma_c
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
            ("sigma_c_data_MPa", Stress, Some(1e6), Some(Measure::True)),
            ("Beschleunigung [g]", Acceleration, Some(9.80665), None),
            ("Acc_z (m/s^2)", Acceleration, Some(1.0), None),
            ("a [g]", Acceleration, Some(9.80665), None),
            ("11HEAD0000H3ACXA [g]", Acceleration, Some(9.80665), None),
            ("11FEMRLE00H3FOZP (kN)", Force, Some(1e3), None),
            ("Fuerza [kgf]", Force, Some(9.80665), None),
            ("Carga (lbf)", Force, Some(4.4482216152605), None),
            ("Temps (ms)", Time, Some(1e-3), None),
            ("Tiempo [s]", Time, Some(1.0), None),
            ("Déplacement (mm)", Displacement, Some(1e-3), None),
            ("Prüfzeit [s]", Time, Some(1.0), None),
            ("2nd Piola-Kirchhoff stress [Pa]", Stress, Some(1.0), Some(Measure::Lagrange)),
            ("Calibrated force [N]", Force, Some(1.0), None),
            ("Workpiece force [kN]", Force, Some(1e3), None),
            ("Temperature corrected force [N]", Force, Some(1.0), None),
            ("Force model 9301B [N]", Force, Some(1.0), None),
            ("Force CI [N]", Force, Some(1.0), None),
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
            "E' [MPa]",
            "G''",
            "stress fit [kPa]",
            "sigma_c_fit_MPa",
            "X_Value",
            "Angular acceleration [rad/s]",
            "Dehngeschwindigkeit [1/s]",
            "Prüfraumtemperatur [°C]",
            "Work [J]",
        ] {
            assert_eq!(Column::recognise(0, title), Ok(None), "{title}");
        }
        for title in [
            "Force [kN] [N]",
            "Elongation",
            "Almansi strain",
            "stress [mm]",
            "engineering true strain",
            "Force [g/cm]",
            "Force [V]",
        ] {
            assert!(Column::recognise(0, title).is_err(), "{title}");
        }
    }
}
